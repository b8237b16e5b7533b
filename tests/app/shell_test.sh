#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the shell: piped sessions, wrong lines, its questions, recovery, two shells on one file, a terminal.
#   shell_test.sh PROGRAM
# shows: G7 G14 G19 G22 G59 G60
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
. "$(dirname -- "$0")/support.sh" || exit 3
export XDG_STATE_HOME=$work/state

# session NAME EXIT-CODE TEXT ARGUMENTS LINES…: runs a session. Its output must contain TEXT.
session() {
  local name=$1 code=$2 text=$3 arguments=$4 got
  shift 4
  # shellcheck disable=SC2086
  said=$(printf '%s\n' "$@" | timeout 60 "$program" shell $arguments 2>&1)
  got=$?
  verdict "$name" "$([ $got = "$code" ] && [[ $said == *"$text"* ]] && echo yes)" "exit code $got (not $code?), said: $said"
}
oks() { grep -cx ok <<<"$said"; }
author() { printf '# by hand\nrate 24\ncreate ball sphere  # round\n' >film.bx && rm -f .film.bx.journal*; }

author
session 'a session' 1 "saved 'film.bx'" film.bx 'ball.position' '  1f (0 0 0)' '9f (1 0 0) linear' 'set ball.text_ 1 # no' \
  'undo' 'redo' 'save'
is 'only the wrong line is refused' "$(oks)" 6
is 'the text' "$(cat film.bx)" '# by hand
rate 24
create ball sphere  # round
ball.position
  1f (0 0 0)
  9f (1 0 0) linear'
is 'what was saved' "$("$program" eval film.bx --at 5f ball.position.x)" "$(printf 'ball.position.x  0.5')"
is 'no journal stays' "$(ls -A | grep -c journal)" 0

# Wrong lines.
session 'near miss of a word' 1 "did you mean 'undo'?" '' 'udno' 'quit'
session 'near miss of a verb' 1 "did you mean 'create'?" '' 'crate b box'
session 'nothing to undo' 1 'nothing to undo' '' undo
session 'no help' 1 "did you mean 'sphere'?" '' 'help sphre'
session 'no such object' 1 "did you mean 'ball'?" film.bx 'describe bal'
session 'never closed' 1 'line:1:' '' 'set a.b (1' 'rate 25' quit discard
session 'what stands below is not lost' 1 '1 command is not saved' '' 'set a.b (1' 'rate 25' 'quit' 'discard'
session 'a word too many' 1 "'twice' is not expected here" '' 'undo twice'
session 'no name' 1 'has no file name yet' '' 'rate 25' save quit discard
session 'a folder' 1 'only a regular file' . quit
session 'no folder' 1 'no folder' none/film.bx quit
session 'help' 0 'usage: copy TARGET' '' 'help copy'
session 'play names what was said' 1 "error: play: 'x' is not a time" film.bx 'play x'
session 'play from behind the end' 1 'play: the film ends before 99f' film.bx 'play 99f'
session 'a style' 1 "did you mean 'wireframe'?" film.bx 'style wirefram'
session 'samples' 1 "the number of samples must be auto or one of 1, 4, 9 or 16" film.bx 'samples 3'
session 'what they are' 0 'size 320x180' film.bx 'size 320x180' 'size'
session 'where it is' 0 'ball is at     (1 0 0)' film.bx 'eval ball at 13f'
session 'exit' 0 '' film.bx exit
session 'a batch is asked nothing' 1 'expected a number here, not a vector' film.bx 'set ball.radius (3 4 0)' 'list' quit
session 'how many' 0 '3 objects' '' 'create s{1..3} box' quit discard
session 'how many is not said' 0 '' -q 'create s{1..3} box' quit discard
is 'only that it is done' "$(grep -c objects <<<"$said")" 0
session 'list' 0 'ball  sphere' film.bx 'list b*'
printf 'rate 25\n\377\n' | "$program" shell >out 2>&1
has 'bytes that are no text' "$(cat out)" 'not a text'
rm -f .betwixt.journal

# Questions.
author
printf 'mine\n' >other.bx
session 'overwrite? no' 0 "File 'other.bx' already exists; overwrite it: yes or no?" film.bx 'rate 25' 'save other.bx' no quit discard
is 'no is no' "$(cat other.bx)" mine
session 'overwrite? yes' 0 "saved 'other.bx'" film.bx 'rate 25' 'save other.bx' yes
is 'yes is yes' "$(tail -n 1 other.bx)" 'rate 25'
author
session 'quit: stay, then save' 0 '2 commands are not saved: save, discard or stay?' film.bx 'rate 25' 'hide ball' quit stay quit save
is 'saved at last' "$(tail -n 1 film.bx)" 'hide ball'
author
session 'open is guarded' 0 'not opened' film.bx 'rate 25' 'open other.bx' stay quit discard
author
rm -f out
{
  printf 'rate 25\n'
  for _ in $(seq 600); do grep -qs ok out && break; sleep 0.05; done  # the film is open
  printf '# another hand\n' >>film.bx
  printf 'save\nno\nquit\ndiscard\n'
} | "$program" shell film.bx >out 2>&1
verdict 'changed by someone else' "$(grep -q 'was changed by another program' out && tail -n 1 film.bx | grep -q another && echo yes)" "$(cat out)"

# Recovery.
author
session 'the end of input keeps the journal' 0 'the journal keeps them: betwixt shell film.bx --recover' film.bx 'rate 25' 'hide ball'
is 'it is there' "$(ls .film.bx.journal)" .film.bx.journal
session 'nobody answers' 0 'of an earlier session are not saved' film.bx
session 'show, recover' 0 '  hide ball' film.bx show recover undo save
is 'recovered' "$(tail -n 1 film.bx)" 'rate 25'
author
session 'again' 0 'not saved' film.bx 'rate 25'
session 'discard' 0 '' 'film.bx --discard' save
is 'discarded' "$(tail -n 1 film.bx)" 'create ball sphere  # round'
session 'once more' 0 'not saved' film.bx 'rate 25'
printf '# a new text\n' >film.bx
session 'of another text' 0 "kept as '" film.bx quit
verdict 'kept aside' "$(grep -q 'rate 25' .film.bx.journal.1 && echo yes)" "$(ls -A)"
author
printf 'garbage\n' >.film.bx.journal
session 'no journal at all' 0 "kept as '" film.bx quit
session 'both options' 2 'xcludes' 'film.bx --recover --discard'

# Two shells.
author
mkfifo hold
"$program" shell film.bx <hold >first 2>&1 &
first=$!
exec 9>hold
printf 'rate 25\n' >&9
for _ in $(seq 300); do grep -q ok first && break; sleep 0.1; done
session 'the second is told' 1 'is read-only' film.bx 'list' 'rate 30' 'save'
printf 'save\n' >&9
exec 9>&-
wait $first
is 'the first goes on' "$(tail -n 1 film.bx)" 'rate 25'

# Plug-ins that are loaded while the shell runs.
author
"${CC:-cc}" -shared -fPIC -I"$root/include" -o all.so "$root/tests/procedure/plugins/all.c" || exit 3
session 'a word that nobody has brought' 1 'power' film.bx 'ball.radius' '  1f 1 power' quit discard
session 'load' 0 "saved 'film.bx'" film.bx 'load all.so' 'ball.radius' '  1f 1 power' '  25f 3' 'set ball.wind.y 7' save
is 'a twerper of a plug-in' "$("$program" eval film.bx --load ./all.so --at 13f ball.radius)" 'ball.radius  1.5'
is 'a function of a plug-in' "$("$program" eval film.bx --load ./all.so --at 1f ball.wind)" 'ball.wind  (1 7 3)'

# Pictures of values, and a terminal.
author
session 'plot' 0 "drawn in 'p.svg'" film.bx 'plot ball.position -> p.svg'
verdict 'an svg' "$(grep -q '<svg' p.svg && echo yes)" 'none'
session 'nothing to plot' 1 'no object' film.bx 'plot bal.position -> q.svg'
if command -v tmux >/dev/null; then
  screen() { tmux -L "betwixt$$" "$@"; }
  screen -f /dev/null new-session -d -x 100 -y 30 "cd '$work' && XDG_STATE_HOME='$work/state' '$program' shell film.bx"
  wait_for() { for _ in $(seq 300); do [[ "$(screen capture-pane -p 2>/dev/null)" == *"$1"* ]] && return; sleep 0.1; done; false; }
  shown() { verdict "terminal: $1" "$(wait_for "$2" && echo yes)" "$(screen capture-pane -p 2>&1)"; }
  shown prompt 'film.bx>'
  screen send-keys 'des' Tab 'ba' Tab Enter
  shown 'completion' 'ball, a sphere'
  screen send-keys 'set ba' Tab '.rad' Tab
  shown 'completion on both sides of a dot' '> set ball.radius'
  screen send-keys C-c
  shown 'dropped' '> set ball.radius
film.bx>'
  # Ctrl-C makes the terminal drop earlier input that is not yet read, so wait for each answer.
  screen send-keys 'nonsense'
  shown 'what is typed' '> nonsense'
  screen send-keys C-c
  shown 'Ctrl-C drops the line' "> nonsense
film.bx>"
  screen send-keys 'set ball.radius 2' Enter
  shown 'a star where something is not saved' 'film.bx*>'
  screen send-keys 'at 3f note (' Enter
  shown 'a line that goes on' '...'
  screen send-keys C-c
  shown 'Ctrl-C drops all of it' '...
film.bx*>'
  screen send-keys Up Up Enter
  shown 'recalled' '> set ball.radius 2
film.bx*>'
  screen send-keys 'help' Enter
  shown 'help comes in pages' 'more: space: next page, q: end'
  screen send-keys q
  shown 'and ends' 'film.bx*>'
  screen send-keys 'set ball.radius (3 4 0)' Enter
  shown 'a value that means nothing' "it can be translated to 'set ball.radius 5': translate or ignore?"
  screen send-keys 'ignore' Enter
  shown 'ignored' 'ignored
film.bx*>'
  # The picture, a change, and the picture again. Input before the prompt may be dropped.
  prompted() { for _ in $(seq 300); do [[ "$(screen capture-pane -p)" == *"$1"$'\nfilm.bx*>' ]] && return; sleep 0.1; done; }
  picture() { # in its colours
    screen send-keys 'play 1f..1f' Enter
    wait_for '= 1/1'
    screen capture-pane -e -p
    screen send-keys q
    prompted 'play 1f..1f'
  }
  with=$(picture)
  verdict 'terminal: a picture' "$([[ $with == *'= 1/1'* ]] && echo yes)" "$with"
  screen send-keys 'hide ball' Enter
  prompted 'hide ball'
  without=$(picture)
  verdict 'terminal: what is changed is seen' "$([ "$with" != "$without" ] && echo yes)" "$with"
  screen send-keys 'undo' Enter
  prompted 'undone: hide ball'
  is 'terminal: and seen again' "$(picture)" "$with"
  screen send-keys 'style wireframe' Enter
  prompted 'style wireframe'
  verdict 'terminal: another style' "$([ "$(picture)" != "$with" ] && echo yes)" "$with"
  screen send-keys 'play 1f' Enter
  wait_for '= 1/'
  screen send-keys s
  shown 'a key for the style' 'hidden-line 960x540 1'
  screen send-keys q
  prompted 'play 1f'
  screen send-keys 'style' Enter
  shown 'and it stays' 'style hidden-line'
  screen send-keys C-d
  shown 'Ctrl-D is guarded' '2 commands are not saved: save, discard or stay?'
  screen send-keys C-c
  shown 'Ctrl-C stays' 'save, discard or stay?
film.bx*>'
  screen send-keys C-d
  for _ in $(seq 300); do [ "$(screen capture-pane -p | grep -c 'discard or stay?')" = 2 ] && break; sleep 0.1; done
  screen send-keys 'discard' Enter
  verdict 'terminal: over' "$(for _ in $(seq 300); do screen has-session 2>/dev/null || { echo yes; break; }; sleep 0.1; done)" 'it is still there'
  verdict 'history' "$(grep -q 'radius' "$work/state/betwixt/history" && echo yes)" "$(ls -R "$work/state")"
  screen kill-server 2>/dev/null
fi
# A journal that vanishes: the shell refuses commands that it cannot store, and `save` begins a new journal.
mkdir vanish
said=$(cd vanish && python3 - "$program" <<'END'
import os, subprocess, sys
shell = subprocess.Popen([sys.argv[1], "shell", "f.bx"], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)
def say(line):
    print(line, file=shell.stdin, flush=True)
    print("eval a.radius", file=shell.stdin, flush=True)  # when this is answered the line was carried out
    while not (answer := shell.stdout.readline()).startswith("a.radius"):
        pass
    return answer.split()[-1]
print(say("create a sphere"), say("save"), end=" ")
os.rename(".f.bx.journal", "gone")
print(say("set a.radius 3"), say("save"), say("set a.radius 4"), end="")
shell.kill()
END
)
is 'a vanished journal' "$said" '1 1 1 1 4'
has 'a new one keeps what is done after the file' "$(cat vanish/.f.bx.journal)" 'set a.radius 4'
summary
