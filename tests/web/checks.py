# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Counts the checks of a test of pages: check(what, whether) and same(what, is, wanted). done() prints the counts.
# `player` is the player for pages, as it was built. there_is_a_player() leaves a test out if it was not built.
import os, sys

sys.path.append(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
from timed import timed

passed = failed = 0
root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
player = os.environ.get("BETWIXT_PLAYER", f"{root}/build/web/betwixt-player.js")


def there_is_a_player():
    if not os.path.exists(player):
        print("left out: what plays is not built (./betwixt web)\n0 passed, 0 failed")
        sys.exit()


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
