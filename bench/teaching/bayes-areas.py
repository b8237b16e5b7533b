# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/bayes-areas.bx.
from manim import *

config.background_color = "#0e1526"


class BayesAreas(Scene):
    def construct(self):
        s = 5.2
        corner = np.array([-6, -3.4, 0])

        def part(x, y, width, height, color):
            box = Rectangle(width=width * s, height=height * s, fill_color=color, fill_opacity=1, stroke_width=0)
            return box.move_to(corner + [x * s, y * s, 0], DL)

        rain, dry = part(0, 0, 0.3, 1, BLUE_D), part(0.3, 0, 0.7, 1, GOLD_D)
        clouds1, clouds2 = part(0, 0, 0.3, 0.9, BLUE_D), part(0.3, 0, 0.7, 0.4, GOLD_D)
        share1, share2 = part(1.4, 0.28 / 0.55, 0.55, 0.27 / 0.55, BLUE_D), part(1.4, 0, 0.55, 0.28 / 0.55, GOLD_D)
        size = {"font_size": 28}
        heads = VGroup(Text("rain 30 %", **size).next_to(rain, UP), Text("dry 70 %", **size).next_to(dry, UP))
        labels = VGroup(Text("clouds\n90 %", **size).move_to(clouds1), Text("clouds 40 %", **size).move_to(clouds2))
        shares = VGroup(Text("49 %").move_to(share1), Text("51 %").move_to(share2))
        rule = MathTex(r"\frac{0.3 \cdot 0.9}{0.3 \cdot 0.9 + 0.7 \cdot 0.4} = 0.49").next_to(share1, UP)
        self.add(rain, dry, clouds1, clouds2, heads)
        self.wait()
        self.play(VGroup(rain, dry).animate.set_opacity(0.2), FadeIn(labels))
        self.wait(1.5)
        self.play(Transform(clouds1, share1), Transform(clouds2, share2), run_time=2)
        self.play(FadeIn(shares), run_time=0.5)
        self.play(Write(rule))
        self.wait(2.5)
