#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Tests the command `betwixt web`: the content of pages, and its errors. tests/web tests pages in a browser.
#   web_test.sh PROGRAM
tests=$(realpath -- "$(dirname -- "$0")")
. "$tests/support.sh" || exit 3
export LC_ALL=C.UTF-8 BETWIXT_PLAYER=$PWD/player.js
printf '%s\n' '// Betwixt 9.9, a player' 'globalThis.played = "by this";' >player.js

# Prints a part of a page. text NAME: a script; files: the names of its files; file NAME: one of them.
cat >ask.py <<'PY'
import base64, html.parser, json, re, sys
class Page(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.scripts, self.inside = [], None
    def handle_starttag(self, tag, attributes):
        if tag == "script":
            self.scripts.append((dict(attributes), [])), setattr(self, "inside", True)
    def handle_endtag(self, tag):
        if tag == "script": self.inside = None
    def handle_data(self, data):
        if self.inside: self.scripts[-1][1].append(data)
page = Page()
page.feed(open(sys.argv[1], encoding="utf-8", newline="").read())
plain = lambda data: re.sub(r"<\\(\\*(?:/script|script|!--))", r"<\1", "".join(data), flags=re.I)
texts = {a["data-name"]: plain(d)[1:] for a, d in page.scripts if a.get("type") == "text/betwixt"}
files = next((json.loads(plain(d)) for a, d in page.scripts if "data-betwixt-files" in a), {})
what = sys.argv[2]
if what == "text": sys.stdout.write(texts[sys.argv[3]])
elif what == "texts": print(*texts)
elif what == "files": print(*sorted(files))
elif what == "file": sys.stdout.buffer.write(base64.b64decode(files[sys.argv[3]]))
PY
ask() { python3 ask.py "$@"; }

# A page contains the reader of files only if a film has a file for it.
printf '%s\n' '// Betwixt 9.9' 'first();' '// begin of the reader' 'reads();' '// end of the reader' 'last();' >parts.js
printf 'create a sphere\n' >plain.bx
printf 'create a sphere\ncreate m mesh file="t.obj"\n' >with.bx
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >t.obj
BETWIXT_PLAYER=$PWD/parts.js check 'no files: a page' 0 '' web plain.bx -o plain.html
is 'no files: no reader' "$(grep -cE '^(first|reads|last)|of the reader' plain.html)" 2
BETWIXT_PLAYER=$PWD/parts.js check 'a file: a page' 0 '1 file' web with.bx plain.bx -o with.html
is 'a file: the reader' "$(grep -cE '^(first|reads|last)' with.html)" 3
BETWIXT_PLAYER=$PWD/parts.js check 'linked: a page' 0 '' web plain.bx -o linked.html --link
is 'linked: all' "$(cmp parts.js betwixt-player.js && echo same)" same
rm -f plain.bx with.bx t.obj plain.html with.html linked.html betwixt-player.js betwixt-page.css

printf '# ball.bx — a ball & more\nrate 12\n\ncreate ball sphere' >ball.bx
check 'a page' 0 '1 film, 0 files' web ball.bx -o ball.html
is 'its text can be read' "$(ask ball.html text ball.bx)" "$(cat ball.bx)"
has 'what it is about' "$(cat ball.html)" '<p>a ball &amp; more</p>'
has 'its title' "$(cat ball.html)" '<title>ball</title>'
has 'what plays is in it' "$(cat ball.html)" 'globalThis.played = "by this";'
has 'its text is edited' "$(cat ball.html)" '<betwixt-editor>'
check 'without the text box' 0 '' web ball.bx -o alone.html --no-edit --title '<b> & "c"' --size 640x360
is 'there is none' "$(grep -c 'betwixt-editor>' alone.html)" 0
has 'a title of its own' "$(cat alone.html)" '<h1>&lt;b&gt; &amp; &quot;c&quot;</h1>'
has 'a size of its own' "$(cat alone.html)" '.fixed { width: 640px; height: 360px; }'

# Text that would end the script element is escaped, and is read back unchanged.
printf '%s\n' '# </script> <\/script> <!-- <script> <\\!-- </SCRIPT > — ümläut 🎈' 'create ball sphere' '' '' >odd.bx
check 'a text with ends of scripts' 0 '' web odd.bx -o odd.html
ask odd.html text odd.bx >back.bx
is 'is the same again' "$(cmp odd.bx back.bx && echo same)" same

# Files.
mkdir meshes
printf 'solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n' >meshes/one.stl
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >meshes/two.obj
echo 'set ball.color gold' >gold.bx
cat >full.bx <<'BX'
create ball sphere
use gold.bx
create a mesh file="meshes/one.stl"
create b mesh file="meshes/two.obj" position=(2 0 0)
create t text text="on" font="DejaVu Serif" position=(0 2 0)
create eye camera position=(1 1 8) look-at=(1 1 0)
BX
check 'a film with files' 0 '1 film, 4 files' web full.bx -o full.html
is 'all are in the page' "$(ask full.html files)" 'fonts/DejaVuSerif.ttf gold.bx meshes/one.stl meshes/two.obj'
is 'as they are' "$(ask full.html file meshes/two.obj | cmp - meshes/two.obj && ask full.html file gold.bx | cmp - gold.bx && echo same)" same
is 'but for what pages cannot read' "$(ask full.html file meshes/one.stl | head -c 4)" glTF
mkdir -p other/meshes
cp full.bx gold.bx other && cp meshes/two.obj other/meshes && ask full.html file meshes/one.stl >other/meshes/one.stl
"$program" frame full.bx --at 1f -o a.png --size 320x180 && "$program" frame other/full.bx --at 1f -o b.png --size 320x180
is 'which looks the same' "$(cmp a.png b.png && echo same)" same
check 'several films' 0 '2 films, 4 files' web full.bx ball.bx -o both.html
is 'in their order' "$(ask both.html texts)" 'full.bx ball.bx'
has 'each below its name' "$(cat both.html)" '<h2>ball</h2>'
echo 'set ball.color red' >other/gold.bx
check 'one name, two files' 1 "use the name 'gold.bx' for two different files" web full.bx other/full.bx -o x.html

printf 'create a text text="Größe → Ωμέγα"\ncreate b text text="Москва"' >usual.bx
check 'letters that every page has' 0 '1 film, 0 files' web usual.bx -o usual.html
echo 'create a text text="שלום"' >more.bx
check 'and others' 0 '1 film, 1 file,' web more.bx -o more.html
is 'come with their font' "$(ask more.html files)" fonts/DejaVuSans.ttf

# Many films in one page, with one player script.
check 'what plays may lie beside' 0 '' web ball.bx -o linked.html --link
has 'the page refers to it' "$(cat linked.html)" '<script src="betwixt-player.js"></script>'
is 'and there it is' "$(cmp player.js betwixt-player.js && echo same)" same
has 'to its look too' "$(cat linked.html)" '<link rel="stylesheet" href="betwixt-page.css">'
has 'which is there' "$(cat betwixt-page.css)" 'betwixt-player'
is 'no script or style of its own' "$(grep -cE '<style|style=|<script>' linked.html)" 0
is 'in one that holds all, there is' "$(grep -c '<style>' ball.html)" 1
sed -i '1s/Betwixt [^,]*/Betwixt 0.0.1/' betwixt-player.js
check 'one of another version is replaced' 0 '' web ball.bx -o linked.html --link
is 'by this one' "$(cmp player.js betwixt-player.js && echo same)" same
echo 'my own work' >betwixt-player.js
check 'another file is left alone' 2 'is not a file of Betwixt' web ball.bx -o linked.html --link
is 'as it was' "$(cat betwixt-player.js)" 'my own work'
rm betwixt-player.js && mkfifo betwixt-player.js
check 'nothing waits for a pipe' 2 'is not a file of Betwixt' web ball.bx -o linked.html --link
rm betwixt-player.js

# One line names each loss, and there are no other lines.
lost() { "$program" web "$1" -o lost.html 2>&1 | sed -n 's/^betwixt: notice: //p'; }
is 'a film that loses nothing' "$(lost ball.bx)" ''
ffmpeg -v error -f lavfi -i sine=duration=1 beep.wav
cat >much.bx <<'BX'
create ball sphere
create eye camera position=(0 0 10) shutter=180deg f-stop=2 focus=9
create one sound file="beep.wav"
create two sound file="beep.wav" at=9f
dial /fader/1 to ball.radius
background transparent
BX
is 'one that loses much' "$(lost much.bx)" 'much.bx: pages do not show motion blur (shutter)
much.bx: pages do not show depth of field (f-stop)
much.bx: pages have no live input: a dial (/fader/1)'
is 'a shutter that opens once' "$(printf 'create eye camera position=(0 0 9)\neye.shutter\n  1f off\n  20f 180deg\n' >once.bx; lost once.bx)" \
  'once.bx: pages do not show motion blur (shutter)'

# Standard input and output.
has 'a page of standard input' "$("$program" web - -o stream.html <ball.bx 2>&1)" '1 film, 0 files'
is 'its text can be read, too' "$(ask stream.html text film.bx)" "$(cat ball.bx)"
"$program" web - <ball.bx >stream2.html 2>said
is 'a page to standard output' "$(cmp stream.html stream2.html && echo same)" same
has 'and what it is' "$(cat said)" 'standard output'
check 'beside which nothing lies' 2 'leave out --link' web - --link

# Errors.
check 'no page' 2 'a page must be a .html file, not "ball.mp4"' web ball.bx -o ball.mp4
check 'a page of the usual name' 0 'ball.html' web ball.bx
check 'no film' 2 'FILE' web -o x.html
check 'a film that is not there' 1 "there is no file 'none.bx'" web none.bx -o x.html
echo 'create ball spere' >wrong.bx
check 'a film with errors' 1 "did you mean 'sphere'" web wrong.bx -o x.html
check 'a folder' 1 'is a folder' web meshes -o x.html
check 'a pipe' 2 'only a file can be part of a page' web <(cat ball.bx) -o x.html
check 'no folder for it' 2 'nowhere' web ball.bx -o nowhere/x.html
check 'a size that is none' 2 'is not a size' web ball.bx -o x.html --size large
echo 'create a mesh file="../meshes/two.obj"' >other/out.bx
check 'files elsewhere' 1 'is outside the folder of' web other/out.bx -o x.html --read-anywhere
cp "$tests/../commands/data/scenes/bones.bvh" . && echo 'create man scene file="bones.bvh"' >man.bx
check 'scenes that pages cannot read' 1 "pages do not support the format of the scene 'bones.bvh'" web man.bx -o x.html
is 'nothing is left of all these' "$(ls x.html .x* 2>/dev/null)" ''
echo old >old.html
check 'a page that is there stays' 2 'already' web ball.bx -o old.html --no-overwrite
is 'as it was' "$(cat old.html)" old
BETWIXT_PLAYER=$PWD/none.js check 'without what plays' 3 'there is no such file' web ball.bx -o x.html
echo '"</script>"' >bad.js
BETWIXT_PLAYER=$PWD/bad.js check 'which cannot stand in a page' 3 'cannot be part of a page' web ball.bx -o x.html
summary
