# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/riemann-sums.bx.
from manim import *

config.background_color = "#0e1526"


class RiemannSums(Scene):
    def construct(self):
        def f(x):
            return x**2 / 6 + 0.5

        axes = Axes(x_range=[0, 5], y_range=[0, 4], x_length=7, y_length=6, axis_config={"include_numbers": True}).to_edge(LEFT)
        curve = axes.plot(f, x_range=[0, 4.58], color=YELLOW)
        n = ValueTracker(4)
        rectangles = always_redraw(
            lambda: axes.get_riemann_rectangles(
                curve, x_range=[1, 4], dx=3 / int(n.get_value()), color=BLUE, stroke_width=4 / n.get_value()
            )
        )
        whole = MathTex(r"\int_1^4 \frac{x^2}{6} + \frac12 \, dx", color=YELLOW).move_to([4.2, 1.2, 0])
        full = MathTex(r"\int_1^4 \frac{x^2}{6} + \frac12 \, dx", "= 5", color=YELLOW).move_to(whole, LEFT)

        def area():
            k = int(n.get_value())
            return sum(f(1 + 3 * j / k) * 3 / k for j in range(k))

        texts = always_redraw(
            lambda: VGroup(
                Text(f"{int(n.get_value())} rectangles", font_size=36),
                Text(f"area = {area():.3f}", font_size=36),
            ).arrange(DOWN, aligned_edge=LEFT).set_color(BLUE).next_to(whole, DOWN, buff=0.5)
        )
        self.add(axes, rectangles, curve, texts)
        self.play(Write(whole))
        for k in (8, 16, 32):
            self.wait(1.5)
            n.set_value(k)
        self.play(n.animate.set_value(300), run_time=3, rate_func=rush_into)
        self.play(TransformMatchingTex(whole, full))
        self.wait()
