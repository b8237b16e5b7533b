#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the imaging server over real sockets: hosts that use the Python client or plain bytes, abuse, kills, and the
# state after them.
#   serve_test.sh PROGRAM
# shows: C3 C4 C12 C13 C14 C15 C16 C97 C99 C100 C101 C103 C114 C129 C133
clients=$(realpath -- "$(dirname -- "$0")/../../clients/python")
. "$(dirname -- "$0")/support.sh" || exit 3
export PYTHONPATH=$clients PYTHONDONTWRITEBYTECODE=1
socket=$work/s.sock

# Runs Python code with a client `s` of the server, and prints its output.
host() {
  timeout 60 python3 -c "
import json, os, socket, sys, time
from betwixt_client import Server, Refused, Gone, Ring
where = '$socket'
s = Server(where)
$1" 2>&1
}

cat >show.bx <<'BX'
rate 60
create ball sphere
create eye camera position=(0 0 10)
BX

# ---- a host and its commands
{ printf '; FBX 7.4.0 project file\n' && printf 'A: {%.0s' {1..50000}; } >deep.fbx
begin show.bx --socket "$socket" --save live.bx
is 'the socket is its owner'"'"'s' "$(stat -c %a "$socket")" 600
out=$(host '
print(s.do("create box box position=(1 2 3)")["ok"], s.eval("box.position"))
try: s.do("create box box")
except Refused as e: print(e)
with s.bundle():
    s.do("animate spin every 1t by rotate(1deg, z)")
    s.do("set box.environments (spin)")
try:
    with s.bundle():
        s.do("remove box")
        s.do("remove bax")
except Refused as e: print(e)
s.sheet("ball.position", [("1f", "(0 0 0)"), ("61f", "(0 1 0)")])
print(s.eval("ball.position.y", at="1s"), s.slot() in range(30), s.time()["running"])
o = Server(where)
o.do("subscribe changes")
s.do("set ball.color red")
print(next(o.events(5))["commands"])
try: s.do("quit"); s.do("time")
except Gone: print("gone")
try: o.do("create deep mesh file=\"deep.fbx\"")
except Refused as e: print(e)
o.do("set ball.radius 2")
')
is 'the Python client' "$out" "True {'box.position': [1, 2, 3]}
'box' already exists
line 10: there is no object 'bax'
{'ball.position.y': 1} True True
set ball.color red
gone
deep.fbx is damaged: the program that reads it crashed"
told=$(host 'print(s.time()["seconds"])')
kill -KILL $server
wait $server 2>/dev/null
has 'what was answered is kept when the server is killed' "$(tr -d '\0' <.live.bx.journal)" 'set ball.radius 2'
is 'and not in the script' "$(cat live.bx)" "$(cat show.bx)"

begin --socket "$socket" --save live.bx
goes_on=$(host 'print(s.time()["seconds"])')
verdict 'its time goes on' "$(awk -v a="$told" -v b="$goes_on" 'BEGIN { if (b >= a && b < a + 10) print "yes" }')" "$goes_on s after $told s"
out=$(host 'print(s.eval("ball.radius"), s.do("help stats")["said"].split("\n")[0])')
is 'another server goes on with it, at the same socket' "$out" "{'ball.radius': 2} Prints statistics of the server: frames, lateness, hosts."
"$program" serve --socket "$socket" 2>err
is 'a socket that is in use' "$?-$(head -n 1 err)" "2-betwixt: error: another server uses '$socket'"
end
is 'ends when told' "$code" 0
is 'and leaves no socket' "$(ls "$socket" 2>/dev/null)" ''
is 'nor a journal' "$(ls .live.bx.journal 2>/dev/null)" ''
has 'its history is whole' "$(cat live.bx)" 'set ball.radius 2'
"$program" check live.bx >/dev/null 2>&1
is 'and a script' $? 0
echo precious >"$socket"
"$program" serve --socket "$socket" 2>err
is 'a file in its place stays' "$?-$(cat "$socket")" 2-precious
rm -f "$socket"
DISPLAY= "$program" serve --socket "$socket" --to window 2>err
is 'no window where there is no display' "$?-$(head -n 1 err)" '3-betwixt: error: a window needs a display'

# ---- commands that cannot be repeated after a restart are set aside
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >m.obj
printf 'hide ball\n' >killer.bx
begin show.bx --socket "$socket" --save kept.bx
host '
s.do("create m mesh file=\"m.obj\"")
s.do("set ball.radius 3")
s.do("use killer.bx")
s.do("hang m on ball")
with s.bundle():
    s.do("set ball.color red")
    s.do("set m.color red")
s.do("create last sphere")'
kill -KILL $server
wait $server 2>/dev/null
rm m.obj
# A process that opens this file dies. The first start of the server dies; the second lets a copy of itself die.
cat >ends.c <<'C'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <string.h>
static void look(const char* path) { if (strstr(path, "killer.bx")) raise(SIGSEGV); }
#define OPEN(name)                                             \
  int name(const char* path, int how, ...) {                   \
    va_list more;                                              \
    va_start(more, how);                                       \
    const int rights = how & O_CREAT ? va_arg(more, int) : 0;  \
    va_end(more);                                              \
    look(path);                                                \
    return ((int (*)(const char*, int, ...))dlsym(RTLD_NEXT, #name))(path, how, rights); \
  }
OPEN(open)
OPEN(open64)
C
"${CC:-cc}" -shared -fPIC -O1 -o ends.so ends.c -ldl || exit 3
(LD_PRELOAD=$work/ends.so "$program" serve --socket "$socket" --save kept.bx; exit $?) >ended 2>&1
is 'a command ends a start' $? 139
LD_PRELOAD=$work/ends.so begin --socket "$socket" --save kept.bx
has 'the next start goes on without it' "$(cat log)" '4 commands of the history'
out=$(host '
print(s.eval("ball.radius"), "last" in s.do("list")["said"], s.do("set-aside")["said"].count("Set aside"))
s.do("save")')
is 'and without what needs the file that is missing' "$out" "{'ball.radius': 3} True 4"
has 'its reason is told' "$(grep -A1 'command 3 ' kept.bx.set-aside)" 'signal 11'
end
begin --socket "$socket" --save kept.bx
is 'a later start has no message about it' "$(grep -c set-aside log)" 0
end
is 'and nothing is left of the trial' "$(ls -A | grep -c starting)" 0

# ---- TCP
begin show.bx --tcp 127.0.0.1:0
port=$(sed -nE 's/^serving at 127.0.0.1:([0-9]+);.*/\1/p' log) token=$(sed -n 's/^token //p' log)
out=$(timeout 60 python3 -c "
from betwixt_client import Server, Refused
import socket
with Server('127.0.0.1:$port', token='$token') as s: print(s.do('create box box')['ok'])
try: Server('127.0.0.1:$port', token='no')
except Refused as e: print(e.answer['error'])
c = socket.create_connection(('127.0.0.1', $port))
c.sendall(b'create a sphere\ntoken $token\n')
f = c.makefile()
print(f.readline(), f.readline(), sep='', end='')
c = socket.create_connection(('127.0.0.1', $port))
c.sendall(b'token a\ntoken b\ntoken c\ntoken $token\ntime\n')
print(c.makefile().read().count('this is not the token'))
" 2>&1)
is 'a token lets in' "$out" 'True
this is not the token
{"line":0,"ok":false,"error":"this is not the token","hint":"the first line must be: token TOKEN"}
{"line":0,"ok":true}
3'
end
"$program" serve --tcp 0.0.0.0:0 2>err
is 'no address that others reach' "$?-$(head -n 1 err)" '2-betwixt: error: --tcp: other machines can reach 0.0.0.0:0'

"$program" serve --tcp 127.0.0.1:70000 2>err
is 'no port above 65535' "$?-$(head -n 1 err)" "2-betwixt: error: --tcp: '70000' is not a port"
printf '0123456789abcdef0123\n' >token
chmod 644 token
"$program" serve --tcp 127.0.0.1:0 --token-file token 2>err
is 'no token that others may read' "$?-$(tr -d '\n' <err)" "2-betwixt: error: --token-file: other users can read 'token'  to protect it: chmod 600 token"
chmod 600 token
begin show.bx --tcp 127.0.0.1:0 --token-file token --hosts 3
port=$(sed -nE 's/^serving at 127.0.0.1:([0-9]+);.*/\1/p' log)
out=$(timeout 60 python3 -c "
from betwixt_client import Server, Refused, Gone
import socket, time
strangers = [socket.create_connection(('127.0.0.1', $port)) for _ in range(200)]
hosts = [Server('127.0.0.1:$port', token='0123456789abcdef0123') for _ in range(3)]
print(all(h.do('time')['ok'] for h in hosts))
try: Server('127.0.0.1:$port', token='0123456789abcdef0123')
except Refused as e: print(e.answer['error'])
print(hosts[0].stats()['hosts'])
gone = 0
for s in strangers:
    s.settimeout(0.001)
    try: gone += s.recv(100) == b''
    except TimeoutError: pass
print(gone)
" 2>&1)
is 'strangers take no place of a host' "$out" 'True
the server already has 3 hosts
3
137'
end

# ---- nothing reads its stderr
"$program" serve show.bx --socket "$socket" --save said.bx 2>&- &
server=$!
for _ in {1..200}; do [ -S "$socket" ] && break; sleep 0.05; done
out=$(host 'print(s.do("create box box")["ok"])
flood = socket.socket(socket.AF_UNIX)
flood.connect(where)
flood.settimeout(0.2)
try:
    while True: flood.send(b"help\n" * 100)
except TimeoutError: pass
except OSError: pass
time.sleep(0.5)
print(s.do("create bax box")["ok"])')
is 'standard error is closed' "$out" 'True
True'
has 'and nothing else is written to' "$(head -c 17 .said.bx.journal)" 'betwixt-journal 1'
end
is 'it ends well' "$code" 0
has 'with its history' "$(cat said.bx)" 'create bax box'
rm -f pipe; mkfifo pipe
(head -n 1 <pipe >first) &
"$program" serve show.bx --socket "$socket" 2>pipe &
server=$!
for _ in {1..200}; do [ -S "$socket" ] && [ -s first ] && break; sleep 0.05; done
out=$(host 'flood = socket.socket(socket.AF_UNIX)
flood.connect(where)
flood.settimeout(0.5)
try:
    while True: flood.send(b"help\n" * 100)
except OSError: pass
time.sleep(0.5)
print(s.do("create bax box")["ok"])')
is 'who read standard error has gone' "$out" True
begun=$(date +%s%N)
end
is 'told to end, it ends' "$code" 0
verdict 'within a second' "$([ $(($(date +%s%N) - begun)) -lt 1000000000 ] && echo yes)" "$(($(date +%s%N) - begun)) ns"

# ---- without a script no files are read
begin --socket "$socket"
out=$(host 'try: s.do("use show.bx")
except Refused as e: print(e)')
is 'no files without a script' "$out" "'show.bx' is outside the script's folder (this server has no script, so it reads no files)"
end

# ---- slow values, their statistics, and the history, which has the exact values
slow='local x = 0 for i = 1, 100000 do x = x + i % 7 end'
cat >lines <<BX
procedure late twerper lua "$slow return u * u"
set ball.radius = "$slow return 1 + t / 9"
at 1f ball.position (0 0 0) late
at 61f ball.position (9 0 0)
extend ball.position cycle
BX
begin show.bx --socket "$socket" --save slow.bx --stats --rate 1000 --class ordinary
out=$(host '
for line in open("lines"): s.do(line.rstrip())
s.subscribe("frames", "slow")
slow, until = set(), time.monotonic() + 30
while len(slow) < 2 and time.monotonic() < until:
    slow |= {q["target"] for q in s.stats()["quarantined"]}
print(sorted(slow))
while time.monotonic() < until and open("log").read().count("late_ms") < 1: time.sleep(0.05)')
is 'slow values are named' "$out" "['ball.position', 'ball.radius']"
kill -KILL $server
wait $server 2>/dev/null
out=$(python3 -c '
import json
figures = [json.loads(line) for line in open("log") if line.startswith("{")]
print(len(figures) > 0, "ball.position" in [q["target"] for q in figures[-1]["quarantined"]])')
is 'and printed with --stats' "$out" 'True True'
begin --socket "$socket" --save slow.bx --stats
end
has 'at the end too' "$(tail -n 1 log)" '"quarantined":['
cat show.bx lines >wanted.bx
for at in 1f 31f; do
  "$program" frame slow.bx --at $at -o slow-$at.png --size 64x36
  "$program" frame wanted.bx --at $at -o wanted-$at.png --size 64x36
done
verdict 'the history of a server has the exact frames' "$(cmp slow-1f.png wanted-1f.png && cmp slow-31f.png wanted-31f.png && echo yes)" 'they differ'
verdict 'which differ from each other' "$(cmp -s slow-1f.png slow-31f.png || echo yes)" 'nothing moves'

# ---- time and frames, and no work if no frame is due
begin show.bx --socket "$socket" --wait --rate 120 --class ordinary
has 'says its class' "$(cat log)" 'frames at 120 a second, class ordinary'
out=$(host '
first = s.stats()
time.sleep(0.5)
later = s.stats()
print(later["frames_due"] - first["frames_due"], later["wakes"] - first["wakes"], s.time()["seconds"])
s.do("ticks 120")
s.do("set ball.environments (spin)")
s.do("animate spin every 1t by rotate(1deg, y)")
s.do("start")
events = s.subscribe("frames")
frames = [next(events) for _ in range(60)]
gaps = [b["frame"] - a["frame"] for a, b in zip(frames, frames[1:])]
print(all(g >= 1 for g in gaps), abs(frames[-1]["seconds"] - (frames[-1]["frame"] - 1) / 120) < 1e-9)
s.do("pause")
list(s.events(0.2))
first = s.stats(); time.sleep(0.3); print(s.stats()["frames_due"] - first["frames_due"])
')
is 'frames are made when they are due' "$out" '0 0 0
True True
0'
end

# ---- long lines of two hosts, while a third host changes the document and a fourth asks
begin show.bx --socket "$socket" --save busy.bx
out=$(host '
import threading
s.do("create o{1..300} sphere")
made, stop, slowest = [0, 0, 0], False, 0
def flood():
    f = Server(where)
    while not stop:
        f.do(f"set ball.radius {1 + made[0]}")
        made[0] += 1
def heavy(k):
    h = Server(where, timeout=50)
    for i in range(3):
        h.do(f"set o*.radius {10 * k + i}")
        made[k] += 1
threads = [threading.Thread(target=flood)] + [threading.Thread(target=heavy, args=(k,)) for k in (1, 2)]
for t in threads: t.start()
while made[1] + made[2] < 6 and all(t.is_alive() for t in threads[:1]):
    begun = time.monotonic()
    s.eval("ball.radius")
    slowest = max(slowest, time.monotonic() - begun)
stop = True
for t in threads: t.join()
print(made[1:], slowest < 30, len(set(s.eval("o1.radius", "o300.radius").values())) == 1, s.eval("ball.radius")["ball.radius"] == made[0])
')
is 'whoever is always interrupted gets there, and so does everybody else' "$out" '[3, 3] True True True'
# Twelve hosts ask much at once. The server often begins with the line of one host while it reads the next.
out=$(host '
import threading
until, cut = time.monotonic() + 5, []
def ask(k):
    h = Server(where, timeout=50)
    while time.monotonic() < until:
        try: h.do(f"set o{k}.radius 3") if k % 2 else h.eval(*[f"o{i}.radius" for i in range(1, 250)])
        except Gone as e: cut.append(str(e)); return
threads = [threading.Thread(target=ask, args=(k,)) for k in range(1, 13)]
for t in threads: t.start()
for t in threads: t.join()
print(cut)
')
is 'nobody is cut off for what others ask' "$out" '[]'
# An answer larger than the output buffer, read slowly. The next question is answered after it.
out=$(host '
import socket
for i in range(12):
    s.do(f"at {i + 1}f note \"" + "x" * 900_000 + "\"")
c = socket.socket(socket.AF_UNIX)
c.connect(where)
c.sendall(b"history\n" + b"time\n" * 3)
got = []
while sum(part.count(b"\n") for part in got) < 4:
    got.append(c.recv(1 << 18))
    if not got[-1]: break
    time.sleep(0.01)
got = b"".join(got).split(b"\n")
print(len(got[0]) > 10_000_000, [json.loads(line)["line"] for line in got[:-1]])
')
is 'who reads slowly has its answer, however long' "$out" 'True [1, 2, 3, 4]'
end
has 'and all is in the history' "$(grep -c 'set o\*' busy.bx)" 6

# ---- pictures in shared memory, and a film
begin show.bx --socket "$socket" --to "ring:betwixt-test-$$" --size 64x36
out=$(host "
with Ring('betwixt-test-$$') as r:
    p = r.wait()
    print(p.width, p.height, len(p.rgba), any(p.rgba[0::4]))
    n = r.written
    s.do('background red')
    for _ in range(100):
        p = r.wait(after=n)
        n = r.written
        if p.rgba[0] > 200: break
    print(p.rgba[0] > 200, p.rgba[1] < 50)
    os.kill($server, 15)
    for _ in range(100):
        if r.over: break
        time.sleep(0.05)
    print(r.over)
")
is 'a ring' "$out" '64 36 9216 True
True True
True'
wait $server
is 'the ring goes with its server' "$(ls "/dev/shm/betwixt-test-$$" 2>/dev/null)" ''
begin show.bx --socket "$socket" --to film:out.mp4 --size 64x36 --rate 30
host 's.do("animate spin every 1t by rotate(9deg, y)"); s.do("set ball.environments (spin)"); time.sleep(1); s.do("background red"); time.sleep(0.5)'
end INT
is 'a film' "$code-$(ffprobe -v error -count_frames -select_streams v -show_entries stream=width,r_frame_rate -of csv=p=0 out.mp4)" '0-64,30/1'
seconds=$(ffprobe -v error -show_entries format=duration -of csv=p=0 out.mp4)
is 'as long as it took' "$(awk -v s="$seconds" 'BEGIN { print (s > 1.4 && s < 10) }')" 1
mkdir disk
if mount -t tmpfs -o size=4k tmpfs disk 2>/dev/null; then # only root can make a small disk
  begin show.bx --socket "$socket" --to film:disk/out.mp4 --size 640x360 --rate 30
  host 's.do("animate drift every 1t by translate(0.05 0.02 0)"); s.do("set ball.environments (drift)"); time.sleep(1)'
  end INT
  is 'a film on a full disk' "$code-$(ls -A disk)" '3-'
  has 'a film on a full disk is told' "$(cat log)" 'the disk is full'
  umount disk
fi

# ---- abuse: this host is served whatever other hosts do
begin show.bx --socket "$socket" --hosts 300 --rate 120
cat >abuse.py <<'PY'
import os, random, signal, socket, sys, time
from betwixt_client import Server
where, pid = sys.argv[1], int(sys.argv[2])
random.seed(1)
def raw():
    c = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
    c.settimeout(20)
    c.connect(where)
    return c
def size():
    with open(f"/proc/{pid}/statm") as f:
        return int(f.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20
good = Server(where)
def fine():
    begun = time.monotonic()
    good.do("set ball.radius 2")
    assert good.eval("ball.radius") == {"ball.radius": 2}
    return time.monotonic() - begun
slowest = fine()
before = size()
# Garbage.
for _ in range(20):
    c = raw()
    c.sendall(random.randbytes(50000))
    slowest = max(slowest, fine())
    c.close()
# Half commands, and hosts that die in the middle.
for text in [b"create half sph", b"bundle\nremove ball\n", b"set ball.position (1 2", b"token x", b'note """', b"ball.position\n  1f ("]:
    c = raw()
    c.sendall(text)
    c.close()
for _ in range(10):
    child = os.fork()
    if child == 0:
        c = raw()
        while True:
            c.sendall(b"bundle\nremove ball\ncreate half ")
    time.sleep(0.02)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    slowest = max(slowest, fine())
# A line of 64 MB, and the line after it.
c = raw()
for _ in range(64):
    c.sendall(b"x" * 2**20)
    slowest = max(slowest, fine())
c.sendall(b"\ntime\n")
answers = c.makefile()
print("at most 1048576 bytes" in answers.readline(), '"line":2,"ok":true' in answers.readline())
answers.close()
c.close()
# More hosts than are allowed.
many = []
refused = 0
for _ in range(310):
    many.append(raw())
for m in many:
    try:
        m.sendall(b"time\n")
    except BrokenPipeError:  # the server has already refused this host
        pass
for m in many:
    refused += b"already has" in m.recv(1000)
print(refused)
slowest = max(slowest, fine())
for m in many:
    m.close()
# A host that never reads.
c = raw()
c.settimeout(0.2)
cut = False
for _ in range(20000):
    try:
        c.send(b"help\n" * 100)
    except (BrokenPipeError, ConnectionResetError):
        cut = True
        break
    except TimeoutError:
        pass
print("cut off:", cut)
slowest = max(slowest, fine())
time.sleep(0.3)
print("hosts:", good.stats()["hosts"], "grown by less than 64 MB:", size() - before < 64, file=sys.stdout)
print("served:", slowest < 5)
print("whole:", "half" not in good.history())
PY
out=$(timeout 300 python3 abuse.py "$socket" $server 2>&1)
is 'abuse' "$out" 'True True
11
cut off: True
hosts: 1 grown by less than 64 MB: True
served: True
whole: True'
end
is 'ends well after it' "$code" 0
# A journal that vanishes: the server acknowledges no command that is not stored.
mkdir vanish
begin --socket vanish/s --save vanish/f.bx
said=$(python3 - vanish <<'END'
import os, socket, sys
folder = sys.argv[1]
host = socket.socket(socket.AF_UNIX)
host.connect(f"{folder}/s")
lines = host.makefile("rw")
def ask(line):
    print(line, file=lines, flush=True)
    return '"ok":true' in lines.readline()
print(ask("create a sphere"), end=" ")
os.rename(f"{folder}/.f.bx.journal", f"{folder}/gone")
print(ask("create b sphere"), ask("eval a.radius"), ask("save"), ask("create c sphere"), end="")
END
)
is 'a vanished journal: refused, answered, saved, and taken again' "$said" 'True False True True True'
end
is 'and the film is what was answered' "$(tr '\n' ';' <vanish/f.bx)" 'create a sphere;create c sphere;'
summary
