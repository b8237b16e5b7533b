# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Manim: the film of examples/dijkstra.bx.
from manim import *

config.background_color = "#0e1526"


class Dijkstra(Scene):
    def construct(self):
        weights = {
            ("A", "B"): 4, ("A", "C"): 2, ("C", "B"): 1, ("B", "D"): 5,
            ("C", "E"): 10, ("D", "E"): 2, ("D", "F"): 6, ("E", "F"): 5,
        }  # fmt: skip
        places = {"A": (-6, 0), "B": (-2.4, 2.4), "C": (-2.4, -2.4), "D": (2.4, 2.4), "E": (2.4, -2.4), "F": (6, 0)}
        graph = Graph(
            list(places),
            list(weights),
            labels=True,
            layout={name: [x, y, 0] for name, (x, y) in places.items()},
            vertex_config={"radius": 0.55, "fill_color": BLUE_E, "stroke_color": BLUE, "stroke_width": 3},
            edge_config={"stroke_width": 4, "stroke_color": GREY},
        )
        self.add(graph)
        for edge, weight in weights.items():
            line = graph.edges[edge]
            side = 0.3 * rotate_vector(line.get_unit_vector(), PI / 2)
            self.add(Text(str(weight), font_size=26).move_to(line.get_center() + side))

        def far(name, text):
            side = DOWN if name in "CE" else UP
            return Text(text, font_size=34, color=YELLOW).next_to(graph.vertices[name], side)

        labels = {name: far(name, "0" if name == "A" else "∞") for name in places}
        self.add(*labels.values())
        self.wait(0.5)
        far_away = 99
        best = {name: 0 if name == "A" else far_away for name in places}
        before, left = {}, set(places)
        while left:
            nearest = min(left, key=best.get)
            left.remove(nearest)
            self.play(graph.vertices[nearest].animate.set_fill(GREEN_E), run_time=0.5)
            changes = []
            for (a, b), weight in weights.items():
                if nearest not in (a, b):
                    continue
                other = b if nearest == a else a
                if other in left and best[nearest] + weight < best[other]:
                    best[other], before[other] = best[nearest] + weight, nearest
                    changes.append(Transform(labels[other], far(other, str(best[other]))))
            if changes:
                self.play(*changes, run_time=0.5)
            self.wait(0.5)
        way = ["F"]
        while way[0] != "A":
            way.insert(0, before[way[0]])
        for edge in zip(way, way[1:]):
            line = graph.edges[edge if edge in graph.edges else edge[::-1]]
            self.play(line.animate.set_stroke(YELLOW, 10), run_time=0.5)
        self.wait(1.5)
