# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""What the benchmarks that start programs share."""
import resource
import subprocess


def processor_time(words, folder, stderr=subprocess.PIPE):
    """Runs a program. Returns the seconds of processor time of all its threads, and its output."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(words, cwd=folder, check=True, stdout=subprocess.PIPE, stderr=stderr)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done.stdout
