# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of this folder within Blender, and prints how many passed."""

import os
import sys
import unittest

HERE = os.path.dirname(os.path.abspath(__file__))
CLIENTS = os.path.join(HERE, "..", "..", "clients")
sys.path[:0] = [HERE, os.path.dirname(HERE), os.path.join(CLIENTS, "blender"), os.path.join(CLIENTS, "python")]

from timed import TimedResult  # noqa: E402


def main():
    loader = unittest.TestLoader()
    named = sys.argv[sys.argv.index("--") + 1:]
    tests = loader.loadTestsFromNames(named) if named else loader.discover(HERE, "*_test.py", HERE)
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=0, resultclass=TimedResult).run(tests)
    failed = len(result.failures) + len(result.errors)
    for test, why in result.skipped:
        print(f"left out: {test}: {why}")
    print(f"{result.testsRun - failed - len(result.skipped)} passed, {failed} failed", flush=True)
    return failed > 0 or result.testsRun == 0


sys.exit(main())
