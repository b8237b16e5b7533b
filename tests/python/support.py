# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Helpers of the tests."""

import json
import os
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = os.environ["BETWIXT_PROGRAM"]


def example(name):
    return os.path.join(ROOT, "examples", name)


def said_by_program(file, times, targets=()):
    """Returns the values that `betwixt eval --json` prints: a dict for each time."""
    out = subprocess.run([PROGRAM, "eval", file, "--at", ",".join(times), "--json", *targets],
                         capture_output=True, text=True, check=True)
    return [t["values"] for t in json.loads(out.stdout)["times"]]
