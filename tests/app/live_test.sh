#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests live input: films that play in a terminal while OSC messages arrive, and the recording of these.
#   live_test.sh PROGRAM
# The shell itself sends OSC packets, by way of /dev/udp.
# shows: G57
. "$(dirname -- "$0")/support.sh" || exit 3

# A free port.
for ((port = 20000 + RANDOM % 20000; ; ++port)); do
  grep -qi ":$(printf %04X "$port") " /proc/net/udp || break
done
local_line() { grep -i ":$(printf %04X "$port") " /proc/net/udp; }
# Plays the film in a terminal until a q is typed. The terminal's output goes to the file `shown`.
begin() {
  mkfifo keys
  TERM=xterm COLUMNS=80 LINES=24 script -qec "$program play $* --terminal --size 64x36 --listen $port" shown <keys >/dev/null 2>&1 &
  playing=$!
  exec 7>keys
  for _ in {1..2400}; do
    [ -n "$(local_line)" ] && return
    sleep 0.05
  done
}
end() {
  # Types again and again, because the terminal drops input that comes before the program has taken control of it.
  while kill -0 "$playing" 2>/dev/null; do
    (printf q >&7) 2>/dev/null
    sleep 0.1
  done
  exec 7>&-
  wait "$playing"
  code=$?
  rm -f keys
  shown=$(tr -d '\r' <shown)
}
send() { printf "$1" >"/dev/udp/127.0.0.1/$port"; }
await() { # until the status line shows TEXT; a machine with other work may be slow with the first picture
  for _ in {1..2400}; do
    grep -qaF -e "$1" shown && return
    sleep 0.05
  done
}
radius() { # of NUMBER, written as four bytes
  send '/r\0\0,f\0\0'"$1"
}

cat >film.bx <<'BX'
# A ball that listens
rate 24
range 1f 48f
create ball sphere
create eye camera position=(0 0 10)
dial /r to ball.radius
dial /bundled to ball.transparency from 0 2 to 0 1
BX
cp film.bx author.bx

begin film.bx --loop --record out.bx
is 'bound to this machine only' "$(local_line | awk '{ print substr($2, 1, 8) }')" 0100007F
radius '\x40\x20\0\0'
await '/r 2.5'
# A bundle with a bundle in it.
send '#bundle\0\0\0\0\0\0\0\0\1\0\0\0\x28#bundle\0\0\0\0\0\0\0\0\1\0\0\0\x14/bundled\0\0\0\0,i\0\0\0\0\0\1'
await '/bundled 1'
end
is 'quits well' "$code" 0
has 'the message is shown' "$shown" '/r 2.5'
has 'says what it recorded' "$shown" "2 messages recorded in 'out.bx'"
is 'the script is as it was' "$(cat film.bx)" "$(cat author.bx)"
"$program" check out.bx >check 2>&1
is 'the recording is a script' "$?" 0
is 'the number that was sent' "$(grep -A1 '^ball.radius$' out.bx | tail -n 1 | sed -E 's/^  [0-9]+f //')" '1 cut 2.5 linear'
is 'the number in the bundle' "$(grep -A1 '^ball.transparency$' out.bx | tail -n 1 | sed -E 's/^  [0-9]+f //')" '0 cut 0.5 linear'
is "the author's text stands before it" "$(head -n "$(wc -l <author.bx)" out.bx)" "$(cat author.bx)"

# An existing file is not overwritten without the option. The error comes before the film plays.
"$program" play film.bx --terminal --listen "$port" --record out.bx >said 2>&1
is 'not over a recording' "$?" 2
has 'says so' "$(cat said)" 'out.bx already exists'
is 'no folder' "$("$program" play film.bx --listen "$port" --record none/out.bx 2>&1 | head -n 1)" \
  'betwixt: error: there is no folder none'
is 'nothing to record' "$("$program" play film.bx --record new.bx 2>&1 | head -n 1)" \
  'betwixt: error: --record needs live input'
for wrong in 0 65536 x 12x :9000; do
  is "no port: '$wrong'" "$("$program" play film.bx --listen "$wrong" 2>&1 | head -n 1)" \
    "betwixt: error: --listen: \"$wrong\" is not a port"
done

# Without --record nothing is written. Errors are shown, invalid packets are counted, and a flood of packets does no
# harm.
begin film.bx --loop
is 'a port that is taken' "$("$program" play film.bx --listen "$port" 2>&1 | head -n 1)" \
  "betwixt: error: --listen: cannot listen on $port: Address already in use"
send '/q\0\0,f\0\0\0\0\0\0'
await 'no dial has the address /q'
send 'garbage' && send '/r' && send '/r\0\0,f\0\0' && send '/r\0\0,ffff\0\0\0\0' && send '#bundle\0\0\0\0\0\0\0\0\1\x7f\xff\xff\xff/r'
send '#bundle\0\0\0\0\0\0\0\0\1\0\0\0\xff' && send '\xff\xfe\x1b[2J' && send '/\x1b]0;x\x07\0\0\0,\0\0\0'
await ' ignored'
exec 8>"/dev/udp/127.0.0.1/$port"
for ((i = 0; i < 10000; ++i)); do
  case $((i % 4)) in
    0) printf '/r\0\0,f\0\0\x3f\0\0\0' >&8 ;;
    1) printf '\377\0/r,f%d' $i >&8 ;;
    2) printf '/r\0\0,s\0\0abc\0' >&8 ;;
    3) printf '#bundle\0\0\0\0\0\0\0\0\1\0\0\0\x0c/r\0\0,f\0\0\x3f\x80\0\0' >&8 ;;
  esac
done
exec 8>&-
for _ in {1..200}; do # UDP drops what finds no room
  radius '\x3e\x80\0\0'
  sleep 0.3
  grep -qaF '/r 0.25' shown && break
done
end
is 'quits well after a flood' "$code" 0
has 'unknown address' "$shown" 'no dial has the address /q'
has 'garbage is counted' "$shown" ' ignored'
has 'the flood is over' "$shown" '/r 0.25'
verdict 'no sequence from outside reaches the terminal' "$(grep -qaF $'\x1b]0;x' shown || echo yes)" 'an escape'
is 'nothing is written' "$(ls)" "$(printf 'author.bx\ncheck\nfilm.bx\nout.bx\nsaid\nshown')"

# A script with `record` needs no option.
echo 'record on' >>film.bx
begin film.bx --loop
radius '\x3f\x40\0\0'
await '/r 0.75'
end
has 'recorded beside the script' "$(cat film-recorded.bx 2>&1)" '0.75 linear'

summary
