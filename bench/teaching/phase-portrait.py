# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/phase-portrait.bx.
from manim import *

config.background_color = "#0e1526"


class PhasePortrait(Scene):
    def construct(self):
        axes = Axes(x_range=[-8, 8, 2], y_range=[-4, 4, 2], x_length=11.2, y_length=6.6, axis_config={"include_numbers": True})
        labels = axes.get_axis_labels(Text("angle", font_size=28), Text("speed", font_size=28))

        def rate(x, y):
            return y, -np.sin(x) - 0.2 * y

        field = ArrowVectorField(
            lambda p: axes.c2p(*rate(*axes.p2c(p))) - axes.c2p(0, 0),
            x_range=[-5.6, 5.6, 0.5], y_range=[-3.3, 3.3, 0.5], colors=[BLUE_E]
        )

        def flow(dot, dt):
            x, y = axes.p2c(dot.get_center())
            for _ in range(12):
                u, v = rate(x, y)
                x, y = x + u * dt / 6, y + v * dt / 6
            dot.move_to(axes.c2p(x, y))

        self.add(axes, labels, field)
        for k, start in enumerate([(-8, 3.6), (-8, 2), (8, -3.6), (8, -2), (-3, 0.1), (3, -0.1)]):
            color = [BLUE, YELLOW][k % 2]
            dot = Dot(axes.c2p(*start), radius=0.12, color=color).add_updater(flow)
            self.add(TracedPath(dot.get_center, stroke_color=color, stroke_width=5), dot)
        self.wait(12)
