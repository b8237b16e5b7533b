# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Runs one share of the tests of a GoogleTest program, in one process.

    units.py PROGRAM [I/N] [--under=SECONDS:FILE] [GTEST-OPTION…]    the I-th of N shares; without I/N, all tests

--under leaves out the tests that took longer than SECONDS in an earlier run. FILE has its times: "SECONDS<tab>NAME".
If a test ends the process, the test counts as failed, and another process runs the rest of the share. Prints the output
of failed tests and a last line "N passed, N failed". Appends "SECONDS<tab>NAME" for each test to the file that the
variable BETWIXT_TIMES names.
"""

import os
import re
import signal
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
LONGEST = 600  # seconds for a share
# A test may write text without an end of line before a line of GoogleTest.
BEGINS = re.compile(r"\[ RUN      \] (\S+)$", re.M)
ENDS = re.compile(r"\[ +(OK|FAILED|SKIPPED) +\] (\S+?),?.* \((\d+) ms\)$", re.M)


def environment(program):
    """Returns the environment of the tests: options of the sanitizers, and a fixed seed of the random values. Set
    RC_PARAMS=seed=… for another seed."""
    env = dict(os.environ)
    env.setdefault("RC_PARAMS", "seed=1")
    env.setdefault("UBSAN_OPTIONS", "print_stacktrace=1")
    env.setdefault("ASAN_SYMBOLIZER_PATH", "/usr/bin/llvm-symbolizer-19")
    env.setdefault("LSAN_OPTIONS", f"suppressions={ROOT}/tests/leaks.txt:print_suppressions=0")
    # The leak checker stops all threads, and sometimes crashes on the threads of the graphics driver. So it is off in
    # programs that use graphics.
    if re.search(r"test_(render|film|playback|server)$", program):
        env.setdefault("ASAN_OPTIONS", "detect_leaks=0")
    return env


def run_program(program, options, env):
    """Runs the program. Returns its output and exit code. After LONGEST seconds kills it and its children."""
    process = subprocess.Popen([program, *options], env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, start_new_session=True, text=True, errors="replace")
    try:
        output, _ = process.communicate(timeout=LONGEST)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        output, _ = process.communicate()
        output += f"\nkilled after {LONGEST} s\n"
    return output, process.returncode


def test_names(program, options, env):
    """Returns the full names of the tests that these options choose."""
    output, _ = run_program(program, [*options, "--gtest_list_tests"], env)
    suite, found = "", []
    for line in output.splitlines():
        line = line.split("#")[0].rstrip()
        if line.endswith(".") and not line.startswith(" "):
            suite = line
        elif line.startswith("  ") and "DISABLED_" not in suite + line:
            found.append(suite + line.strip())
    return found


def slow_tests(under):
    """Returns the names of the tests that took longer than SECONDS according to FILE. `under` is "SECONDS:FILE"."""
    seconds, path = under.split(":", 1)
    if not os.path.exists(path):
        return set()
    with open(path) as file:
        rows = [line.rstrip("\n").split("\t", 1) for line in file]
    return {row[1] for row in rows if float(row[0]) > float(seconds)}


def results(output):
    """Yields (name, verdict, seconds, text) for each test that began. The verdict is None if the test did not end."""
    begun = list(BEGINS.finditer(output))
    for k, begin in enumerate(begun):
        text = output[begin.start():begun[k + 1].start() if k + 1 < len(begun) else len(output)]
        end = ENDS.search(text)
        yield begin[1], end and end[1], int(end[3]) / 1000 if end else 0, text[:end.end()] if end else text


def main(program, *options):
    share = options[0] if options and re.fullmatch(r"\d+/\d+", options[0]) else ""
    options, share = options[bool(share):], share or "1/1"
    if not os.access(program, os.X_OK):
        sys.exit(f"units.py: there is no program {program}")
    number, count = map(int, share.split("/"))
    env = environment(program)
    room = re.sub(".*test_", "", program)
    left_out = set().union(*(slow_tests(o[8:]) for o in options if o.startswith("--under=")))
    options = [o for o in options if not o.startswith("--under=")]
    left = [name for name in test_names(program, options, env)[number - 1::count] if f"{room}/{name}" not in left_out]
    passed, failed, times = 0, 0, []
    while left:
        output, code = run_program(program, [*options, "--gtest_color=no", "--gtest_filter=" + ":".join(left)], env)
        done = set()
        for name, verdict, seconds, text in results(output):
            done.add(name)
            times.append(f"{seconds:.3f}\t{room}/{name}\n")
            if verdict in ("OK", "SKIPPED"):
                passed += 1
            else:
                failed += 1
                print(text if verdict else f"{text[-8000:]}\n{name} ended its process with code {code}")
        if len(done) == len(left):
            # All tests have passed, but the process failed at its end, for example because of a leak.
            if code != 0 and failed == 0:
                failed += 1
                print(f"{output[-8000:]}\n{program} ended with code {code}")
            break
        if not done:
            failed += len(left)
            print(f"{output[-8000:]}\n{program} ran no test, and ended with code {code}")
            break
        left = [name for name in left if name not in done]
    if times and os.environ.get("BETWIXT_TIMES"):
        with open(os.environ["BETWIXT_TIMES"], "a") as file:
            file.write("".join(times))
    print(f"{passed} passed, {failed} failed")
    return failed > 0


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
