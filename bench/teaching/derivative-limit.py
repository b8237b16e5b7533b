# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/derivative-limit.bx.
from manim import *

config.background_color = "#0e1526"


class DerivativeLimit(Scene):
    def construct(self):
        def f(x):
            return x**2 / 4

        axes = Axes(x_range=[0, 4], y_range=[0, 4], x_length=7.4, y_length=6, axis_config={"include_numbers": True}).to_edge(LEFT)
        curve = axes.plot(f, color=BLUE)
        h = ValueTracker(2)

        def secant():
            step = h.get_value()
            p, q = axes.c2p(2, f(2)), axes.c2p(2 + step, f(2 + step))
            corner = axes.c2p(2 + step, f(2))
            return VGroup(
                DashedLine(p, corner),
                DashedLine(corner, q),
                Line(p, q, color=YELLOW).set_length(6.5),
                Dot(p),
                Dot(q, color=YELLOW),
                MathTex("h", font_size=36).next_to((p + corner) / 2, DOWN).set_opacity(smooth(step)),
            )

        rule = MathTex(r"\frac{f(2+h)-f(2)}{h}").move_to([4.8, 1.8, 0])
        step = Variable(2, "h", num_decimal_places=2).next_to(rule, DOWN, buff=0.6)
        step.add_updater(lambda m: m.tracker.set_value(h.get_value()))
        slope = Variable(1.5, Text("slope"), num_decimal_places=2).set_color(YELLOW).next_to(step, DOWN)
        slope.add_updater(lambda m: m.tracker.set_value((f(2 + h.get_value()) - f(2)) / h.get_value()))
        self.add(axes, curve, always_redraw(secant), step, slope)
        self.play(Write(rule))
        self.play(h.animate.set_value(1), run_time=2)
        self.wait(1.5)
        self.play(h.animate.set_value(0.001), run_time=4)
        self.wait(1.5)
