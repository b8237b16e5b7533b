# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/pendulum-phase.bx.
from manim import *

config.background_color = "#0e1526"


class PendulumPhase(Scene):
    def construct(self):
        axes = Axes(x_range=[-3, 3], y_range=[-6, 6, 2], x_length=6.6, y_length=6.2, axis_config={"include_numbers": True})
        axes.shift(2.3 * RIGHT)
        labels = axes.get_axis_labels(Text("angle", font_size=28), Text("speed", font_size=28))
        state = [2.9, 0]

        def swing(_, dt):
            for _ in range(8):
                angle, speed = state
                state[:] = angle + speed * dt / 8, speed + (-6 * np.sin(angle) - 0.2 * speed) * dt / 8

        pin = np.array([-4.4, 0, 0])

        def pendulum():
            bob = pin + 2.3 * np.array([np.sin(state[0]), -np.cos(state[0]), 0])
            return VGroup(Line(pin, bob, color=GREY_B, stroke_width=6), Dot(bob, radius=0.3, color=YELLOW), Dot(pin, color=GREY_B))

        dot = Dot(axes.c2p(*state), radius=0.12, color=YELLOW).add_updater(lambda m: m.move_to(axes.c2p(*state)))
        orbit = TracedPath(dot.get_center, stroke_color=BLUE, stroke_width=5)
        self.add(Mobject().add_updater(swing), axes, labels, always_redraw(pendulum), orbit, dot)
        self.wait(12)
