# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/unit-circle.bx.
from manim import *

config.background_color = "#0e1526"


class UnitCircle(Scene):
    def construct(self):
        angle = ValueTracker(0)
        left = Axes(x_range=[-1, 1], y_range=[-1, 1], x_length=4.4, y_length=4.4).shift(4.4 * LEFT)
        right = Axes(x_range=[0, TAU, PI / 2], y_range=[-1, 1], x_length=6.6, y_length=4.4, y_axis_config={"include_numbers": True})
        right.shift(2.6 * RIGHT)
        right.x_axis.add_labels({PI: MathTex(r"\pi"), TAU: MathTex(r"2\pi")})
        circle = Circle(2.2, color=GREY).move_to(left.c2p(0, 0))
        sine = always_redraw(lambda: right.plot(np.sin, x_range=[0, max(angle.get_value(), 0.01)], color=YELLOW))
        cosine = always_redraw(lambda: right.plot(np.cos, x_range=[0, max(angle.get_value(), 0.01)], color=BLUE))

        def legs():
            a = angle.get_value()
            p, end = left.c2p(np.cos(a), np.sin(a)), right.c2p(a, np.sin(a))
            foot = left.c2p(np.cos(a), 0)
            return VGroup(
                Line(left.c2p(0, 0), foot, color=BLUE, stroke_width=7),
                Line(foot, p, color=YELLOW, stroke_width=7),
                DashedLine(p, end, color=YELLOW, stroke_width=2),
                Dot(p, radius=0.12, color=YELLOW),
                Dot(end, radius=0.12, color=YELLOW),
            )

        names = VGroup(
            Text("sine", font_size=32, color=YELLOW).move_to(right.c2p(PI / 2, 1.2)),
            Text("cosine", font_size=32, color=BLUE).move_to(right.c2p(TAU, 1.2)),
        )
        self.add(left, right, circle, sine, cosine, always_redraw(legs), names)
        self.wait(0.5)
        self.play(angle.animate.set_value(TAU), run_time=8.5, rate_func=linear)
        self.wait()
