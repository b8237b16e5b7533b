# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Runs all or the named tests of this folder, and prints how many passed."""

import os
import sys
import unittest
import warnings

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.dirname(HERE))

from timed import TimedResult  # noqa: E402


def main() -> int:
    loader = unittest.TestLoader()
    named = sys.argv[1:]
    tests = loader.loadTestsFromNames(named) if named else loader.discover(HERE, "*_test.py", HERE)
    warnings.simplefilter("error")
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=0, resultclass=TimedResult).run(tests)
    failed = len(result.failures) + len(result.errors) + len(result.unexpectedSuccesses)
    for test, why in result.skipped:
        print(f"left out: {test}: {why}")
    print(f"{result.testsRun - failed - len(result.skipped)} passed, {failed} failed")
    return failed > 0 or result.testsRun == 0


sys.exit(main())
