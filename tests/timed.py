# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Records how long checks take, for the list of the slowest that ./test prints."""

import os
import sys
import time
import unittest

_last = time.monotonic()


def timed(name):
    """Records the time since the last call under this name."""
    global _last
    now = time.monotonic()
    if os.environ.get("BETWIXT_TIMES"):
        with open(os.environ["BETWIXT_TIMES"], "a") as file:
            file.write(f"{now - _last:.3f}\t{os.path.basename(sys.argv[0])}: {name}\n")
    _last = now


class TimedResult(unittest.TextTestResult):
    def startTest(self, test):
        timed("between tests")
        super().startTest(test)

    def stopTest(self, test):
        super().stopTest(test)
        timed(test.id())
