# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/pythagoras.bx.
from manim import *

config.background_color = "#0e1526"


class Pythagoras(Scene):
    def construct(self):
        a, b = 2.2, 3.6
        s = a + b
        corner = np.array([-6.3, -2.9, 0])

        def at(x, y):
            return corner + [x, y, 0]

        floor = Square(s, color=YELLOW, fill_opacity=1).move_to(at(s / 2, s / 2))
        triangles = [
            Polygon(ORIGIN, [b, 0, 0], [0, a, 0], color=BLUE_D, fill_opacity=1, stroke_color=BLACK)
            .rotate(k * PI / 2, about_point=ORIGIN)
            .shift(at(*place))
            for k, place in enumerate([(0, 0), (s, 0), (s, s), (0, s)])
        ]
        names = VGroup(
            MathTex("a").move_to(at(-0.35, a / 2)),
            MathTex("b").move_to(at(b / 2, -0.35)),
            MathTex("c").move_to(at(b / 2 - 0.3, 0.6)),
        )
        a2, b2, c2 = [
            MathTex(f"{n}^2", font_size=64, color=BLACK).move_to(at(*p))
            for n, p in (("a", (b + a / 2, a / 2)), ("b", (b / 2, a + b / 2)), ("c", (s / 2, s / 2)))
        ]
        f = MathTex("c^2", font_size=72, color=YELLOW).move_to([1.8, 0, 0])
        full = MathTex("c^2", "=", "a^2", "+", "b^2", font_size=72, color=YELLOW).move_to(f, LEFT)
        self.add(floor, *triangles, names, c2, f)
        self.wait()
        self.play(FadeOut(c2), run_time=0.5)
        self.play(triangles[2].animate.shift([b - s, a - s, 0]), run_time=1.5)
        self.wait(0.5)
        self.play(triangles[3].animate.shift([b, 0, 0]), run_time=1.5)
        self.wait(0.5)
        self.play(triangles[1].animate.shift([0, a, 0]), run_time=1.5)
        self.play(FadeIn(a2, b2), run_time=0.5)
        self.play(TransformMatchingTex(f, full))
        self.wait(1.5)
