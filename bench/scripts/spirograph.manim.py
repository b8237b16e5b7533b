# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: a pen in a wheel that rolls inside a ring, and what it draws, as examples/spirograph.bx.
from manim import *


class Spirograph(Scene):
    def construct(self):
        R, r = 3.4, 3.4 / 2.6
        angle = ValueTracker(0)

        def centre():
            a = angle.get_value()
            return (R - r) * np.array([np.cos(a), np.sin(a), 0])

        def pen_place():
            a = -angle.get_value() * (2.6 - 1)
            return centre() + np.array([np.cos(a), np.sin(a), 0])

        ring = Annulus(inner_radius=R, outer_radius=R + 0.1, color="#444455")
        wheel = Circle(radius=r, color="#334455", fill_opacity=0.6)
        wheel.add_updater(lambda m: m.move_to(centre()))
        pen = Dot(radius=0.07, color=GOLD)
        pen.add_updater(lambda m: m.move_to(pen_place()))
        drawn = TracedPath(pen.get_center, stroke_color=RED, stroke_width=4)
        self.add(ring, wheel, drawn, pen)
        self.play(angle.animate.set_value(5 * TAU), run_time=10, rate_func=linear)
