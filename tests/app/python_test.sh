#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# python_test.sh PROGRAM: every call of the Animation Imaging Model from Python; what comes back is worked out another
# way. Then all that is refused, calls that make no sense, and servers that go, are late, or are none.
# shows: C16 C32 C33 C35 C36 C37 C38 C39 C40 C42 C63 C66 C69 C70 C71 C86 C88 C90 C92 C94 C97 C98 C101
root=$(cd -- "$(dirname -- "$0")/../.." && pwd)
. "$(dirname -- "$0")/support.sh" || exit 3
export PYTHONPATH=$root/clients/python PYTHONDONTWRITEBYTECODE=1
# What the hosts below have in common. A check says what did not hold.
cat >common.py <<'PY'
import contextlib, math, os, signal, socket, sys, threading, time
from math import cos, sin
from betwixt_client import *

passed = failed = 0

def check(what, good):
    global passed, failed
    passed, failed = passed + bool(good), failed + (not good)
    if not good:
        print("FAILED", what)

def near(a, b, within=1e-9):
    return len(a) == len(b) and all(abs(x - y) < within for x, y in zip(a, b))

def fails(what, kind, message, call, *arguments, **named):
    try:
        call(*arguments, **named)
        check(f"{what}: nothing was raised", False)
    except Exception as e:
        as_said = type(e) is kind and str(e) == message
        check(f"{what}: {type(e).__name__}: {e}\n  is not {kind.__name__}: {message}", as_said)

def settle(server):
    """When all that was said has taken effect."""
    now = server.time()["tick"]
    while server.time()["tick"] <= now + 1:
        time.sleep(0.01)

def stop(process):
    """When it returns, all its threads stand."""
    os.kill(process, signal.SIGSTOP)
    tasks = f"/proc/{process}/task"
    while not all(open(f"{tasks}/{t}/stat").read().rsplit(")", 1)[1].split()[0] == "T" for t in os.listdir(tasks)):
        time.sleep(0.001)

def done():
    print(passed, "passed,", failed, "failed")
    sys.exit(failed != 0)
PY
part() { # NAME: a part's verdict, that of each of its checks
  local said status
  said=$(timeout 120 python3 "$1.py" "$work/s" "${@:2}" 2>&1)
  status=$?
  verdict "$1" "$([ $status = 0 ] && [[ $said =~ ([0-9]+)' passed, 0 failed' ]] && echo yes)" "$said"
}

# ---- matrices: the rows of appendix A, and what points become
cat >matrices.py <<'PY'
from common import *
c, s = cos(0.7), sin(0.7)
check("identity", identity() == [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
check("Translate (A.1)", translate(2, 3, 4) == [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 2, 3, 4, 1])
check("Scale (A.2)", scale(2, 3, 4) == [2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 0, 0, 0, 1])
check("Rotate_x (A.3)", rotate_x(0.7) == [1, 0, 0, 0, 0, c, s, 0, 0, -s, c, 0, 0, 0, 0, 1])
check("Rotate_y (A.4)", rotate_y(0.7) == [c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, 0, 0, 0, 1])
check("Rotate_z (A.5)", rotate_z(0.7) == [c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
# A turn is right-handed: x to y to z to x.
for turn, a, b in (rotate_x, (0, 1, 0), (0, 0, 1)), (rotate_y, (0, 0, 1), (1, 0, 0)), (rotate_z, (1, 0, 0), (0, 1, 0)):
    check(f"a quarter turn of {turn.__name__}", near(transform(a, turn(math.pi / 2)), b))
p = (1, -2, 3)
check("a scale and then a translation is S T", transform(p, multiply(scale(2, 2, 2), translate(1, 0, 0))) == [3, -4, 6])
check("and the other way round", transform(p, multiply(translate(1, 0, 0), scale(2, 2, 2))) == [4, -4, 6])
a, b = multiply(rotate_x(0.3), translate(1, 2, 3)), multiply(scale(1, 2, 3), rotate_y(2))
check("a product is one after the other", near(transform(p, multiply(a, b)), transform(transform(p, a), b)))
check("turns add up", near(multiply(rotate_z(0.3), rotate_z(0.4)), rotate_z(0.7)))
done()
PY
part matrices

# ---- the page: every call of the C interface stands in it beside that of Python; and it shows the example as it is
page=$(sed -n '/^## From Python/,$p' "$root/docs/aim.md")
for call in $(grep -oE '\baim_[a-z_]+\(' "$root/include/betwixt/aim.h" | tr -d '(' | sort -u | grep -vx aim_error); do
  [[ $page =~ $call([^a-z_]) ]] || verdict "$call is on the page" no "$call"
done
has 'the page shows the example' "$page" "$(sed -n '/^import sys/,$p' "$root/examples/host/two_stars.py")"

# ---- every call
begin --socket "$work/s" --save calls.bx
cat >calls.py <<'PY'
from common import *
a = Host(sys.argv[1])
def rows(o):
    return [row.split(" since ")[0].strip() for row in a.do(f"describe O{o}")["said"].strip().split("\n")[1:]]
star = a.make_object()
a.color(1, 0.5, 0)
tag = a.tag()
a.polygon([(0, 0, 0), (1, 0, 0), [0, 1, 0.25]])
a.push_matrix()
a.multiply_matrix(translate(7, 8, 9))
a.point(1, 2, 3)
a.vector((0, 0, 10), (0, 1e-7, 0))
a.pop_matrix()
a.font("Sans")
a.text('say "spin"\\\nnow')
a.close_object()
history = a.history()
for row in ["color rgb(1 0.5 0)", "polygon (0 0 0) (1 0 0) (0 1 0.25)", "push",
            "multiply matrix(1 0 0 7 0 1 0 8 0 0 1 9 0 0 0 1)", "point (1 2 3)", "vector (0 0 10) (0 1e-07 0)", "pop",
            'font "Sans"', r'text "say \"spin\"\\\nnow"', f"tag T{tag}"]:
    check(f"in the history: {row}", f"  {row}\n" in history)
check("names must be positive numbers of the host", star == tag > 0)
other = Host(sys.argv[1])
check("and no other's", other.make_environment() != a.make_environment())
other.close()

# A list with environments around it; what stands between a pair of calls may stand in a `with`.
spin, drift = a.make_environment(), a.make_environment()
long, short = a.make_object(), None
a.view((0, 0, 10), (0, 0, 0))
a.perspective(0.8)
a.begin_environment(drift)
a.push_matrix()
a.multiply_matrix(scale(2, 2, 2))
a.begin_environment(spin)
a.call_object(star)
a.end_environment()
a.pop_matrix()
a.end_environment()
a.close_object()
with a.object() as short:
    a.view((0, 0, 10), (0, 0, 0))
    a.perspective(0.8)
    with a.environment(drift), a.matrix(scale(2, 2, 2)), a.environment(spin):
        a.call_object(star)
check("with … is begin and end, push and pop", len(rows(long)) == 10 and rows(long) == rows(short))
with a.object() as flat:
    a.orthographic(6)
    a.texture("dots.png")
check("orthographic, texture", 'orthographic 6\n  texture "dots.png"' in a.history())
a.start(long)

# A is M to the n + 1, n being the updates since.
turned = a.animate(spin, 1, rotate_z(0.1))
check("M is there from its tick on", near(a.get_matrix(spin), rotate_z(0.1)) and a.get_interval(spin) == 1)
drifting = a.animate(drift, 3, translate(0.25, 0.5, 0))
check("GetAniTime", a.get_interval(drift) == 3)
check("GetAniMatrix, in rows as it was given", near(a.get_matrix(drift), translate(0.25, 0.5, 0)))
def world(environment, tick):  # in rows
    m = a.eval(f"E{environment}.world", at=f"{tick}t")[f"E{environment}.world"]
    return [m[4 * (i % 4) + i // 4] for i in range(16)]
for later in 0, 1, 29, 30, 1000:
    check(f"a turn {later} ticks later", near(world(spin, turned + later), rotate_z(0.1 * (later + 1))))
    n = later // 3 + 1
    check(f"a drift {later} ticks later", near(world(drift, drifting + later), translate(0.25 * n, 0.5 * n, 0)))
before = a.get_tick()
now, after = a.get_environment_matrix(spin), a.get_tick()
# Of what was just said the client answers as it will be: up to the tick of the last command, if that is still to come.
ticks = range(max(before, turned), max(after, turned, drifting) + 1)
check("A is that of now", any(near(now, rotate_z(0.1 * (t - turned + 1))) for t in ticks))
a.do("pause")
check("the slot counter is the tick modulo 30", a.get_slot_counter() == a.get_tick() % 30)
a.do("go")
# The star in both lists: p turned, doubled, drifted.
leaf = f"O{long}/E{drift}-1/E{spin}-1/O{star}-1.world"
t = max(turned, drifting) + 60
m = a.eval(leaf, at=f"{t}t")[leaf]
p = transform((1, 0, 0), multiply(multiply(rotate_z(0.1 * (t - turned + 1)), scale(2, 2, 2)),
                                  translate(0.25 * ((t - drifting) // 3 + 1), 0.5 * ((t - drifting) // 3 + 1), 0)))
check("what is called is moved by all that is around it", near([m[0] + m[3], m[4] + m[7], m[8] + m[11]], p))

# Halt, animate again, with all that it may have besides; kill.
halted = a.halt(drift)
check("what is halted still says its interval and M",
      a.get_interval(drift) == 3 and near(a.get_matrix(drift), translate(0.25, 0.5, 0)))
check("and stands", world(drift, halted + 500) == world(drift, halted))
stands = world(drift, halted)
again = a.animate(drift, 2, translate(1, 0, 0))
check("A is kept, the first update an interval later", near(world(drift, again + 1), stands) and
      near(world(drift, again + 2), multiply(stands, translate(1, 0, 0))))
free = a.make_environment()
slower = a.animate(free, 1, translate(1, 0, 0), change=1, period=4, ceiling=3)
# Every tick for 4 ticks, every second one for 4, then the ceiling: it stops.
steps = [round(world(free, slower + k)[12]) for k in range(12)]
check(f"an interval that grows: {steps}", steps == [1, 2, 3, 4, 5, 5, 6, 6, 7, 7, 7, 7])
window = a.make_environment()
began = a.animate(window, 1, translate(1, 0, 0), from_=10, until=20)
steps = [round(world(window, began + k)[12]) for k in (0, 9, 10, 11, 20, 99)]
check(f"a start and a stop to come: {steps}", steps == [0, 0, 1, 2, 11, 11])
faster = a.make_environment()
at = a.animate(faster, 6, translate(1, 0, 0), change=-2, period=6)
# An update at 6, then every 4 ticks: 10, 14; then every 2: 16 … (the interval never falls below a tick).
steps = [round(world(faster, at + k)[12]) for k in (5, 6, 9, 10, 13, 14, 15, 16)]
check(f"an interval that shrinks: {steps}", steps == [1, 2, 2, 3, 3, 4, 4, 5])
other = a.make_environment()
stop = a.animate(other, 1, translate(1, 0, 0), until=100000)
check("it will stop", world(other, stop + 200000) == world(other, stop + 100000))
a.cancel(other)
check("or not", world(other, stop + 200000) != world(other, stop + 100000))
phase = a.make_environment()
first = a.animate(phase, 30, translate(1, 0, 0))
settle(a)
kept = a.animate(phase, 30, translate(2, 0, 0), keep_phase=True)
due = first + 30 * -(-(kept - first) // 30)
check("keep_phase", round(world(phase, due)[12] - world(phase, due - 1)[12]) == 2)
a.kill(free)
fails("a name that was killed", Refused,
      f"'E{free}': there is nothing to halt: it has not been animated since it was killed", a.halt, free)

named = a.make_environment() + 1000
a.animate(named, 1, translate(1, 0, 0))
check("animate takes any number", a.get_interval(named) == 1)

# Editing, with other commands in between.
a.edit_object(star)
a.replace(tag)
a.polygon([(0, 0, 0), (9, 0, 0), (0, 9, 0)])
a.close_object()
check("replaced", rows(star)[1:3] == [f"tag T{tag}", "polygon (0 0) (9 0) (0 9)"] and len(rows(star)) == 10)
a.edit_object(star)
a.replace(tag, 2)
check("questions do not end a replacing", a.get_tick() >= 0)
a.point(5, 5, 5)
a.halt(spin)
fails("other commands do", ValueError, "another command came after 'replace', so repeat 'replace' first", a.point, 6, 6, 6)
a.replace(tag, 3)
a.point(7, 7, 7)
a.close_object()
check("replaced behind a tag", rows(star)[3:6] == ["push", "point (5 5 5)", "point (7 7 7)"])
with a.object() as parts:
    a.point(1, 1, 1)
    a.animate(spin, 1, rotate_z(0.1))
    a.point(2, 2, 2)
    with a.bundle():
        a.point(3, 3, 3)
        check("in a bundle nothing is known yet", a.halt(spin) is None)
        fails("no questions", ValueError, "a bundle cannot contain questions", a.get_matrix, spin)
        a.point(4, 4, 4)
    a.point(5, 5, 5)
    with contextlib.suppress(Refused), a.bundle():
        a.point(6, 6, 6)
        a.delete_object(99)
    with contextlib.suppress(ZeroDivisionError), a.bundle():
        a.point(7, 7, 7)
        1 / 0
    with contextlib.suppress(Refused):
        a.do("remove nothing")
    a.point(8, 8, 8)
check("an object may be interrupted", rows(parts) == [f"point ({i} {i} {i})" for i in (1, 2, 3, 4, 5, 8)])
a.begin_bundle()
made = a.make_object()
a.point(1, 1, 1)
check("a bundle's tick", a.end_bundle()["ok"] and rows(made) == ["point (1 1 1)"])
settle(a)
a.begin_bundle()
a.animate(spin, 4, rotate_z(0.1))
a.end_bundle()
check("of what a bundle said, as it will be", a.get_interval(spin) == 4)
check("the language too", "environment" in a.do("help animate")["said"])
a.delete_object(parts)
fails("deleted", Refused, f"there is no display list 'O{parts}' (did you mean 'O{star}'?)", a.edit_object, parts)
done()
PY
"$program" frame "$root/examples/bounce.bx" --at 1f -o dots.png --size 16x16 >/dev/null 2>&1
part calls
end
begin --socket "$work/s" --save calls.bx
is 'names stay unique when a server goes on with a history' "$(python3 -c "
import re
from common import *
with Host('$work/s') as a:
    had = [int(n) for n in re.findall(r'\\b[EOT](\\d+)', a.history())]
    print(len(had) > 9, a.make_object() > max(had))")" 'True True'
end
"$program" check calls.bx >checked 2>&1
is 'the history is a script' "$?" 0
has 'all of it' "$(cat calls.bx)" 'texture "dots.png"'

# ---- two stars (the example), that go on when their host has gone
begin --socket "$work/s" --save stars.bx
python3 "$root/examples/host/two_stars.py" "$work/s" >said 2>&1
is 'the example' "$?$(cat said)" 0
cat >stars.py <<'PY'
from common import *
with Server(sys.argv[1]) as server:
    history = server.history()
    begun = {line.split()[3]: int(line.split()[1][:-1]) for line in history.splitlines() if " animate " in line}
    drift, left, right = begun
    sky = next(line.split()[1] for line in history.splitlines() if line.startswith("start "))
    star = next(line.split()[1] for line in history.splitlines() if " call " in line)
    for t in 60, 61, 600:
        for number, spin, x, angle in (1, left, -2, 0.05), (1, right, 2, -0.08):
            whole = f"{sky}/{drift}-1/{spin}-{number}/{star}-1.world"
            m = server.eval(whole, at=f"{t}t")[whole]
            n = t - begun[spin] + 1
            d = t - begun[drift] + 1
            c, s = cos(angle * n), sin(angle * n)
            wanted = [c, -s, 0, x + 0.01 * d, s, c, 0, 0.004 * d, 0, 0, 1, 0, 0, 0, 0, 1]
            check(f"{whole} at {t}t: {m}", near(m, wanted))
    settle(server)
done()
PY
part stars
end
"$program" check stars.bx >checked 2>&1
is 'the example'"'"'s history is a script' "$?" 0

# ---- what is refused, and what makes no sense
: >empty.bx # without a script no texture could be read
begin empty.bx --socket "$work/s"
cat >errors.py <<'PY'
from common import *
a = Host(sys.argv[1])
unit = identity()
# The server's own words, and its hint.
fails("make", Refused, "there is no display list 'O7'", a.edit_object, 7)
fails("delete", Refused, "there is no display list 'O7'", a.delete_object, 7)
fails("start", Refused, "there is no display list 'O7'", a.start, 7)
for call in a.halt, a.kill, a.cancel, a.get_interval, a.get_matrix, a.get_environment_matrix:
    fails(call.__name__, Refused, "there is no environment 'E7'" if call in (a.halt, a.kill, a.cancel) else
          "there is no object 'E7'", call, 7)
fails("animate", Refused, "an interval must be at least one tick (for a faster motion, take larger steps)",
      a.animate, 1, 0, unit)
fails("not affine", Refused,
      "the last row of a matrix must be 0 0 0 1 (write 16 numbers row by row; the last column is the translation)",
      a.animate, 1, 1, [1, 0, 0, 1] + unit[4:])
fails("period", Refused, "an interval must change by at least one tick", a.animate, 1, 1, unit, change=1, period=0)
fails("ceiling", Refused, "a limit must be at least one tick", a.animate, 1, 1, unit, ceiling=0)
fails("from", Refused, "'E1': an environment cannot start before its animate", a.animate, 1, 1, unit, from_=-3)
fails("until", Refused, "'E1': an environment must halt after it starts: until 3t is not after from 9t", a.animate,
      1, 1, unit, from_=9, until=3)
with a.object() as o:
    fails("tag", Refused, f"there is no tag 'T7' in 'O{o}'", a.replace, 7)
    fails("pop", Refused, "this 'pop' has no 'push' before it (usage: pop)", a.pop_matrix)
    fails("end", Refused, "this 'end' has no 'begin' before it (usage: end)", a.end_environment)
    fails("itself", Refused, f"'O{o}' cannot call itself", a.call_object, o)
    fails("texture", Refused, "there is no file 'none.png'", a.texture, "none.png")
    fails("perspective", Refused, "perspective must be at most 177.6deg (the angle of view of a camera must be less than 180deg)", a.perspective, 9)
    fails("orthographic", Refused, "orthographic must be at least 0", a.orthographic, -1)
    fails("text", Refused, "this is not a text file: it contains a control character (byte 0x00)", a.text, "a\0b")
    fails("two at once", ValueError, "an object is already open", a.make_object)
    fails("two at once", ValueError, "an object is already open", a.edit_object, 1)
    # What makes no sense is not sent.
    lines = a.stats()["lines"]
    for call, bad in (a.point, (1, 2, math.nan)), (a.vector, ((0, 0), (0, 0, 0))), (a.polygon, ([(0, 0, 0, 0)] * 3,)), \
                     (a.view, ((0, 0, 1), (0, 0, math.inf))):
        fails(call.__name__, ValueError, "a point is three finite numbers", call, *bad)
    fails("polygon", ValueError, "a polygon must have at least three points", a.polygon, [(0, 0, 0)] * 2)
    fails("color", ValueError, "a colour is three finite numbers", a.color, 0, math.inf, 0)
    fails("perspective", ValueError, "an angle is a finite number", a.perspective, math.nan)
    fails("orthographic", ValueError, "a height is a finite number", a.orthographic, math.nan)
    for m in unit[1:], unit * 2, unit[1:] + [math.nan]:
        fails("multiply_matrix", ValueError, "a matrix is 16 finite numbers", a.multiply_matrix, m)
        fails("animate", ValueError, "a matrix is 16 finite numbers", a.animate, 1, 1, m)
        fails("matrix", ValueError, "a matrix is 16 finite numbers", a.matrix(m).__enter__)
    for call, bad in (a.point, ("1", 2, 3)), (a.color, (1, 2, None)), (a.multiply_matrix, (5,)), \
                     (a.multiply_matrix, ("x" * 16,)), (a.polygon, (1,)), (a.texture, (3,)), (a.call_object, ("O1",)), \
                     (a.halt, (1.5,)), (a.animate, (1, 1.5, unit)):
        try:
            call(*bad)
            check(f"{call.__name__}{bad}: nothing was raised", False)
        except TypeError:
            check("", True)
    for call in a.text, a.font, a.texture:
        fails(call.__name__, TypeError, "a text is a str, not bytes", call, b"a")
    check("nothing was sent", a.stats()["lines"] == lines + 1)
# No object is open.
for call, arguments in (a.close_object, ()), (a.tag, ()), (a.replace, (1,)), (a.call_object, (1,)), \
                       (a.push_matrix, ()), (a.pop_matrix, ()), (a.multiply_matrix, (unit,)), (a.point, (1, 2, 3)), (a.text, ("a",)), \
                       (a.vector, ((0, 0, 0), (0, 0, 1))), (a.polygon, ([(0, 0, 0)] * 3,)), (a.color, (1, 1, 1)), \
                       (a.texture, ("a",)), (a.font, ("a",)), (a.view, ((0, 0, 0), (0, 0, 1))), (a.perspective, (1,)), \
                       (a.orthographic, (1,)), (a.begin_environment, (1,)), (a.end_environment, ()):
    fails(call.__name__, ValueError, "no object is open", call, *arguments)
# Bundles.
fails("end_bundle", ValueError, "no bundle is open", a.end_bundle)
before = a.time()["line"]
a.begin_bundle()
fails("begin_bundle", ValueError, "a bundle is already open", a.begin_bundle)
for question in a.get_tick, a.get_slot_counter, a.time, a.stats, a.history:
    fails(question.__name__, ValueError, "a bundle cannot contain questions", question)
a.make_object()
a.halt(7)
fails("a bundle", Refused, f"line {before + 3}: there is no environment 'E7'", a.end_bundle)
fails("of which nothing is left", ValueError, "no object is open", a.point, 1, 2, 3)
fails("a bundle by hand", ValueError, "a bundle is made by: with server.bundle():", a.do, "bundle")
a._named["tag"] = 999  # the last of the first thousand
with a.object():
    check("more names are asked for", a._blocks[0] + 999 == a.tag() < a.tag() == a._blocks[1])
check("after all that it is served", a.get_tick() >= 0)
a.close()
for call in a.get_tick, a.make_object, lambda: next(a.events(0)):
    fails("closed", Gone, "the connection is closed", call)
done()
PY
part errors
end

# ---- servers that are not there, or no more, or late, or none
begin --socket "$work/s"
disown $server
cat >gone.py <<'PY'
from common import *
where, server = sys.argv[1], int(sys.argv[2])
fails("nobody", Gone, "no server listens at /nowhere/at/all: No such file or directory", Host, "/nowhere/at/all")
fails("too long", Gone, f"no server listens at {'x' * 200}: AF_UNIX path too long", Host, "x" * 200)
tcp = "by TCP the server's token is needed, too"
fails("no token", ValueError, f"there is no socket localhost:1; {tcp}", Host, "localhost:1")
fails("no token", ValueError, f"there is no socket [::1]:9100; {tcp}", Host, "[::1]:9100")
fails("a path", Gone, "no server listens at ./none:1: No such file or directory", Host, "./none:1")
fails("no port", ValueError, "with a token, where is HOST:PORT", Host, "localhost", "t")
shy = socket.create_server(("127.0.0.1", 0))
port = shy.getsockname()[1]
fails("says nothing", Late, "the server has not answered in 0.2 s", Host, f"127.0.0.1:{port}", "t", 0.2)
shy.close()
fails("refused", Gone, f"no server listens at 127.0.0.1:{port}: Connection refused", Host, f"127.0.0.1:{port}", "t")
os.environ.pop("XDG_RUNTIME_DIR", None)
fails("nowhere", ValueError, "no socket is given, and XDG_RUNTIME_DIR is not set", Host)
os.environ["XDG_RUNTIME_DIR"] = os.path.dirname(where)
os.symlink(where, os.path.join(os.path.dirname(where), "betwixt.sock"))
with Host() as a:
    check("where servers usually are", a.get_tick() >= 0)

# One that is stopped: late, then of no more use; a connection made later is.
a, b = Host(where, timeout=0.3), Host(where)
stop(server)
fails("stopped", Late, "the server has not answered in 0.3 s", a.get_tick)
fails("and closed", Gone, "the connection is closed", a.get_slot_counter)
os.kill(server, signal.SIGCONT)
check("others are served", b.get_tick() >= 0)
# A wait for events is no such thing.
check("no event", list(b.events(0.05)) == [] == list(b.events(0)) and b.get_tick() >= 0)
# What is broken off has no answer that another call might get.
stop(server)
signal.signal(signal.SIGALRM, lambda *_: 1 / 0)
signal.setitimer(signal.ITIMER_REAL, 0.2)
fails("broken off", ZeroDivisionError, "division by zero", b.get_tick)
os.kill(server, signal.SIGCONT)
fails("and closed", Gone, "the connection is closed", b.get_tick)
# One that is killed in mid-call, one that ends.
a, b = Host(where), Host(where)
a.make_object()
stop(server)
threading.Timer(0.2, os.kill, (server, signal.SIGKILL)).start()
fails("killed", Gone, "the server closed the connection", a.point, 1, 2, 3)
fails("killed before", Gone, "the server closed the connection", b.get_tick)
fails("in a with", Gone, "the connection is closed", a.get_tick)

# Servers that are none.
def answering(answer):
    there = os.path.join(os.path.dirname(where), "other")
    listening = socket.socket(socket.AF_UNIX)
    listening.bind(there)
    listening.listen()
    def serve():
        c = listening.accept()[0]
        c.recv(100)
        c.sendall(answer)
        c.close()
    threading.Thread(target=serve, daemon=True).start()
    try:
        return Host(there, timeout=5)
    finally:
        os.unlink(there)
for answer in b"220 ready\n", b"[]\n", b"{}\n", b"\xff\xfe\n", b"[" * 100000 + b"\n":
    fails(f"{answer[:10]}", Gone, "this is not an imaging server", answering, answer)
fails("half an answer", Gone, "the server closed the connection", answering, b'{"line":1,')
fails("a full one", Refused, "there are enough hosts (later)", answering,
      b'{"line":0,"ok":false,"error":"there are enough hosts","hint":"later"}\n')
done()
PY
part gone $server

# ---- TCP
begin --tcp 127.0.0.1:0
cat >tcp.py <<'PY'
from common import *
where, token = sys.argv[2:]
with Host(where, token) as a:
    with a.object() as o:
        a.point(1, 2, 3)
    check("by TCP", "point (1 2 3)" in a.history())
fails("a wrong token", Refused, "this is not the token (the first line must be: token TOKEN)", Host, where, "x")
done()
PY
part tcp "127.0.0.1:$(sed -nE 's/^serving at 127.0.0.1:([0-9]+);.*/\1/p' log)" "$(sed -n 's/^token //p' log)"
end
summary
