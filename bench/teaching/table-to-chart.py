# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/table-to-chart.bx.
from manim import *

config.background_color = "#0e1526"


class TableToChart(Scene):
    def construct(self):
        cities, days = ["Berlin", "Madrid", "Oslo", "Paris", "Rome"], [106, 63, 113, 111, 78]
        table = Table(
            [[city, str(n)] for city, n in zip(cities, days)],
            col_labels=[Text("city", color=BLUE), Text("rainy days", color=BLUE)],
            include_outer_lines=True
        ).scale(0.55).to_edge(LEFT)
        table.get_vertical_lines().set_opacity(0)
        chart = BarChart(
            days, bar_names=cities, y_range=[0, 120, 20], x_length=7.5, y_length=6,
            bar_colors=[BLUE, ORANGE, GREEN, RED, PURPLE], bar_fill_opacity=1
        ).to_edge(RIGHT)
        chart.remove(chart.axes)
        labels, numbers = chart.x_axis.labels, chart.get_bar_labels(font_size=32)
        self.add(table)
        self.wait(0.5)
        for k in range(5):
            self.play(
                GrowFromEdge(chart.bars[k], DOWN),
                ReplacementTransform(table.get_entries((k + 2, 1)), labels[k]),
                ReplacementTransform(table.get_entries((k + 2, 2)), numbers[k]),
                run_time=1.25
            )
            self.wait(0.25)
        everything = VGroup(chart.bars, labels, numbers)
        self.play(FadeOut(table), everything.animate.move_to(ORIGIN), run_time=1.5)
        self.wait(1.5)
