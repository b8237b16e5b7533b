# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/inequalities.bx.
from manim import *

config.background_color = "#0e1526"


class Inequalities(Scene):
    def construct(self):
        line = NumberLine([-2, 9], length=12.5, include_numbers=True, include_tip=True).shift(0.8 * DOWN)
        two, five = line.n2p(2), line.n2p(5)
        up = 1.2 * UP
        more = Arrow(two + up, two + up + 5.8 * RIGHT, buff=0, color=BLUE, stroke_width=10)
        less = Arrow(five + 2 * up, five + 2 * up + 5.8 * LEFT, buff=0, color=YELLOW, stroke_width=10)
        both = Line(two, five, color=GREEN, stroke_width=14)

        def opened(point, color):
            return Circle(0.16, color=color, fill_color=config.background_color, fill_opacity=1).move_to(point)

        open1, closed1 = opened(two + up, BLUE), Dot(five + 2 * up, radius=0.2, color=YELLOW)
        open2, closed2 = opened(two, GREEN), Dot(five, radius=0.2, color=GREEN)
        drops = VGroup(DashedLine(two + up, two), DashedLine(five + 2 * up, five)).set_color(GREY)
        f1 = MathTex("x > 2", color=BLUE).next_to(open1, LEFT, buff=0.6)
        f2 = MathTex(r"x \le 5", color=YELLOW).next_to(closed1, RIGHT, buff=0.6)
        f3 = MathTex(r"2 < x \le 5", color=GREEN).next_to(both, DOWN, buff=1)
        self.add(line)
        self.play(Write(f1), Write(f2))
        self.play(GrowArrow(more), GrowFromCenter(open1))
        self.wait(0.5)
        self.play(GrowArrow(less), GrowFromCenter(closed1))
        self.wait(0.5)
        self.play(Create(drops), run_time=0.75)
        self.bring_to_front(open1, closed1)
        self.play(Create(both), FadeIn(open2, closed2))
        self.play(Write(f3))
        self.wait(2)
