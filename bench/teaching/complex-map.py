# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/complex-map.bx.
from manim import *

config.background_color = "#0e1526"


class ComplexMap(Scene):
    def construct(self):
        power = ValueTracker(1)
        axes = Axes(x_range=[-4, 4], y_range=[-2, 2], x_length=14, y_length=7)

        def curve(z, u_range, color):
            def point(u):
                w = z(u) ** power.get_value() if z(u) else 0
                return axes.c2p(w.real, w.imag)

            return ParametricFunction(point, t_range=u_range, color=color)

        grid = always_redraw(
            lambda: VGroup(
                *[curve(lambda u: complex(0.2 * k, u), [-1, 1], BLUE) for k in range(6)],
                *[curve(lambda u: complex(u, 0.2 * k), [0, 1], YELLOW) for k in range(-5, 6)],
            )
        )
        z = MathTex("z", font_size=72).to_corner(UL)
        f = MathTex("z", r"\mapsto z^2", font_size=72).move_to(z, LEFT)
        self.add(axes, grid, z)
        self.wait()
        self.play(TransformMatchingTex(z, f))
        self.play(power.animate.set_value(2), run_time=6)
        self.wait(2)
