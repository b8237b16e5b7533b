# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/gradient-descent.bx.
from manim import *

config.background_color = "#0e1526"


def hill(x, y):
    return 0.5 * np.sin(2 * x) * np.cos(1.5 * y) + 0.08 * (x**2 + y**2)


class GradientDescent(ThreeDScene):
    def construct(self):
        self.set_camera_orientation(phi=50 * DEGREES, theta=-72 * DEGREES, zoom=0.9)
        axes = ThreeDAxes(
            x_range=(-3, 3), y_range=(-3, 3), z_range=(-1, 2), x_length=10, y_length=10, z_length=4.5
        )
        surface = Surface(
            lambda x, y: axes.c2p(x, y, hill(x, y)),
            u_range=(-3, 3),
            v_range=(-3, 3),
            resolution=(64, 64),
            fill_color=BLUE,
            checkerboard_colors=False,
            stroke_width=0,
        )
        self.add(surface)
        places = [np.array([i - 2.5, j - 2.5]) for j in range(6) for i in range(6)]

        def point(p):
            return axes.c2p(*p, hill(*p) + 0.06)

        balls = [Dot3D(point(p), radius=0.13, color=YELLOW) for p in places]
        ways = [TracedPath(ball.get_center, stroke_color=YELLOW, stroke_width=4) for ball in balls]
        self.add(*balls, *ways)

        def step(p):
            x, y, h = *p, 0.001
            slope = np.array([hill(x + h, y) - hill(x - h, y), hill(x, y + h) - hill(x, y - h)]) / (2 * h)
            return p - 0.08 * slope

        for _ in range(96):
            places = [step(p) for p in places]
            self.play(
                *[ball.animate.move_to(point(p)) for ball, p in zip(balls, places)], run_time=1 / 12, rate_func=linear
            )
