#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests `betwixt diff`: words, JSON, exit codes, pictures that are the same to the byte, its page, and Git.
#   diff_test.sh PROGRAM
. "$(dirname -- "$0")/support.sh" || exit 3

cat >old.bx <<'FILM'
rate 24
range 1f 24f
size 96x54
create ball sphere color=red
create lamp light position=(5 10 8)
create eye camera position=(0 0 30)
ball.position
  1f   (0 0 0)
  10f  (0 0 0) hold
  12f  (1 0 0) hold
  20f  (0 0 0)
FILM
sed 's/12f  (1 0 0)/12f  (2 0 0)/' old.bx >new.bx
sed 's/^rate 24/# remark\nrate   24/' old.bx >remark.bx
sed 's/color=red/color=/' old.bx >wrong.bx

check 'the same' 0 '' diff old.bx old.bx
is 'nothing is said' "$said" ''
check 'only the text' 0 'only the text differs' diff old.bx remark.bx
check 'words' 1 'ball.position: event at 12f changed from (1 0 0) hold to (2 0 0) hold' diff old.bx new.bx
check 'a script with an error' 2 'wrong.bx:4' diff old.bx wrong.bx
check 'no script' 2 'none.bx' diff old.bx none.bx
check 'too many' 2 'two scripts, not 3' diff old.bx new.bx old.bx
"$program" diff old.bx new.bx --json --pictures >json
is 'JSON' "$(python3 - <<'PY'
import json
j = json.load(open("json"))
c = j["changes"][0]
print(j["same"], j["same_text"], c["what"], c["part"], c["name"], c["events"][0]["was"], c["events"][0]["after"],
      j["frames"]["compared"], [f["frame"] for f in j["frames"]["differing"]] == list(range(12, 20)))
PY
)" 'False False changed event ball.position 12f (2 0 0) hold 24 True'

# The pictures, by another way.
check 'pictures' 1 'frames 12..19 differ' diff old.bx new.bx --pictures
for f in 1 11 12 19 20 24; do
  for film in old new; do "$program" frame $film.bx --at ${f}f -o $film-$f.png 2>/dev/null; done
  is "frame $f" "$(cmp -s old-$f.png new-$f.png && echo same)" "$([ $f -ge 12 ] && [ $f -le 19 ] || echo same)"
done
check 'all pictures are the same' 0 'all 24 frames are the same to the byte' diff old.bx remark.bx --pictures
check 'a page' 1 '' diff old.bx new.bx --page page.html
is 'three pictures' "$(grep -c 'src="data:image/png;base64,' page.html)" 3
is 'a paragraph about frames' "$(grep -c '^<p>frames 12..19 differ, most at' page.html)" 1
is 'no script' "$(grep -ci '<script' page.html)" 0
has 'its policy' "$(cat page.html)" "default-src 'none'"

# Git, with the lines of the guide.
export HOME=$work GIT_CONFIG_NOSYSTEM=1
PATH=$(dirname "$program"):$PATH
if command -v git >/dev/null; then
  git init -q repository && cd repository || exit 3
  git config user.email a@b.c && git config user.name a
  echo '*.bx diff=betwixt merge=betwixt' >.gitattributes
  git config diff.betwixt.command "$program diff"
  git config merge.betwixt.driver "$program merge %O %A %B --as %P"
  mkdir films && cp ../old.bx films/film.bx && git add -A && git commit -qm old
  cp ../new.bx films/film.bx
  has 'git diff' "$(git diff 2>&1)" 'ball.position: event at 12f changed'
  has 'git diff names the film' "$(git diff 2>&1)" 'films/film.bx'
  cp ../old.bx films/more.bx && git add -A
  has 'a new film' "$(git diff --cached 2>&1)" 'ball added (sphere)'
  cp ../wrong.bx films/film.bx
  has 'a film with an error' "$(git diff 2>&1; echo "code $?")" 'code 0'
  git checkout -q -- films && git reset -q --hard
  # Two authors change neighbouring rows, which a merge by lines cannot do.
  main=$(git rev-parse --abbrev-ref HEAD)
  git checkout -q -b theirs
  sed -i 's/  10f  (0 0 0) hold/  10f  (0 5 0) hold/; s/color=red/color=gold/' films/film.bx && git commit -qam theirs
  git checkout -q "$main"
  sed -i 's/  12f  (1 0 0) hold/  12f  (3 0 0) hold  # mine/' films/film.bx && git commit -qam mine
  is 'git merge' "$(git merge -q theirs -m merged >out 2>&1; echo $?)" 0
  is 'both changes' "$(grep -cE '10f  \(0 5 0\) hold|12f  \(3 0 0\) hold  # mine|color=gold' films/film.bx)" 3
  # The same event: a conflict.
  git checkout -q -b again theirs
  git checkout -q "$main" && sed -i 's/20f  (0 0 0)/20f  (0 0 1)/' films/film.bx && git commit -qam mine2
  git checkout -q again && git merge -q "$main~1" >/dev/null 2>&1
  sed -i 's/20f  (0 0 0)/20f  (0 0 2)/' films/film.bx && git commit -qam theirs2
  git checkout -q "$main"
  is 'a conflict stops Git' "$(git merge again >out 2>&1; echo $?)" 1
  has 'and stands beside the row' "$(cat films/film.bx)" '  20f  (0 0 1)
  # conflict: theirs: 20f (0 0 2)'
  is 'the film still reads' "$("$program" check films/film.bx >/dev/null 2>&1; echo $?)" 0
fi
summary
