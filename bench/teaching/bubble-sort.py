# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/bubble-sort.bx.
from manim import *

config.background_color = "#0e1526"


class BubbleSort(Scene):
    def construct(self):
        def bar(value):
            box = RoundedRectangle(width=1.2, height=0.85 * value, corner_radius=0.1, color=BLUE, fill_opacity=1)
            number = Text(str(value), font_size=36, weight=BOLD, color=BLACK).move_to(box.get_bottom() + 0.4 * UP)
            return VGroup(box, number)

        values = [5, 2, 7, 3, 6, 1, 4]
        bars = [bar(v) for v in values]
        VGroup(*bars).arrange(RIGHT, buff=0.35, aligned_edge=DOWN)
        self.add(*bars)
        self.wait(0.5)
        for last in range(6, 0, -1):
            for k in range(last):
                a, b = bars[k], bars[k + 1]
                a[0].set_color(YELLOW)
                b[0].set_color(YELLOW)
                if values[k] > values[k + 1]:
                    self.play(a.animate.set_x(b.get_x()), b.animate.set_x(a.get_x()), run_time=0.5)
                    values[k], values[k + 1] = values[k + 1], values[k]
                    bars[k], bars[k + 1] = b, a
                else:
                    self.wait(0.5)
                a[0].set_color(BLUE)
                b[0].set_color(BLUE)
            bars[last][0].set_color(GREEN)
        bars[0][0].set_color(GREEN)
        self.wait()
