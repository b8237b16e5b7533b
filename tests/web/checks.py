# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Counts the checks of a test of pages: check(what, whether) and same(what, is, wanted). done() prints the counts.
import os, sys

sys.path.append(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from timed import timed

passed = failed = 0


def check(what, good, found=""):
    global passed, failed
    timed(what)
    passed, failed = passed + bool(good), failed + (not good)
    if not good:
        print(f"FAILED {what}{': ' if found != '' else ''}{found}")
    return good


def same(what, found, wanted):
    return check(what, found == wanted, f"{found!r} instead of {wanted!r}")


def done():
    print(f"{passed} passed, {failed} failed")
    sys.exit(failed > 0)
