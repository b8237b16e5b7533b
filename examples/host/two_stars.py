# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Two stars turn in opposite directions while the scene they are in drifts; then this program ends, and they go on.

    betwixt serve --socket /tmp/stage.sock --to window &
    PYTHONPATH=clients/python python3 examples/host/two_stars.py /tmp/stage.sock
"""
import sys
from math import cos, pi, sin

from betwixt_client import Host, rotate_z, translate

with Host(sys.argv[1]) as host:
    drift, left, right = (host.make_environment() for _ in range(3))
    with host.object() as star:
        host.polygon([((1 - k % 2 * 0.6) * sin(k * pi / 5), (1 - k % 2 * 0.6) * cos(k * pi / 5), 0) for k in range(10)])
    with host.object() as sky:
        host.view((0, 0, 12), (0, 0, 0))
        with host.environment(drift):
            for spin, x, color in (left, -2, (1, 0.8, 0.3)), (right, 2, (1, 0.5, 0.3)):
                with host.matrix(translate(x, 0, 0)), host.environment(spin):
                    host.color(*color)
                    host.call_object(star)
    host.start(sky)
    host.animate(drift, 1, translate(0.01, 0.004, 0))
    host.animate(left, 1, rotate_z(0.05))
    host.animate(right, 1, rotate_z(-0.08))
