# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Builds and runs the sections of `./test`, and prints what failed, how many checks passed, and the ten slowest.

    suite.py usual                the tests that show that the product works
    suite.py full                 also sanitizers, other programs, pages in a browser, editors and fuzzing
    suite.py quick [ROOM…]        the rules of the house, and the unit tests of these rooms (folders of src/); without
                                  names, of all rooms whose test program has changed since it passed. It leaves out the
                                  slow tests of rooms that you have not edited.

One thread builds the sections in order. Meanwhile half of the processors run the tests of the sections that are built.
When all is built, one test more runs at a time than there are processors, because some tests wait for other programs.
"""

import glob
import os
import queue
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
from typing import Callable, NamedTuple

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BUILD = f"{ROOT}/build/release"
PROGRAM = f"{BUILD}/bin/betwixt"
CORES = os.cpu_count() or 2
LONGEST = 1800  # seconds for a job
COUNTS = re.compile(r"^(\d+) passed, (\d+) failed$", re.M)


class Section(NamedTuple):
    name: str
    modes: str  # the modes in which it runs
    build: str  # the command of tools/setup.sh that builds what it needs; empty if it needs nothing
    jobs: Callable[[], list]  # returns the jobs; called after the build


class Job(NamedTuple):
    label: str
    command: list
    program: str = ""  # the path of the tested program, if the job tests only one


def units(folder, wanted="*"):
    """Returns a function that lists the jobs: two shares of each test program, so that no processor is idle at the
    end."""
    def jobs():
        for program in sorted(glob.glob(f"{BUILD}/{folder}/test_{wanted}"), key=lambda p: -os.path.getsize(p)):
            for k in (1, 2):
                yield Job(f"{os.path.basename(program)} {k} of 2", ["python3", "tests/units.py", program, f"{k}/2"], program)
    return lambda: list(jobs())


def scripts(*patterns, without=()):
    def jobs():
        found = [s for pattern in patterns for s in sorted(glob.glob(pattern, root_dir=ROOT)) if s not in without]
        found.sort(key=lambda s: "serve" not in s)  # serve_test waits longest, so it comes first
        return [Job(os.path.basename(s), [s, PROGRAM]) for s in found]
    return jobs


def studio():
    return panels() + [Job(name, ["tests/studio/run.sh", BUILD, name]) for name in ("window", "maximised", "reader", "pictures")]


def panels():
    tests = sorted(glob.glob(f"{BUILD}/bin/studio_*_test"))
    return [Job(os.path.basename(t), ["tests/studio/run.sh", BUILD, t], t) for t in tests]


def python():
    modules = sorted(os.path.basename(f)[:-3] for f in glob.glob(f"{ROOT}/tests/python/*_test.py"))
    return [Job(m, ["tests/python/run.sh", BUILD, m]) for m in modules]


def pages():
    names = sorted(os.path.basename(f)[:-8] for f in glob.glob(f"{ROOT}/tests/web/*_test.py"))
    return [Job(n, ["tests/web/run.sh", PROGRAM, n]) for n in names]


def peers():
    return [Job(name, ["tests/peers/run.sh", PROGRAM, name]) for name in ("gltf", "usda", "lottie", "drawings", "web", "typescript", "editor")]


def single_job(*command):
    return lambda: [Job(os.path.basename(command[0]), list(command))]


EDITORS = ("tests/app/editors_test.sh",)
SECTIONS = (
    Section("rules of the house", "usual full", "", single_job("tests/house.sh")),
    Section("command line", "usual full", "build release betwixt_command",
            scripts("tests/app/*_test.sh", without=EDITORS)),
    Section("examples", "usual full", "", lambda: [Job("films", ["tests/examples.sh", PROGRAM]),
                                                Job("coming from", ["python3", "tests/coming_from.py", PROGRAM]),
                                                Job("pages", ["python3", "tests/docs.py", PROGRAM])]),
    Section("unit tests", "usual full", "build release unit_tests", units("bin")),
    Section("Python", "usual full", "build release betwixt_python", python),
    Section("studio", "usual full", "build release betwixt_studio studio_tests", studio),
    Section("installation", "usual full", "build release all", single_job("tests/install/run.sh", BUILD)),
    Section("editors", "full", "", scripts(*EDITORS)),
    Section("unit tests under sanitizers", "full", "build release watched_tests", units("watched")),
    Section("benchmarks", "full", "build release benchmarks", lambda: [Job("they are built", ["true"])]),
    Section("Blender", "full", "", single_job("tests/blender/run.sh", BUILD)),
    Section("pages in a browser", "full", "build_player", pages),
    Section("other programs", "full", "tests/peers/run.sh --install", peers),
    Section("a minute of fuzzing", "full", "tools/fuzz.sh build", single_job("tools/fuzz.sh", "60")),
)


class Tally:
    """Counts all checks. Its lock also keeps the output of different threads apart."""

    def __init__(self):
        self.begun, self.lock = time.monotonic(), threading.Lock()
        self.passed = self.failed = 0

    def say(self, text):
        with self.lock:
            print(f"{time.monotonic() - self.begun:5.0f} s  {text}", flush=True)


class Progress:
    """The progress of a section: how many jobs are left, and the counts of the others."""

    def __init__(self, section, jobs):
        self.name, self.left = section.name, jobs
        self.passed = self.failed = 0
        self.seconds = 0.0


def run(command, env):
    """Runs a command. Returns its output and exit code. After LONGEST seconds kills it and its children."""
    process = subprocess.Popen(command, cwd=ROOT, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT, start_new_session=True, text=True, errors="replace")
    running.add(process)
    try:
        output, _ = process.communicate(timeout=LONGEST)
    except subprocess.TimeoutExpired:
        waiting = process_tree(process.pid)
        os.killpg(process.pid, signal.SIGKILL)
        output = process.communicate()[0] + f"\nkilled after {LONGEST} s\n{waiting}"
    running.discard(process)
    return output, process.returncode


def process_tree(pid, depth=0):
    """Returns a line for a process and each of its descendants: the state, where in the kernel it waits, the
    command."""
    def read(name):
        with open(f"/proc/{pid}/{name}", errors="replace") as file:
            return file.read()
    try:
        state, wait, command = read("stat").rsplit(")", 1)[1].split()[0], read("wchan"), read("cmdline").replace("\0", " ")
        below = [process_tree(int(child), depth + 1)
                 for thread in os.listdir(f"/proc/{pid}/task") for child in read(f"task/{thread}/children").split()]
    except OSError:  # the process has ended
        return ""
    return f"{'  ' * depth}{pid} {state} {wait} {command[:100]}\n" + "".join(below)


running = set()


def counts_of(output, code):
    """Returns (passed, failed) of a job, from its last line "N passed, N failed". Without such a line the job counts as
    one check, by its exit code."""
    found = COUNTS.findall(output)
    passed, failed = map(int, found[-1]) if found else (int(code == 0), 0)
    return passed, failed or int(code != 0)


def timed_run(job, section, times):
    """Runs a job. Adds (seconds, name) for each of its checks to `times`, or for the whole job if it reports no
    times."""
    with tempfile.NamedTemporaryFile("r", prefix="betwixt-times-") as file:
        begun = time.monotonic()
        output, code = run(job.command, dict(os.environ, BETWIXT_TIMES=file.name))
        seconds = time.monotonic() - begun
        rows = [line.rstrip("\n").split("\t", 1) for line in file]
    if code == -signal.SIGKILL and rows:
        output += f"the last check that ended: {rows[-1][1]}\n"
    times += [(float(row[0]), row[1]) for row in rows] or [(seconds, f"{section}, {job.label}")]
    return output, code, seconds


def run_jobs(jobs, tally, room, times):
    """Runs jobs from a queue until it gets None. The semaphore `room` limits how many run at a time."""
    while (entry := jobs.get()) is not None:
        progress, job = entry
        with room:
            output, code, seconds = timed_run(job, progress.name, times)
        passed, failed = counts_of(output, code)
        if job.program and not failed:
            open(passed_file(job), "w").close()
        said = "".join(f"         {line}\n" for line in output.splitlines() if not COUNTS.fullmatch(line))
        with tally.lock:
            if failed or "left out" in said:
                print(f"         {progress.name}, {job.label}:\n{said}", end="", flush=True)
            tally.passed += passed
            tally.failed += failed
            progress.passed += passed
            progress.failed += failed
            progress.seconds += seconds
            progress.left -= 1
            over = not progress.left
        if over:
            tally.say(f"{progress.name}: {progress.passed} passed, {progress.failed} failed"
                      f" ({progress.seconds:.0f} s of work)")


def build(command):
    """Runs a command of tools/setup.sh, which prints its progress on stderr. Returns whether it succeeded."""
    shell = 'root=$1; . "$1/tools/setup.sh"; eval "$2"'
    return subprocess.run(["bash", "-c", shell, "bash", ROOT, command], cwd=ROOT, stdin=subprocess.DEVNULL).returncode == 0


TIMES = f"{BUILD}/passed/times"  # how long each check took when it was last run: SECONDS<tab>NAME


def keep_times(times):
    kept = {}
    if os.path.exists(TIMES):
        with open(TIMES) as file:
            kept = {name: seconds for seconds, name in (line.rstrip("\n").split("\t", 1) for line in file)}
    kept.update((name, f"{seconds:.3f}") for seconds, name in times)
    with open(TIMES + ".new", "w") as file:
        file.writelines(f"{seconds}\t{name}\n" for name, seconds in kept.items())
    os.replace(TIMES + ".new", TIMES)


def edited_rooms():
    """Returns the rooms whose sources or tests differ from the last commit. If none does, returns the rooms that the
    last commit changed."""
    def changed(*command):
        return subprocess.run(["git", *command], cwd=ROOT, capture_output=True, text=True).stdout.splitlines()
    files = changed("diff", "--name-only", "HEAD") + changed("ls-files", "--others", "--exclude-standard")
    rooms = {m[1] for m in map(re.compile("(?:src|tests)/([a-z]+)/").match, files) if m}
    return rooms or {m[1] for m in map(re.compile("(?:src|tests)/([a-z]+)/").match, changed("diff", "--name-only", "HEAD~1")) if m}


def passed_file(job):
    """Returns the path of a marker file. It is newer than the program of a job if this build of it has passed."""
    return f"{BUILD}/passed/{os.path.basename(os.path.dirname(job.program))}-{job.label.replace(' ', '-')}"


def not_passed_yet(jobs):
    """Returns a function that lists the jobs whose programs have changed since they passed."""
    def old(job):
        mark = passed_file(job)
        return not os.path.exists(mark) or os.path.getmtime(mark) < os.path.getmtime(job.program)
    return lambda: [job for job in jobs() if old(job)]


def without_slow_tests(jobs, rooms):
    """Returns a function that lists the jobs. Jobs of other rooms than these run only the tests that took at most 0.3
    s."""
    def short(job):
        room = job.program.rsplit("test_", 1)[1]
        return job if room in rooms else job._replace(command=[*job.command, f"--under=0.3:{TIMES}"])
    return lambda: [short(job) for job in jobs()]


def quick_sections(rooms):
    """Yields the sections of `./test quick ROOM…`."""
    yield SECTIONS[0]
    if not rooms:
        yield Section("unit tests", "", "build release unit_tests", not_passed_yet(without_slow_tests(units("bin"), edited_rooms())))
        with open(f"{BUILD}/CMakeCache.txt") as cache:
            if "BETWIXT_STUDIO:BOOL=ON" in cache.read():
                yield Section("studio", "", "build release studio_tests", not_passed_yet(panels))
    for room in rooms:
        if room == "app":
            yield Section("command line", "", "build release betwixt_command", scripts("tests/app/*_test.sh", without=EDITORS))
        elif room == "studio":
            yield Section("studio", "", "build release betwixt_studio studio_tests", panels)
        else:
            yield Section(f"unit tests of {room}", "", f"build release test_{room}", units("bin", room))


def main(mode, *rooms):
    tally, jobs, room = Tally(), queue.Queue(), threading.Semaphore(CORES + 1)
    os.makedirs(f"{BUILD}/passed", exist_ok=True)
    times = []
    workers = [threading.Thread(target=run_jobs, args=(jobs, tally, room, times), daemon=True) for _ in range(CORES + 1)]
    for worker in workers:
        worker.start()
    held = CORES // 2 + 1
    for _ in range(held):
        room.acquire()
    for section in quick_sections(rooms) if mode == "quick" else SECTIONS:
        if mode != "quick" and mode not in section.modes.split():
            continue
        if section.build:
            tally.say(f"building: {section.name}")
            if not build(section.build):
                tally.failed += 1
                tally.say(f"{section.name}: could not be built")
                continue
        found = section.jobs()
        if not found:
            tally.say(f"{section.name}: nothing to run, because nothing has changed since it passed")
        progress = Progress(section, len(found))
        for job in found:
            jobs.put((progress, job))
    for _ in range(held):
        room.release()
    for _ in workers:
        jobs.put(None)
    for worker in workers:
        worker.join()
    keep_times(times)
    print("the slowest:" + "".join(f"\n{seconds:8.1f} s  {name}" for seconds, name in sorted(times, reverse=True)[:10]))
    tally.say("total")
    print(f"{tally.passed} passed, {tally.failed} failed")
    return tally.failed > 0


if __name__ == "__main__":
    try:
        sys.exit(main(*sys.argv[1:]))
    except KeyboardInterrupt:
        for process in running:
            os.killpg(process.pid, signal.SIGTERM)
        sys.exit(130)
