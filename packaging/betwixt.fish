# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
set -l commands play render frame eval plot check tidy shell
complete -c betwixt -f
complete -c betwixt -n "not __fish_seen_subcommand_from $commands" -a play -d 'play a film'
complete -c betwixt -n "not __fish_seen_subcommand_from $commands" -a render -d 'make a film'
complete -c betwixt -n "not __fish_seen_subcommand_from $commands" -a frame -d 'make one picture'
complete -c betwixt -n "not __fish_seen_subcommand_from $commands" -a eval -d 'print values at times'
complete -c betwixt -n "not __fish_seen_subcommand_from $commands" -a plot -d 'draw values against time'
complete -c betwixt -n "not __fish_seen_subcommand_from $commands" -a check -d 'report errors and warnings'
complete -c betwixt -n "not __fish_seen_subcommand_from $commands" -a tidy -d 'print a script in its canonical form'
complete -c betwixt -n "not __fish_seen_subcommand_from $commands" -a shell -d 'make a film line by line'
complete -c betwixt -n "not __fish_seen_subcommand_from $commands" -l version -d 'print the version'
complete -c betwixt -s h -l help -d 'explain'
complete -c betwixt -n "__fish_seen_subcommand_from $commands" -l load -r -d 'a plug-in: its words are the script'"'"'s'
complete -c betwixt -n "__fish_seen_subcommand_from $commands" -l read-anywhere -d 'let the script read files outside its folder'
complete -c betwixt -n "__fish_seen_subcommand_from $commands" -k -a '(__fish_complete_suffix .bx)'
complete -c betwixt -n '__fish_seen_subcommand_from render frame plot' -s o -l output -r -F -d 'the file to make'
complete -c betwixt -n '__fish_seen_subcommand_from frame eval' -l at -x -d 'the time'
complete -c betwixt -n '__fish_seen_subcommand_from render play plot' -l frames -x -d 'these only, A..B'
complete -c betwixt -n '__fish_seen_subcommand_from render' -l jobs -x -d 'pictures made at once'
complete -c betwixt -n '__fish_seen_subcommand_from render' -l stats -d 'say how long it took'
complete -c betwixt -n '__fish_seen_subcommand_from render frame play' -l size -x \
  -a '320x180 640x360 960x540 1280x720 1920x1080 3840x2160' -d pixels
complete -c betwixt -n '__fish_seen_subcommand_from render frame play' -l style -x -a 'shaded wireframe hidden-line' -d 'how pictures are drawn'
complete -c betwixt -n '__fish_seen_subcommand_from render frame play' -l samples -x -a '1 4 9 16' -d 'samples a pixel'
complete -c betwixt -n '__fish_seen_subcommand_from render frame' -l no-overwrite -d 'leave alone what is there already'
complete -c betwixt -n '__fish_seen_subcommand_from play' -l loop -d 'again and again'
complete -c betwixt -n '__fish_seen_subcommand_from play' -l terminal -d 'play in the terminal'
complete -c betwixt -n '__fish_seen_subcommand_from eval' -l json -d 'print JSON'
complete -c betwixt -n '__fish_seen_subcommand_from tidy' -l write -d 'write the script back'
complete -c betwixt -n '__fish_seen_subcommand_from shell' -l recover -d 'do again what was not saved'
complete -c betwixt -n '__fish_seen_subcommand_from shell' -l discard -d 'throw away what was not saved'
