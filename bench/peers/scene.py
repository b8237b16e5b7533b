# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# The numbers of bench/scenes.h.
FUNCTIONS, KEYS = 3, 60


def scramble(n):
    n &= 0xffffffff
    n = (n ^ n >> 16) * 0x7feb352d & 0xffffffff
    n = (n ^ n >> 15) * 0x846ca68b & 0xffffffff
    return n ^ n >> 16


def anything(k, f, key, which):
    return scramble(((k * FUNCTIONS + f) * KEYS + key) * 4 + which)


def frame_of(shared, k, f, key):
    even = 1 + 10 * key
    return even if shared or key in (0, KEYS - 1) else even + anything(k, f, key, 3) % 80 / 10 - 4


def value_of(k, f, key):
    """Rotations in degrees."""
    def number(which, below):
        return anything(k, f, key, which) % below
    if f == 1:
        return number(0, 360), number(1, 360), number(2, 360)
    return number(0, 900) / 100, number(1, 900) / 100, 1 + number(2, 900) / 100


def frames_of(row, count):
    if row == "random":
        return [1 + scramble(1000000 + k) % 5990 / 10 for k in range(count)]
    return [2 + k for k in range(count)]


def million_key(k, f):
    return k * 0.25, (k * 37 + f * 101) % 2001 * 0.01, f % 50 * 0.5
