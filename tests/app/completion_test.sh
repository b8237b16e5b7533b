#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the completions for shells and the manual page: the shells can read them, and they have all options of --help.
#   completion_test.sh PROGRAM
. "$(dirname -- "$0")/support.sh" || exit 3

for what in bash zsh fish manual; do "$program" help --print $what >$what || failed=$((failed + 1)); done
is 'only these can be printed' "$("$program" help --print ksh >/dev/null 2>&1; echo $?)" 2
is 'help does not speak of it' "$("$program" help --help | grep -c -e --print)" 0

# Each installed shell reads its completions.
for call in 'bash -n' 'zsh -n' 'fish --no-execute'; do
  command -v "${call%% *}" >/dev/null && is "$call" "$($call ./"${call%% *}" 2>&1; echo $?)" 0
done
command -v groff >/dev/null && is 'the manual page' "$(groff -man -ww -z manual 2>&1)" ''

# All of them know the options of --help.
commands=$("$program" help | sed -nE '/^Commands/,/^$/s/^  ([a-z]+) .*/\1/p')
is 'commands' "$(wc -w <<<"$commands")" 24
for command in $commands; do
  for option in $("$program" "$command" --help | sed -nE 's/^  (-[a-z],)?(--[a-z-]+).*/\2/p'); do
    for what in bash zsh fish manual; do
      sed 's/\\-/-/g; s/-l \([a-z]\)/--\1/g' $what >plain
      verdict "$command $option is known to $what" "$(grep -qF -e "$option" plain && echo yes)" 'it is not'
    done
  done
done

# completes WORDS WANTED…: checks what bash offers for the last word.
completes() {
  local words wanted=${*:2} COMP_WORDS COMP_CWORD COMPREPLY=()
  read -ra words <<<"$1"
  [[ $1 != *' ' ]] || words+=('')
  COMP_WORDS=("${words[@]}") COMP_CWORD=$((${#words[@]} - 1))
  _betwixt
  is "bash completes '$1'" "$(printf "%s\n" "${COMPREPLY[@]}" | LC_ALL=C sort | xargs)" "$(printf "%s\n" $wanted | LC_ALL=C sort | xargs)"
}
. ./bash
mkdir folder
touch ball.bx ball.txt
completes 'betwixt re' render
completes 'betwixt --v' --version
completes 'betwixt render --s' --section --size --style --samples --shutter --subframes --stats
completes 'betwixt play --o' --overwrite
completes 'betwixt play --m' --mute
completes 'betwixt tidy --l' --language --let --load
completes 'betwixt frame ball.bx --style w' wireframe
completes 'betwixt algebra x --method d' differences
completes 'betwixt serve --to t' terminal
completes 'betwixt render b' ball.bx
completes 'betwixt render ball.bx -o b' ball.bx ball.txt bash
completes 'betwixt render f' folder
completes 'betwixt eval ball.bx --at 2'
completes 'betwixt help gro' ground group grow
completes 'betwixt help dim' dimension
completes 'betwixt help ang' angle
completes 'betwixt help re' reach reach-chain reach-pole reach-share readings rearrange record rectangle redo regular release remove rename render replace reverse revert rewrite
completes 'betwixt help -' --color --help --json --language --let --load --read-anywhere --tex
for what in zsh fish; do is "$what completes words of the language" "$(grep -cw quantise $what)" 1; done
summary
