# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# video_numbers.py FOLDER: prints the numbers that the pictures of a folder show, 8 columns of bits each.
import os
import subprocess
import sys


def number(path):
    raw = subprocess.run(["ffmpeg", "-v", "error", "-i", path, "-vf", "scale=8:1:flags=area", "-pix_fmt", "gray",
                          "-f", "rawvideo", "-"], capture_output=True, check=True).stdout
    return sum(1 << k for k in range(8) if raw[k] > 127)


print(*(number(os.path.join(sys.argv[1], name)) for name in sorted(os.listdir(sys.argv[1]))))
