#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Runs the tests of the studio: panels without a display, and a window on a virtual display with real mouse and key
# events.
#   run.sh BUILD [TEST…]
# A TEST is a program, or a name such as sheet_test. "window" runs the story in a real window. "maximised" starts the
# studio again after a window manager has maximised it. "reader" is a screen reader. "pictures" checks its command line.
build=$(realpath -- "${1:?usage: run.sh BUILD [TEST…]}")
here=$(cd -P -- "$(dirname -- "$0")" && pwd)
shift
passed=0 failed=0
folder=$(mktemp -d)
display=
trap '[ -z "$display" ] || kill "$display"; rm -rf "$folder"' EXIT
export XDG_CONFIG_HOME=$folder XDG_DATA_HOME=$folder XDG_CACHE_HOME=$folder XDG_RUNTIME_DIR=$folder BETWIXT_PARSER=$build/bin/betwixt-parser
chmod 700 "$folder"
[ $# -gt 0 ] || set -- "$build"/bin/studio_*_test window maximised reader pictures

# try TEST NAME=VALUE…: runs a test program with environment variables, and adds its counts to the sums.
try() {
  local test=$1 status counts
  shift
  (cd "$folder" && env "$@" timeout 300 "$test" -o -,txt -o "$folder/times,junitxml" >"$folder/log" 2>&1)
  status=$?
  [ -z "${BETWIXT_TIMES-}" ] || sed -nE "s/.*<testcase name=\"([^\"]*)\".* time=\"([0-9.]+)\".*/\2\t${test##*/}: \1/p" \
    "$folder/times" >>"$BETWIXT_TIMES"
  counts=$(sed -nE 's/^Totals: ([0-9]+) passed, ([0-9]+) failed.*/\1 \2/p' "$folder/log" | tail -n 1)
  : "${counts:=0 1}"
  [ "$status" = 0 ] || { grep -E '^(FAIL|QFATAL|   )' "$folder/log" || tail -n 20 "$folder/log"; }
  [ "$status" = 0 ] || [ "${counts#* }" != 0 ] || counts="${counts% *} 1"
  passed=$((passed + ${counts% *})) failed=$((failed + ${counts#* }))
}

# Starts a virtual display, whose mouse and keys xdotool controls. Sets `number`.
open_display() {
  command -v Xvfb >/dev/null && command -v xdotool >/dev/null || {
    echo "without Xvfb and xdotool nothing is tried in a real window"
    return 1
  }
  [ -z "$display" ] || kill "$display"
  rm -f "$folder/display" && mkfifo "$folder/display"
  Xvfb -displayfd 3 -screen 0 1400x900x24 -nolisten tcp -r -noreset 3>"$folder/display" >"$folder/xvfb.log" 2>&1 &
  display=$!
  # Xvfb prints the number of the display when it is ready, or nothing if it cannot start.
  read -r number <"$folder/display" || {
    display=
    failed=$((failed + 1))
    echo "Xvfb does not start:" && tail -n 5 "$folder/xvfb.log"
    return 1
  }
}

in_a_window() {
  local number
  open_display && try "$1" QT_QPA_PLATFORM=xcb DISPLAY=":$number"
}

# Checks that the studio starts again after it was maximised and closed by its key.
maximised() {
  local number
  open_display || return 0
  (
    cd "$folder" || exit
    export DISPLAY=":$number" QT_QPA_PLATFORM=xcb
    printf 'create ball sphere\n' >big.bx
    openbox >openbox.log 2>&1 &
    # The window manager may miss a window that appears while it starts.
    for _ in {1..1000}; do
      wmctrl -m >/dev/null 2>&1 && break
      sleep 0.1
    done
    for how in add,maximized_vert,maximized_horz remove,above; do
      show_big && wmctrl -i -r "$window" -b "$how" && sleep 1 || exit 1
      # Repeats until the window has got the key.
      for _ in {1..2000}; do
        xdotool windowfocus "$window" key ctrl+q 2>/dev/null
        sleep 0.2
        kill -0 $studio 2>/dev/null || break
      done
      wait $studio || exit 1
    done
    # With a change, it asks: Escape stays, and the second button, Discard, closes.
    printf 'set ball.radius 2\n' >change.txt
    show_big --session change.txt && wmctrl -i -r "$window" -b add,maximized_vert,maximized_horz && sleep 1 || exit 1
    ask_by wmctrl -i -c "$window" && xdotool key Escape || exit 1
    sleep 1
    kill -0 $studio 2>/dev/null || exit 1
    ask_by xdotool windowfocus "$window" key ctrl+q && xdotool key Tab key space || exit 1
    wait $studio && ! grep -q radius big.bx
  )
}

# Starts the studio with big.bx. Sets `studio` and `window`.
show_big() {
  timeout 120 "$build/bin/betwixt-studio" big.bx --discard "$@" >said 2>&1 &
  studio=$!
  for _ in {1..4000}; do
    window=$(wmctrl -l 2>/dev/null | awk '/big.bx/ { print $1 }')
    [ -z "$window" ] || break
    kill -0 $studio 2>/dev/null || return 1
    sleep 0.1
  done
  sleep 1
}

# Carries out a command, again until the studio asks about unsaved changes, and gives the question the keys.
ask_by() {
  local question
  for _ in {1..300}; do
    "$@" 2>/dev/null
    sleep 0.3
    question=$(xdotool search --onlyvisible --name '^Betwixt$' 2>/dev/null | tail -n 1)
    [ -z "$question" ] || { xdotool windowfocus "$question" && sleep 0.3 && return 0; }
    kill -0 $studio 2>/dev/null || return 1
  done
  return 1
}

# Uses the studio as a screen reader does: on a display, and on a message bus of its own.
reader() {
  local number
  /usr/bin/python3 -c 'import gi; gi.require_version("Atspi", "2.0")' 2>/dev/null || {
    echo "without gir1.2-atspi-2.0 and python3-gi the studio is not read aloud"
    return 0
  }
  open_display || return 0
  (
    export DISPLAY=":$number" QT_QPA_PLATFORM=xcb
    timeout 600 dbus-run-session -- /usr/bin/python3 "$here/screen_reader.py" "$build/bin/betwixt-studio" "$folder" \
      2>"$folder/log"
  ) || { tail -n 5 "$folder/log" && return 1; }
}

# The command line of the studio. The toolkit has options of the same names (--session, --style), which must not apply.
pictures() (
  cd "$folder" || exit
  printf 'create ball sphere\n' >film.bx
  printf 'set bal.color red\n' >wrong.txt
  printf 'set ball.radius 2\n' >right.txt
  film() { timeout 60 "$build/bin/betwixt-studio" film.bx --discard --screenshot "$@" 2>said; }
  film a.png --session wrong.txt && exit 1
  grep -q "no object 'bal'" said || exit 1
  film a.png --session right.txt --panel sheet --size 400x200 --select ball || exit 1
  # The width and the height in a PNG: 400 and 200.
  [ "$(od -An -tx1 -j16 -N8 a.png | tr -d ' ')" = 00000190000000c8 ] || exit 1
  film a.png --panel nothing && exit 1
  grep -q "no panel 'nothing'" said || exit 1
  # Without a display, or with one that is not there, one sentence.
  for display in '' :77; do
    env -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM DISPLAY=$display timeout 60 "$build/bin/betwixt-studio" film.bx --discard 2>said
    [ $? = 3 ] && [ "$(wc -l <said)" = 1 ] && grep -q 'needs a display' said || exit 1
  done
)

for test in "$@"; do
  case $test in
    window) in_a_window "$build/bin/studio_story_test" ;;
    maximised)
      if maximised; then passed=$((passed + 1)); else failed=$((failed + 1)) && echo 'FAIL  the studio does not start again'; fi
      ;;
    reader)
      if reader; then passed=$((passed + 1)); else failed=$((failed + 1)) && echo 'FAIL  the studio, read by a screen reader'; fi
      ;;
    pictures)
      if pictures; then passed=$((passed + 1)); else failed=$((failed + 1)) && echo 'FAIL  pictures of the studio'; fi
      ;;
    */*) try "$test" QT_QPA_PLATFORM=offscreen ;;
    *) try "$build/bin/studio_$test" QT_QPA_PLATFORM=offscreen ;;
  esac
done
printf '%d passed, %d failed\n' "$passed" "$failed"
[ "$failed" = 0 ]
