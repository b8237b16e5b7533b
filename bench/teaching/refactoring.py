# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/refactoring.bx.
from manim import *

config.background_color = "#0e1526"

FIRST = """def price(order):
    total = 0
    for item in order.items:
        if item.count > 10:
            total += 0.9 * item.count * item.price
        else:
            total += item.count * item.price
    return total"""
COST = """def cost(item):
    bulk_discount = 0.9 if item.count > 10 else 1
    return bulk_discount * item.count * item.price

def price(order):
"""
SECOND = COST + """    total = 0
    for item in order.items:
        total += cost(item)
    return total"""
THIRD = COST + "    return sum(map(cost, order.items))"


class Refactoring(Scene):
    def construct(self):
        def block(text):
            code = Code(code_string=text, language="python", paragraph_config={"font_size": 22})
            return code.to_edge(LEFT, buff=0.2)

        def mark(code, first, last):
            lines = code.code_lines[first - 1 : last]
            sheet = Rectangle(width=code.width, height=lines.height + 0.1, stroke_width=0, color=BLUE, fill_opacity=0.25)
            return sheet.move_to(lines).set_x(code.get_x())

        codes = [block(text) for text in (FIRST, SECOND, THIRD)]
        self.play(FadeIn(codes[0].background), FadeIn(codes[0].line_numbers), AddTextLetterByLetter(codes[0].code_lines))
        self.wait()
        sheet = mark(codes[0], 5, 7)
        line = Line(ORIGIN, 0.6 * RIGHT, stroke_width=2).next_to(codes[0], RIGHT, buff=0.05)

        def word(text):
            return Text(text, font_size=22, color=YELLOW).next_to(line, RIGHT, buff=0.1)

        words = [word(text) for text in ("said twice", "said once", "a sum")]
        self.play(FadeIn(sheet), Create(line), FadeIn(words[0]), run_time=0.5)
        self.wait(1.5)
        self.play(FadeOut(sheet), run_time=0.5)

        def turn(old, new):
            return [
                Transform(codes[0].background, new.background),
                FadeTransform(old.line_numbers, new.line_numbers),
                TransformMatchingShapes(old.code_lines, new.code_lines),
            ]

        self.play(*turn(codes[0], codes[1]), TransformMatchingShapes(words[0], words[1]))
        self.wait()
        sheet = mark(codes[1], 6, 9)
        self.play(FadeIn(sheet), TransformMatchingShapes(words[1], words[2]))
        self.wait()
        self.play(*turn(codes[1], codes[2]), Transform(sheet, mark(codes[2], 6, 6)))
        self.play(FadeOut(sheet), run_time=0.5)
        self.wait(1.5)
