# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Tests the answers of `betwixt lsp`: lsp_cases.py PROGRAM FOLDER. Prints a line for each case: its name, yes or no,
the reason."""
import os
import subprocess
import sys
import time

from lsp_client import Client, part, uri_of, with_edits

program, folder = sys.argv[1:]


def case(name, got, wanted):
    print(name, "yes" if got == wanted else "no", f"{got!r} is not {wanted!r}", sep="\t")


def put(name, text):
    with open(os.path.join(folder, name), "w", newline="") as f:
        f.write(text)


def eval_of(text, *targets):
    put("eval.bx", text)
    return subprocess.run([program, "eval", os.path.join(folder, "eval.bx"), "--at", "1f,7f,24f", *targets, "--json"],
                          capture_output=True, text=True, check=True).stdout


FILM = """# a ball, \U0001F600
rate 24
create ball   sphere radius=1 color=gold
create wheel{1..3} cylinder
ball.position
  12f (4 1 0) linear
  1f   (0 10 0)
at 3f note "e\u0301 \U0001F600 ball"
set ball.radius = "1 + value('ball.position').x"
"""
film = uri_of(os.path.join(folder, "a film.bx"))

client = Client(program, "lsp", "--stdio")
capabilities = client.begin()
case("places are in UTF-16", capabilities["positionEncoding"], "utf-16")
client.open(film, FILM)
case("a film without errors", client.diagnostics(film, 1), [])

# Diagnostics: the exact place of an error, with the suggestion of the program.
client.change(film, 2, {"range": {"start": {"line": 4, "character": 5}, "end": {"line": 4, "character": 13}},
                        "text": "positon"})
broken = client.diagnostics(film, 2)
case("an error", broken, [{"range": {"start": {"line": 4, "character": 5}, "end": {"line": 4, "character": 12}},
                          "severity": 1, "source": "betwixt",
                          "message": "'ball', a sphere, has no function 'positon'\ndid you mean 'position'?",
                          "data": {"instead": "position"}}])
fix = client.of("codeAction", film, range=broken[0]["range"], context={"diagnostics": broken})
case("what was meant", [a["title"] for a in fix], ["replace by 'position'"])
client.change(film, 3, {"range": broken[0]["range"], "text": "position"})
case("mended", client.diagnostics(film, 3), [])
client.change(film, 4, {"range": {"start": {"line": 7, "character": 23}, "end": {"line": 7, "character": 23}},
                        "text": " oops"})
wrong = client.diagnostics(film, 4)
case("behind an emoji and a mark", [d["range"] for d in wrong],
     [{"start": {"line": 7, "character": 24}, "end": {"line": 7, "character": 28}}])
client.change(film, 5, {"text": FILM})
case("the whole text anew", client.diagnostics(film, 5), [])

# Words
labels = [i["label"] for i in client.at("completion", film, 2, 17)["items"]]
case("kinds are completed", labels, ["sphere"])
offered = client.at("completion", film, 5, 20)["items"]
case("ways are completed", [i["label"] for i in offered if "lin".startswith(i["label"][:3])], ["linear"])
case("with a sentence", offered[0]["documentation"], "Linear to the next event; with stops, linear from stop to stop, as in CSS.")
case("and a place", offered[0]["textEdit"]["range"],
     {"start": {"line": 5, "character": 14}, "end": {"line": 5, "character": 20}})
case("none in a remark", client.at("completion", film, 0, 5)["items"], [])
hover = client.at("hover", film, 2, 8)
case("hover", (part(FILM, hover["range"]), hover["contents"]["value"].split("\n")[1]), ("ball", "ball, a sphere"))
case("hover of a verb", "Makes an object" in client.at("hover", film, 2, 2)["contents"]["value"], True)
case("no hover in a remark", client.at("hover", film, 0, 4), None)
case("usage", client.at("signatureHelp", film, 4, 3), None)
case("usage of a verb", client.at("signatureHelp", film, 2, 20)["signatures"][0]["label"][:16], "create NAME KIND")

# Names
case("definition", [part(FILM, d["range"]) for d in client.at("definition", film, 4, 2)], ["ball"])
case("definition of one of many", [part(FILM, d["range"]) for d in client.at("definition", film, 3, 9)], ["wheel{1..3}"])
uses = client.at("references", film, 4, 2, context={"includeDeclaration": True})
case("references", [(r["range"]["start"]["line"], part(FILM, r["range"])) for r in uses],
     [(2, "ball"), (4, "ball"), (8, "ball"), (8, "ball")])
case("references without the definition",
     len(client.at("references", film, 4, 2, context={"includeDeclaration": False})), 3)
case("highlights", len(client.at("documentHighlight", film, 4, 2)), 4)
case("what can be renamed", client.at("prepareRename", film, 4, 2)["placeholder"], "ball")
edits = client.at("rename", film, 4, 2, newName="planet")["changes"][film]
renamed = with_edits(FILM, edits)
case("renamed", renamed.count("planet"), 4)
case("the film is the same", eval_of(renamed, "planet.position", "planet.radius").replace("planet", "ball"),
     eval_of(FILM, "ball.position", "ball.radius"))
refused = client.ask("textDocument/rename", textDocument={"uri": film}, position={"line": 4, "character": 2},
                     newName="wheel2")
case("a name that is taken", refused["error"]["message"], "'wheel2' already exists")

# The text as a whole
put("tidy.bx", FILM)
tidied = subprocess.run([program, "tidy", os.path.join(folder, "tidy.bx")], capture_output=True, text=True).stdout
once = with_edits(FILM, client.of("formatting", film, options={"tabSize": 2, "insertSpaces": True}))
case("formatting is what tidy does", once, tidied)
ranged = with_edits(FILM, client.of("rangeFormatting", film, options={}, range={
    "start": {"line": 5, "character": 0}, "end": {"line": 6, "character": 3}}))
case("a part of it", ranged.split("\n")[2:7],
     ["create ball   sphere radius=1 color=gold", "create wheel{1..3} cylinder", "ball.position", "  1f   (0 10 0)",
      "  12f  (4 1 0)   linear"])
client.change(film, 6, {"text": once.replace("\n", "\r\n")})
case("what is tidy stays, with its ends of lines", client.of("formatting", film, options={}), [])
client.change(film, 7, {"text": FILM.replace("\n", "\r\n")})
crlf = with_edits(FILM.replace("\n", "\r\n"), client.of("formatting", film, options={}))
case("ends of lines stay", crlf, once.replace("\n", "\r\n"))
client.change(film, 8, {"text": FILM})
names = client.of("documentSymbol", film)
case("symbols", [(s["name"], part(FILM, s["selectionRange"]), s["detail"]) for s in names],
     [("ball", "ball", "sphere"), ("wheel{1..3}", "wheel{1..3}", "cylinder"), ("ball.position", "ball.position", "")])
case("folds", client.of("foldingRange", film), [{"startLine": 4, "endLine": 6}])
colors = client.of("documentColor", film)
case("colours", [(part(FILM, c["range"]), round(c["color"]["green"], 3)) for c in colors], [("gold", 0.843)])
ways = client.of("colorPresentation", film, color={"red": 1, "green": 0, "blue": 0, "alpha": 1},
                 range=colors[0]["range"])
case("ways to write one", [w["label"] for w in ways], ["red", "#ff0000", "rgb(1 0 0)"])

# Other files
put("part.bx", "create lamp light\nset lamp.range\n")
main = uri_of(os.path.join(folder, "main.bx"))
client.open(main, "use part.bx\nset lamp.range 3\n")
in_part = client.diagnostics(uri_of(os.path.join(folder, "part.bx")))
case("what is wrong in a file that is used", [d["range"]["start"]["line"] for d in in_part], [1])
case("is not said of the one that uses it", client.diagnostics(main), [])
there = client.at("definition", main, 1, 5)
case("a definition in another file", there[0]["uri"], uri_of(os.path.join(folder, "part.bx")))
put("part.bx", "create lamp light\n")
client.notify("workspace/didChangeWatchedFiles", changes=[])
case("a file that was changed", client.diagnostics(uri_of(os.path.join(folder, "part.bx"))), [])

# Invalid messages, and the end
case("an unknown request", client.ask("textDocument/dance")["error"]["code"], -32601)
client.send_bytes(b"Content-Length: 3\r\n\r\n{]}")
case("no JSON", client.wait(None)["error"]["code"], -32700)
client.send_bytes(b"Content-Length: 99999999999999\r\n\r\n")
case("a message without end", client.wait(None)["error"]["code"], -32700)
client.process.stdin.close()
case("it ends with its input", client.process.wait(timeout=20), 1)

other = Client(program, "lsp")
other.begin()
case("it ends as it is told to", other.end(), 0)
rude = Client(program, "lsp")
rude.notify("exit")
case("an end without a farewell", rude.process.wait(timeout=20), 1)
half = Client(program, "lsp")
half.send_bytes(b"Content-Length: 100\r\n\r\n{")
half.process.stdin.close()
case("half a message", half.process.wait(timeout=20), 1)
deaf = Client(program, "lsp")
deaf.process.stdout.close()
deaf.send({"id": 1, "method": "initialize", "params": {}})
time.sleep(0.2)
deaf.process.stdin.close()
case("nobody listens", deaf.process.wait(timeout=20) in (0, 1), True)
