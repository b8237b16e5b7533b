# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/linear-map.bx.
from manim import *

config.background_color = "#0e1526"


class LinearMap(LinearTransformationScene):
    def __init__(self, **kwargs):
        super().__init__(show_coordinates=False, leave_ghost_vectors=False, **kwargs)

    def construct(self):
        self.add_unit_square(color=YELLOW, opacity=0.6)

        def numbers():
            m = np.array([self.i_hat.get_end()[:2], self.j_hat.get_end()[:2]]).T
            matrix = DecimalMatrix(m, element_to_mobject_config={"num_decimal_places": 1}).set_column_colors(GREEN, RED)
            area = Text(f"area = {np.linalg.det(m):.1f}", font_size=36, color=YELLOW).next_to(matrix, DOWN)
            return VGroup(matrix, area).add_background_rectangle(buff=0.3).to_corner(UR)

        self.add_foreground_mobject(always_redraw(numbers))
        now = np.identity(2)
        for then in [[2, 0], [0.5, 1]], [[2, -0.5], [0.5, 1.5]], [[1, -2], [0.5, -1]]:
            self.wait()
            self.apply_matrix(np.array(then) @ np.linalg.inv(now), run_time=2)
            now = np.array(then)
        self.wait(1.5)
