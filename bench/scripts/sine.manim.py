# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: a hand turns, and its height is drawn as the time goes by, as examples/sine.bx.
from manim import *


class Sine(Scene):
    def construct(self):
        middle = np.array([-5, 0, 0])
        time = ValueTracker(0)

        def height():
            return 2 * np.sin(time.get_value() / 6 * 2 * TAU)

        clock = Circle(radius=2, color="#556677", stroke_width=3).move_to(middle)
        level = Line([-7.2, 0, 0], [7.2, 0, 0], color="#556677", stroke_width=2)
        hand = Arrow(middle, middle + 2 * RIGHT, buff=0, color=GOLD)
        hand.add_updater(
            lambda m: m.put_start_and_end_on(
                middle,
                middle + [2 * np.cos(time.get_value() / 6 * 2 * TAU), height(), 0],
            )
        )
        dot = Dot(radius=0.1, color=RED)
        dot.add_updater(lambda m: m.move_to([-2.5 + 1.5 * time.get_value(), height(), 0]))
        wave = TracedPath(dot.get_center, stroke_color=RED, stroke_width=5)
        names = VGroup(
            Text("angle", font_size=28).move_to([-5, -2.7, 0]),
            Text("its sine", font_size=28).move_to([1.5, 2.4, 0]),
            Text("time", font_size=28).move_to([6.6, -0.5, 0]),
        ).set_color("#aabbcc")
        self.add(clock, level, wave, hand, dot, names)
        self.play(time.animate.set_value(6), run_time=6, rate_func=linear)
