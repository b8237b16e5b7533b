# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/eigenvectors.bx.
from manim import *

config.background_color = "#0e1526"


class Eigenvectors(Scene):
    def construct(self):
        m = np.array([[2, 1], [1, 2]])
        plane = NumberPlane(x_range=[-13, 13], y_range=[-9, 9])
        lines = VGroup(*[DashedLine(-9 * d, 9 * d, color=YELLOW) for d in (UR, UL)])
        tips = [1.2 * np.array([np.cos(a), np.sin(a), 0]) for a in np.arange(16) * TAU / 16]

        def arrows(images, **style):
            return VGroup(*[Arrow(ORIGIN, tip, buff=0, **style) for tip in images])

        before = arrows(tips, color=GREY_D)
        vectors = arrows(tips, color=BLUE_B)
        after = arrows([[*(m @ tip[:2]), 0] for tip in tips], color=BLUE_B)
        for group in (vectors, after):
            for k in (2, 6, 10, 14):
                group[k].set_color(YELLOW)
        matrix = Matrix(m).add_background_rectangle(buff=0.2).to_corner(UL)
        three = MathTex(r"\times 3", color=YELLOW).next_to(after[2].get_end(), RIGHT)
        one = MathTex(r"\times 1", color=YELLOW).next_to(after[6].get_end(), UP)
        self.add(plane, lines, before, vectors, matrix)
        self.wait()
        self.play(ApplyMatrix(m, plane), Transform(vectors, after), run_time=5)
        self.play(Write(one), Write(three))
        self.wait(3)
