# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: a chart whose bars grow one after another, a little too far and back, as examples/bars.bx.
from manim import *


class Bars(Scene):
    def construct(self):
        self.camera.background_color = "#10202c"
        chart = BarChart(
            values=[1.2, 2.4, 1.9, 3.1, 2.7, 4],
            y_range=[0, 5, 1],
            x_length=8.4,
            y_length=5,
            bar_colors=[TEAL_B, BLUE_D],
        )
        chart.y_axis.set_opacity(0)
        title = Text("Apples, by month", font_size=36).next_to(chart, DOWN)
        self.add(chart.x_axis, title)
        self.play(
            LaggedStart(
                *[GrowFromEdge(bar, DOWN, rate_func=rate_functions.ease_out_back) for bar in chart.bars],
                lag_ratio=0.25,
                run_time=2.5,
            )
        )
        self.wait()
