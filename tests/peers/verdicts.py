# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Counts what the scripts of this folder check."""
import sys

passed = failed = 0


def verdict(good, words):
    global passed, failed
    if good: passed += 1
    else:
        failed += 1
        print("FAILED", words)


def done():
    print(f"{passed} passed, {failed} failed")
    sys.exit(failed != 0)
