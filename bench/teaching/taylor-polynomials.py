# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/taylor-polynomials.bx.
import math

from manim import *

config.background_color = "#0e1526"


class TaylorPolynomials(Scene):
    def construct(self):
        axes = Axes(x_range=[-10, 10, 2], y_range=[-2, 2], x_length=13, y_length=5, axis_config={"include_numbers": True}).to_edge(DOWN)
        sine = axes.plot(np.sin, color=GREY_B)
        colors = color_gradient([YELLOW, GREEN, BLUE], 7)
        formula = MathTex("x", *[rf"{'-+'[k % 2]} \frac{{x^{{{2*k+3}}}}}{{{2*k+3}!}}" for k in range(6)]).to_edge(UP)
        xs = np.linspace(-10, 10, 2001)
        self.add(axes, sine)
        previous = None
        for n in range(1, 8):
            def taylor(x):
                return sum((-1) ** k * x ** (2 * k + 1) / math.factorial(2 * k + 1) for k in range(n))

            inside = xs[abs(taylor(xs)) <= 2]
            graph = axes.plot(taylor, x_range=[inside[0], inside[-1]], color=colors[n - 1])
            formula[n - 1].set_color(colors[n - 1])
            dim = [previous.animate.set_stroke(opacity=0.25)] if previous else []
            self.play(Create(graph), FadeIn(formula[n - 1]), *dim, run_time=1.25)
            previous = graph
        self.wait(2)
