#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests that betwixt-farm treats the stored settings of a film as data. Three scripts play Slurm here; tests/farm uses
# the real one.
farm=$(realpath -- "$(dirname -- "$0")/../../clients/slurm/betwixt-farm")
. "$(dirname -- "$0")/support.sh"
export HOME=$work/home BETWIXT=$program PATH=$work/slurm:$PATH
unset XDG_STATE_HOME
mkdir slurm home
echo 'echo "MaxArraySize = 1001"' >slurm/scontrol
echo 'exit 0' >slurm/squeue
# Accepts jobs and records them.
cat >slurm/sbatch <<'END'
printf '%s\n' "$@" >>"$WORK/sent"
echo "$RANDOM"
END
sed -i '1i #!/bin/bash' slurm/*
chmod +x slurm/*
export WORK=$work
printf 'create a sphere\nat 24f set a.radius 2\n' >'a film.bx'
resumed() { # TEXT ARGUMENT…: said on --resume
  said=$("$farm" --resume "${@:2}" 2>&1)
  code=$?
}

said=$("$farm" 'a film.bx' -o 'a film.mp4' --size '160x90' -- '--comment=$(touch ran) `touch ran` two words ' 2>&1)
is 'a film is sent off' $? 0
settings='a film.mp4.farm/settings'
is 'options are kept as they are' "$(grep '^sbatch_options' "$settings")" 'sbatch_options --comment=$(touch ran) `touch ran` two words '
is 'the script has the name that it has' "$(sed -n 's/^script //p' "$settings")" "$work/a film.bx"

printf 'let who = "you"\ncreate a text text=who\n' >let.bx
has 'a wrong let is an error at once' "$("$farm" let.bx -o let.mp4 --let wo=3 2>&1)" "no 'let wo'"
"$farm" let.bx -o let.mp4 --let 'who=$(touch ran) two  words' --language '' >/dev/null 2>&1
is 'values from outside go to all tasks' "$(grep -c -e '^options --let$' let.mp4.farm/settings)" 1
has 'as they are' "$(cat let.mp4.farm/settings)" 'who=$(touch ran) two  words'

rm sent
resumed '' 'a film.mp4'
is 'what was kept here goes on' $code 0
has 'with what was said before' "$(cat sent)" '--comment=$(touch ran) `touch ran` two words '
cp -r 'a film.mp4.farm' kept

# The folder of another user: settings with another program, with arithmetic that runs a program, with invalid lines.
echo 'touch ran' >evil && chmod +x evil
for line in "s|^program .*|program $work/evil|" 's|^first .*|first a[$(touch ran)]|' 's|^rate .*|$(touch ran)|' 's|^chunk .*|PATH x|' \
  's|^chunk .*|chunk 3; touch ran|' 's|^tasks .*|tasks|'; do
  rm -rf 'a film.mp4.farm' && cp -r kept 'a film.mp4.farm' && sed -i "$line" "$settings"
  resumed '' 'a film.mp4'
  is "not followed: $line" $code 1
done
has 'the message says what would be called' "$("$farm" --resume 'a film.mp4' 2>&1)" 'damaged'
rm -rf 'a film.mp4.farm' && cp -r kept 'a film.mp4.farm'
sed -i "s|^program .*|program $work/other|" "$settings"
resumed '' 'a film.mp4'
is 'another program is not called' $code 1
has 'it is named' "$said" "$work/other render"
has 'and how it would be' "$said" '--trust'
resumed '' 'a film.mp4' --trust
is 'unless you say so' $code 0
rm -rf home/.local
rm -rf 'a film.mp4.farm' && cp -r kept 'a film.mp4.farm'
resumed '' 'a film.mp4'
is 'a folder of another machine is a stranger too' $code 1
rm "$settings" && mkfifo "$settings"
resumed '' 'a film.mp4'
is 'nothing waits for a pipe' $code 1
is 'nothing was run' "$([ -e ran ] && echo yes)" ''
# The log exists before Slurm has started a job, so that you can follow it.
echo 'ls -- "$WORK"/*.farm/log >>"$WORK/seen" 2>&1' >>slurm/sbatch
printf 'rate 24\nrange 1f 48f\nsize 64x36\ncreate ball sphere\n' >ball.bx
rm -rf ./*.farm
"$farm" ball.bx -o ball.mp4 --chunk 12 2>/dev/null
is 'a log is there when it is sent off' "$(grep -c 'frames 1 to 48 are sent off in tasks of 12' ball.mp4.farm/log)" 1
is 'and before any job' "$(sort -u seen)" "$work/ball.mp4.farm/log"
echo 'what a job has said' >>ball.mp4.farm/log
resumed '' ball.mp4
is 'gone on with, the log goes on' "$(sed -n '2p;3s/^[0-9:]* //p' ball.mp4.farm/log)" $'what a job has said\nbetwixt-farm: gone on with'
summary
