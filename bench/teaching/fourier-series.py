# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/fourier-series.bx.
from manim import *

config.background_color = "#0e1526"


class FourierSeries(Scene):
    def construct(self):
        terms = ValueTracker(1)
        axes = Axes(x_range=[-PI, 2 * PI, PI], y_range=[-1.5, 1.5, 0.5], x_length=13, y_length=5).to_edge(DOWN)

        def partial(x):
            n = terms.get_value()
            return 4 / PI * sum(
                min(1, n + 1 - k) * np.sin((2 * k - 1) * x) / (2 * k - 1) for k in range(1, int(n) + 2)
            )

        square = VGroup(
            *[axes.plot(lambda x: s, x_range=[a * PI, a * PI + PI], color=BLUE_D) for a, s in ((-1, -1), (0, 1), (1, -1))]
        )
        wave = always_redraw(lambda: axes.plot(partial, x_range=[-PI, 2 * PI, 0.01], color=YELLOW, stroke_width=6))
        f = MathTex(
            r"\frac4\pi\Big(", r"\sin x", "+", r"\frac{\sin 3x}{3}", "+", r"\frac{\sin 5x}{5}", "+",
            r"\frac{\sin 7x}{7}", "+", r"\cdots", r"\Big)", color=YELLOW
        ).to_edge(UP)
        for k in range(1, 5):
            f[2 * k + 1].add_updater(lambda m, k=k: m.set_opacity(0.2 + 0.8 * np.clip(terms.get_value() - k, 0, 1)))
        self.add(axes, square, wave, f)
        self.wait(0.5)
        for n in (2, 3, 4):
            self.play(terms.animate.set_value(n), run_time=1.5)
        self.play(terms.animate.set_value(9), run_time=4)
        self.wait(2)
