# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Makes the calls of aim_host.c in Python, in the same order. Both must give the same history."""
import sys

from betwixt_client import Host, Refused, rotate_z, translate

triangle = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]
eye, at = (0, 0, 10), (0, 0, 0)
with Host(sys.argv[1]) as a:
    star = a.make_object()
    a.color(1, 0.5, 0)
    tag = a.tag()
    a.polygon(triangle)
    a.push_matrix()
    a.multiply_matrix(translate(0, 0, 1))
    a.point(0, 0, 0)
    a.vector(eye, at)
    a.pop_matrix()
    a.text('say "spin"')
    a.close_object()
    spin, drift = a.make_environment(), a.make_environment()
    scene = a.make_object()
    a.view(eye, at)
    a.perspective(0.8)
    a.begin_environment(drift)
    a.begin_environment(spin)
    a.call_object(star)
    a.end_environment()
    a.end_environment()
    a.close_object()
    a.start(scene)
    a.animate(spin, 1, rotate_z(0.1))
    a.animate(drift, 3, translate(0.25, 0, 0))
    a.halt(drift)
    a.animate(spin, 2, rotate_z(0.2), change=1, period=30, ceiling=6, until=900, keep_phase=True)
    a.cancel(spin)
    a.edit_object(star)
    a.replace(tag)
    a.polygon(triangle)
    a.close_object()
    a.edit_object(star)
    a.point(1, 1, 1)
    a.animate(spin, 1, rotate_z(0.2))
    with a.bundle():
        a.point(2, 2, 2)
        a.halt(spin)
        a.kill(drift)
    a.point(3, 3, 3)
    a.replace(tag)
    a.cancel(spin)
    a.replace(tag)
    a.polygon(triangle)
    a.close_object()
    a.begin_bundle()
    a.halt(spin)
    a.halt(77)
    try:
        a.end_bundle()
    except Refused:
        pass
    a.delete_object(star)
