# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/binary-search.bx.
from manim import *

config.background_color = "#0e1526"


class BinarySearch(Scene):
    def construct(self):
        numbers = [3, 8, 12, 17, 21, 26, 30, 34, 41, 47, 53, 58, 66, 72, 89]

        def box(**style):
            return RoundedRectangle(width=0.8, height=1.1, corner_radius=0.1, **style)

        places = VGroup(*[box(color=BLUE_E, stroke_width=2) for _ in numbers]).arrange(RIGHT, buff=0.1)
        boxes = VGroup(
            *[
                VGroup(box(color=BLUE_D, fill_opacity=1), Text(str(n), font_size=28)).move_to(p)
                for n, p in zip(numbers, places)
            ]
        )
        arrow = Arrow(2 * UP, 0.8 * UP, color=YELLOW, buff=0)
        look = VGroup(arrow, Text("53?", font_size=44, color=YELLOW).next_to(arrow, UP))
        answer = None
        self.add(places, boxes, look)
        low, high = 0, len(numbers) - 1
        while True:
            middle = (low + high) // 2
            n = numbers[middle]
            text = Text(f"{n} {'<' if n < 53 else '>' if n > 53 else '='} 53", font_size=40, color=YELLOW)
            text.next_to(boxes[middle], DOWN, buff=0.5)
            self.play(
                look.animate.set_x(boxes[middle].get_x()), ReplacementTransform(answer, text) if answer else FadeIn(text)
            )
            answer = text
            if n == 53:
                break
            gone = boxes[low : middle + 1] if n < 53 else boxes[middle : high + 1]
            low, high = (middle + 1, high) if n < 53 else (low, middle - 1)
            self.play(FadeOut(gone), run_time=0.75)
        self.play(boxes[middle][0].animate.set_color(GREEN), run_time=0.5)
        self.wait(1.5)
