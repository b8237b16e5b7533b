# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/neural-network.bx.
from manim import *

config.background_color = "#0e1526"


class NeuralNetwork(Scene):
    def construct(self):
        night, lamp = ManimColor("#1a2947"), ManimColor("#ffc44d")
        i, j = np.indices((3, 3))
        random = np.random.default_rng(5)
        weights = [random.uniform(0, 1, (3, 3)) - 0.8 * abs(i - j) + 0.4 for _ in range(3)]
        layers = [
            VGroup(*[Circle(0.6, color=BLUE_E, fill_color=night, fill_opacity=1) for _ in range(3)])
            .arrange(DOWN, buff=1.1)
            .set_x(3 * k - 4.5)
            for k in range(4)
        ]
        edges = [
            VGroup(
                *[
                    Line(a.get_center(), b.get_center(), color=BLUE if w > 0 else RED, stroke_width=8 * abs(w))
                    for a, row in zip(left, matrix)
                    for b, w in zip(right, row)
                ]
            )
            for left, right, matrix in zip(layers, layers[1:], weights)
        ]
        self.add(*edges, *layers)
        for layer, side, words in (
            (layers[0], LEFT, ("whiskers", "bark", "wings")),
            (layers[3], RIGHT, ("cat", "dog", "bird")),
        ):
            for circle, word in zip(layer, words):
                self.add(Text(word, font_size=22).next_to(circle, side))

        def light(layer, levels):
            return [c.animate.set_fill(interpolate_color(night, lamp, v)) for c, v in zip(layer, levels)]

        self.wait(0.5)
        for levels in ([1, 0.2, 0], [0, 0.1, 1]):
            self.play(*light(layers[0], levels), run_time=0.5)
            for group, matrix, layer in zip(edges, weights, layers[1:]):
                dots = [Dot(line.get_start(), color=lamp, z_index=-1) for line in group]
                self.play(*[MoveAlongPath(dot, line) for dot, line in zip(dots, group)])
                self.remove(*dots)
                levels = np.clip(levels @ matrix, 0, 1)
                self.play(*light(layer, levels), run_time=0.5)
            self.wait(0.5)
