# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Compares two pictures (bytes of rgb). At most 1 in 100 pixels may differ. At edges each program blends pixels in its
# own way (Betwixt in linear light). So a pixel counts as equal if it lies between the darkest and the brightest
# neighbour of the same pixel in the other picture.
#   svg_pixels.py OURS THEIRS WIDTH
import sys

near = 8  # tolerance, of 255

ours, theirs = (open(name, "rb").read() for name in sys.argv[1:3])
width = int(sys.argv[3])
height = len(theirs) // (3 * width)
if len(ours) != len(theirs):
    sys.exit(f"{len(ours)} bytes and {len(theirs)}")
others = 0
for y in range(height):
    for x in range(width):
        at = 3 * (y * width + x)
        if all(abs(ours[at + c] - theirs[at + c]) <= near for c in range(3)):
            continue
        around = [3 * (v * width + u) for v in range(max(0, y - 1), min(height, y + 2))
                  for u in range(max(0, x - 1), min(width, x + 2))]
        for c in range(3):
            values = [theirs[a + c] for a in around]
            if not min(values) - near <= ours[at + c] <= max(values) + near:
                others += 1
                break
share = others / (width * height)
print("well" if share <= 0.01 else f"{100 * share:.2f} of 100 pixels are others")
if len(sys.argv) > 4:
    print(f"{100 * share:.3f} of 100")
