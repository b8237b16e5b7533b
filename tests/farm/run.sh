#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Makes films with a Slurm that is started as docs/farm.md describes, on this machine alone. Kills tasks at random and
# makes a node vanish. The film must equal the locally rendered one byte by byte.
#   tests/farm/run.sh PROGRAM [KILLS] [SEED]    takes four minutes; without Slurm it prints a message and succeeds
root=$(cd -P -- "$(dirname -- "$0")/../.." && pwd)
for server in munged slurmctld slurmd sbatch; do
  PATH=$PATH:/usr/sbin command -v $server >/dev/null && continue
  echo "nothing was tried, as there is no $server: apt-get install slurmctld slurmd slurm-client munge"
  exit 0
done
. "$root/tests/app/support.sh" || exit 3
kills=${2:-12} RANDOM=${3:-1}
PATH=$PATH:/usr/sbin
export BETWIXT=$program
trap 'stop; rm -rf "$work"' EXIT
trap 'exit 130' INT TERM HUP
chmod 755 "$work" # munged asks for that
unset "${!SLURM_@}" "${!SBATCH_@}"

# The blocks of code of the page: 1 configures Slurm, 2 starts it, 3 ends it.
block() { awk -v n="$1" '/^```bash/ { here = !--n; next } /^```/ { here = 0 } here' "$root/docs/farm.md"; }
stop() {
  local pid
  [ -z "${farm-}" ] || for pid in $(cat "$farm"/*.pid* 2>/dev/null) $(shells "$work"); do end_tree "$pid"; done
} 2>/dev/null
# Only the folder, the ports (another test may run on this machine) and the timeouts of Slurm differ from the page.
configure() {
  port=$((20000 + RANDOM % 10000))
  eval "$(block 1 | sed "s|^farm=.*|farm=$work/slurm|")"
  sed -i 's/^AuthInfo=.*/&,cred_expire=5/' "$farm/slurm.conf"
  printf '%s\n' SlurmctldPort=$port SlurmdPort=$((port + 1)) SlurmdTimeout=6 KillWait=1 \
    SchedulerParameters=sched_min_interval=100000,batch_sched_delay=0 >>"$farm/slurm.conf"
}
wait_for() { # SECONDS COMMAND…: whether it came true by then
  local until=$((SECONDS + $1))
  shift
  until "$@"; do
    [ $SECONDS -lt $until ] || return 1
    sleep 0.2
  done
}
idle() { [ "$(sinfo --noheader --format=%T --states=idle 2>/dev/null)" = idle ]; }
farm() { "$root/clients/slurm/betwixt-farm" "$@"; }
over() { ! squeue --noheader --jobs="$(tr ' ' , <"$1.farm/jobs")" 2>/dev/null | grep -q .; }
ended() { over "$1" && sleep 0.5 && over "$1"; } # and no other round has begun
sum() { sha256sum <"$1"; }
rounds() { printf '%d' $((1 + $(grep -c 'tasks to do' "$1.farm/log"))); }

# The processes of this test's jobs: shells and the programs that they call. Both have the film's folder as an argument.
shells() { pgrep -f "slurm_script --(${2-task|finish}) $1"; }
programs() { pgrep -f "^$program (render|join) .*$1.*/pictures/"; }
end_tree() { # a process and all below it, at once
  local child
  for child in $(pgrep -P "$1"); do end_tree "$child"; done
  kill -KILL "$1"
}
any() { [ $# = 0 ] || printf '%s' "${*:1 + RANDOM % $#:1}"; }
kill_one() { # KIND FILM: something of it, at random. Fails where there is nothing to kill.
  local all victim
  case $1 in
    program) all=$(programs "$work/$2") ;;
    shell) all=$(shells "$work/$2" task) ;;
    task) all=$(squeue --noheader --array --states=R --name="$2" --format=%i) ;;
    picture) all=$(find "$2.farm/pictures" -name '*.png' -size +0) ;;
  esac
  # shellcheck disable=SC2086 # words they are
  victim=$(any $all)
  case ${victim:+$1} in
    program | shell) kill -KILL "$victim" ;;
    task) scancel "$victim" ;;
    picture) truncate -s $((RANDOM % $(stat -c %s "$victim"))) "$victim" ;;
    *) false ;;
  esac
} 2>/dev/null

cp -r "$root/examples/menagerie.bx" "$root/examples/meshes" .
small=(--size 160x90)
"$program" render menagerie.bx -o local.mp4 "${small[@]}" 2>/dev/null
is 'the local film' $? 0

configure
# If Slurm does not answer or the call is wrong, nothing is submitted.
refused() { # NAME CODE TEXT ARGUMENT…
  said=$(farm "${@:4}" 2>&1)
  is "$1" $? "$2"
  has "$1" "$said" "$3"
  verdict "$1: no folder" "$([ ! -e no.mp4.farm ] && echo yes)" 'there is one'
}
export SLURM_CONF=$farm/slurm.conf
refused 'no Slurm' 3 'Slurm does not answer' menagerie.bx -o no.mp4
echo 'create b bax' >wrong.bx
refused 'a wrong script' 1 "did you mean 'box'?" wrong.bx -o no.mp4
refused 'a wrong option' 2 "did you mean '--size'?" menagerie.bx -o no.mp4 --siz 3x4
refused 'a wrong chunk' 2 "not '0'" menagerie.bx -o no.mp4 --chunk 0
refused 'no film' 2 '-o FILM' menagerie.bx
refused 'a film of no kind' 2 'cannot end in' menagerie.bx -o no.mp5
refused 'between two frames' 2 'between two frames' menagerie.bx -o no.mp4 --frames 1.5f..3f

eval "$(block 2)" >servers.log 2>&1
wait_for 30 idle || { verdict 'the farm begins' no "$(cat servers.log "$farm"/*.log)" && summary; exit; }

# Kills a dozen times at random while the film is made: a program, the shell around it, a task by scancel, a picture.
killed=() kinds=(program shell task picture)
said=$(farm menagerie.bx -o killed.mp4 "${small[@]}" --chunk 5 2>&1)
is 'it is sent off' $? 0
while [ ${#killed[@]} -lt "$kills" ] && ! over killed.mp4; do
  kind=${kinds[${#killed[@]} % 4]}
  kill_one "$kind" killed.mp4 && killed+=("$kind") && sleep 0.$((RANDOM % 9))
done
wait_for 120 ended killed.mp4
is "the film of a farm that was killed ${#killed[@]} times" "$(sum killed.mp4)" "$(sum local.mp4)"
is 'how often it was killed' ${#killed[@]} "$kills"
verdict 'rounds' "$([ "$(rounds killed.mp4)" -gt 1 ] && echo yes)" 'there was one only'
has 'the end is said' "$(tail -n 1 killed.mp4.farm/log)" "$work/killed.mp4 is made"
printf 'killed: %s; rounds: %s\n' "${killed[*]}" "$(rounds killed.mp4)"

# Code with an error at one frame, which the check of 60 of the 120 frames does not find. The error is reported, and the
# frame is not tried again.
{ cat menagerie.bx && printf 'set cow.scale.x = "frame == 62 and nobody.x or 1"\n'; } >erring.bx
farm erring.bx -o erring.mp4 "${small[@]}" --chunk 20 2>/dev/null
is 'an erring film is sent off' $? 0
wait_for 60 ended erring.mp4
verdict 'an erring film is not made' "$([ ! -e erring.mp4 ] && echo yes)" 'it is'
is 'an erring film is not tried again' "$(rounds erring.mp4)" 1
has 'why it is not' "$(<erring.mp4.farm/log)" 'trying again would not help'
has 'which frames' "$(<erring.mp4.farm/log)" 'frames 61 to 80, exit code 1:'
has 'what was wrong' "$(<erring.mp4.farm/log)" 'nobody'

# If a machine always fails (exit code 3), the film is given up after five rounds. When the machine works again,
# --resume continues.
cat >ailing <<SH
#!/bin/bash
[[ \$* == *--plan* || -e $work/well ]] || { echo 'no graphics to be had' >&2; exit 3; }
exec $program "\$@"
SH
chmod +x ailing
BETWIXT=./ailing farm menagerie.bx -o ailing.mp4 "${small[@]}" --frames 1..30 --chunk 15 2>/dev/null
wait_for 60 ended ailing.mp4
is 'rounds of a machine that fails' "$(rounds ailing.mp4)" 5
has 'it is given up' "$(<ailing.mp4.farm/log)" 'ailing.mp4 was not made in 5 rounds'
has 'the last word of a task' "$(<ailing.mp4.farm/log)" 'exit code 3: the machine failed'
has 'it is not begun anew' "$(farm menagerie.bx -o ailing.mp4 2>&1)" "--resume $work/ailing.mp4 goes on"
touch well
farm --resume ailing.mp4 -- --time=5 2>/dev/null
is 'it goes on' $? 0
has 'it goes on once' "$(farm --resume ailing.mp4 2>&1)" 'ailing.mp4 is still being made'
wait_for 60 ended ailing.mp4
"$program" render menagerie.bx -o part.mp4 "${small[@]}" --frames 1..30 2>/dev/null
is 'the film of a machine that was ill' "$(sum ailing.mp4)" "$(sum part.mp4)"

# The film is stopped, its script is changed and restored, and --resume continues.
farm menagerie.bx -o stopped.mp4 "${small[@]}" --chunk 10 2>/dev/null
wait_for 30 test -e stopped.mp4.farm/done/1
xargs scancel <stopped.mp4.farm/jobs
wait_for 30 ended stopped.mp4
verdict 'what is stopped stays so' "$([ ! -e stopped.mp4 ] && echo yes)" 'it was made'
echo '# changed' >>menagerie.bx
has 'a script that was changed' "$(farm --resume stopped.mp4 2>&1)" 'is another one by now'
sed -i '$d' menagerie.bx
farm --resume stopped.mp4 2>/dev/null
wait_for 60 ended stopped.mp4
is 'the film that was stopped' "$(sum stopped.mp4)" "$(sum local.mp4)"

# 16 bits, transparency and sound; and a name with characters that are special for Slurm.
ffmpeg -loglevel error -f lavfi -i sine=440:duration=1 tone.wav
printf '%s\n' 'background transparent' 'create b sphere transparency=0.4' 'b.color' '  1f gold' '  12f red' \
  'create tone sound file="tone.wav" at=3f' >clear.bx
mkdir 'a %j folder'
farm clear.bx -o 'a %j folder/clear.mov' "${small[@]}" --chunk 6 --frames=-1..9 2>/dev/null
wait_for 60 ended 'a %j folder/clear.mov'
"$program" render clear.bx -o clear.mov "${small[@]}" --frames=-1..9 2>/dev/null
is 'a film that is clear, and heard' "$(sum 'a %j folder/clear.mov')" "$(sum clear.mov)"

# A node vanishes with all its processes.
vanish() { # NODE PID-FILE-OF-SLURMD FILM
  local shell
  wait_for 30 some_pictures "$3"
  end_tree "$(<"$2")"
  for shell in $(shells "$work/$3"); do
    grep -qz "^SLURMD_NODENAME=$1$" "/proc/$shell/environ" && end_tree "$(ps -o ppid= -p "$shell" | tr -d ' ')"
  done
  wait_for 60 down "$1"
} 2>/dev/null
some_pictures() { [ "$(find "$1.farm/pictures" -name '*0.png' | wc -l)" -gt 2 ]; }
down() { sinfo --noheader --nodes="$1" --format=%T | grep -q '^down'; }
came_back() { # FILM: made, after all, and by Slurm, which began tasks anew
  wait_for 120 ended "$1"
  is "$1" "$(sum "$1")" "$(sum local.mp4)"
  has "$1: tasks were begun anew" "$(cat "$1".farm/tasks/*.log)" 'restarted 1 times'
  is "$1: rounds" "$(rounds "$1")" 1
}
node=$(hostname -s)
farm menagerie.bx -o vanished.mp4 "${small[@]}" --chunk 40 2>/dev/null
verdict 'Slurm sees that the node is gone' "$(vanish "$node" "$farm/slurmd.pid" vanished.mp4 && echo yes)" "$(sinfo)"
slurmd # it is back
came_back vanished.mp4

pids=$(cat "$farm"/{slurmd,slurmctld,munged}.pid | paste -sd ,)
eval "$(block 3)"
gone() { ! ps -o stat= -p "$pids" | grep -qv '^Z'; }
verdict 'it ends as the page says' "$(wait_for 20 gone && echo yes)" "$pids"

# Two nodes, one of which never comes back: the other makes the film.
rm -r slurm
configure
sed -i -E 's/^(SlurmdPidFile|SlurmdSpoolDir|SlurmdLogFile)=.*/&.%n/; /^SlurmdPort/d
  /^NodeName/d' "$farm/slurm.conf"
echo "NodeName=one,two NodeHostName=$node NodeAddr=127.0.0.1 Port=$((port + 2)),$((port + 3)) CPUs=1" >>"$farm/slurm.conf"
eval "$(block 2 | sed 's/^slurmd$/slurmd -N one; slurmd -N two/')" >servers.log 2>&1
wait_for 30 idle || verdict 'two nodes' no "$(cat servers.log "$farm"/*.log*)"
farm menagerie.bx -o half.mp4 "${small[@]}" --chunk 40 2>/dev/null
verdict 'Slurm sees that one of two is gone' "$(vanish two "$farm/slurmd.pid.two" half.mp4 && echo yes)" "$(sinfo)"
came_back half.mp4
summary
