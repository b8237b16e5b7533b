# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""The session of mcp_test.sh."""

import base64
import json
import os
import struct
import subprocess
import sys
import tempfile

passed = failed = 0


def verdict(name, fine, found=""):
    global passed, failed
    if fine:
        passed += 1
    else:
        failed += 1
        print(f"FAILED {name}: {found}")


class Server:
    def __init__(self, program, folder, *files):
        self.process = subprocess.Popen([program, "mcp", *files], cwd=folder, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.last = 0

    def line(self, text):
        self.process.stdin.write(text + "\n")
        self.process.stdin.flush()

    def ask(self, method, **params):
        self.last += 1
        self.line(json.dumps({"jsonrpc": "2.0", "id": self.last, "method": method, "params": params}))
        answer = json.loads(self.process.stdout.readline())
        assert answer["id"] == self.last, answer
        return answer

    def tool(self, name, **args):
        """Returns whether the tool failed, its text and its picture."""
        result = self.ask("tools/call", name=name, arguments=args)["result"]
        text = "".join(c["text"] for c in result["content"] if c["type"] == "text")
        pictures = [base64.b64decode(c["data"]) for c in result["content"] if c["type"] == "image"]
        return result["isError"], text, pictures

    def end(self):
        self.process.stdin.close()
        return self.process.wait()


def makes_a_film(program, folder):
    server = Server(program, folder)
    hello = server.ask("initialize", protocolVersion="2025-03-26", capabilities={})["result"]
    verdict("it says who it is", hello["serverInfo"]["name"] == "betwixt" and "tools" in hello["capabilities"], hello)
    server.line(json.dumps({"jsonrpc": "2.0", "method": "notifications/initialized"}))  # has no answer
    tools = {t["name"]: t for t in server.ask("tools/list")["result"]["tools"]}
    verdict("its tools", set(tools) == {"help", "open", "list", "eval", "frame", "edit", "write", "save"}, sorted(tools))
    verdict("each has a schema", all(t["inputSchema"]["type"] == "object" and t["description"] for t in tools.values()))

    wrong, text, _ = server.tool("help")
    verdict("help lists words", not wrong and "create" in text and "sphere" in text, text[:200])
    wrong, text, _ = server.tool("help", word="ease-in")
    verdict("help of a word", not wrong and "ease-in" in text, text)
    verdict("no help", server.tool("help", word="flurb")[0])

    rows = "create ball sphere color=gold\nball.position\n  1f (0 0 0)\n  25f (4 2 0) linear\n"
    wrong, text, _ = server.tool("edit", lines=[rows])
    verdict("rows below their sheet", not wrong, text)
    values = json.loads(server.tool("eval", targets=["ball.position"], times=["1f", "13f", "25f"])[1])
    at = [t["values"]["ball.position"] for t in values["times"]]
    verdict("half of the way at half of the time", at == [[0, 0, 0], [2, 1, 0], [4, 2, 0]], at)
    wrong, text, pictures = server.tool("frame", at="13f", width=320)
    size = struct.unpack(">II", pictures[0][16:24]) if pictures else None
    verdict("a picture", not wrong and pictures[0][:4] == b"\x89PNG" and size == (320, 180), size)
    wrong, text, pictures = server.tool("frame", at="13f", width=10**9)
    verdict("a huge picture is made smaller", not wrong and struct.unpack(">I", pictures[0][16:20])[0] == 1920, text)

    wrong, text, _ = server.tool("edit", lines=["create a box", "create cube bx"])
    verdict("all lines or none", wrong and "did you mean 'box'" in text and "a: box" not in server.tool("list")[1], text)
    for name, args, why in (("eval", {"at": "1s"}, "'eval' has no argument 'at'; it has targets, times"),
                            ("open", {"path": "a.bx"}, "'open' has no argument 'path'; it has file"),
                            ("open", {}, "'open' needs the argument 'file'"), ("frame", {"at": 1}, "'at' of 'frame' must be a text"),
                            ("edit", {"lines": ["a", 2]}, "'lines' of 'edit' must be a list of texts"),
                            ("frame", {"width": "9"}, "'width' of 'frame' must be a whole number")):
        wrong, text, _ = server.tool(name, **args)
        verdict(f"which argument is wrong: {name} {args}", wrong and text.strip() == why + ".", text)
    wrong, text, _ = server.tool("write", text="create ball spere\n")
    verdict("a wrong text changes nothing", wrong and "ball: sphere" in server.tool("list")[1], text)
    server.tool("edit", lines=["create cube box"])
    server.tool("edit", lines=["undo"])
    verdict("undo", "cube" not in server.tool("list")[1])

    wrong, text, _ = server.tool("save", file="film.bx")
    verdict("it saves", not wrong and open(f"{folder}/film.bx").read() == rows, text)
    verdict("another begins with the file", Server(program, folder, "film.bx").end() == 0)
    verdict("it ends with its input", server.end() == 0)


def must_not(program, folder):
    server = Server(program, folder)
    for name, args in (
        ("save", {"file": "../away.bx"}), ("save", {"file": "/tmp/away.bx"}), ("save", {"file": "film.sh"}), ("save", {}),
        ("open", {"file": "/etc/passwd"}), ("open", {"file": "link/away.bx"}), ("open", {}),
        ("edit", {"lines": ["save /tmp/away.bx"]}), ("edit", {"lines": ["plot ball.position /tmp/x.svg"]}),
        ("edit", {"lines": [["a"]]}), ("edit", {"lines": 7}), ("frame", {"at": "soon"}), ("eval", {"targets": ["["]}),
    ):  # fmt: skip
        os.path.lexists(f"{folder}/link") or os.symlink("/tmp", f"{folder}/link")
        wrong, text, _ = server.tool(name, **args)
        verdict(f"refused: {name} {args}", wrong and text, text)
    for line, code in (("{", -32700), ("7", -32600), ("[]", -32600), ('{"id": 1}', -32600), ('{"id": 1, "method": "x"}', -32601),
                       ('{"id": 1, "method": "tools/call", "params": 3}', -32602), ("[" * 200 + "]" * 200, -32600),
                       ('{"id": 1, "method": "tools/call", "params": {"name": "flurb"}}', -32602),
                       ('{"id": 1, "method": "tools/call", "params": {"name": 7}}', -32602)):  # fmt: skip
        server.line(line)
        answer = json.loads(server.process.stdout.readline())
        verdict(f"refused: {line[:60]}", answer.get("error", {}).get("code") == code, answer)
    verdict("it goes on", server.ask("ping")["result"] == {})
    verdict("it ends", server.end() == 0)


def json_of_commands(program, folder):
    def run(*args):
        return subprocess.run([program, *args], cwd=folder, capture_output=True, text=True)

    with open(f"{folder}/wrong.bx", "w") as file:
        file.write("create ball sphere\ncreate b sphere colour=gold\n")
    made = run("check", "wrong.bx", "--json")
    said = json.loads(made.stdout)
    place = {k: said["messages"][0][k] for k in ("severity", "code", "file", "line", "column", "length", "instead")}
    verdict("check --json: the place and the correction", made.returncode == 1 and not said["ok"] and place == {
        "severity": "error", "code": "name", "file": "wrong.bx", "line": 2, "column": 17, "length": 6, "instead": "color"}, said)  # fmt: skip
    with open(f"{folder}/right.bx", "w") as file:
        file.write("range 1f 10f\ncreate ball sphere\n")
    made = run("check", "right.bx", "--json")
    verdict("check --json of a good film", json.loads(made.stdout) == {"ok": True, "objects": 1, "frames": 10, "messages": []}, made.stdout)
    said = json.loads(run("help", "--json").stdout)
    words = {(w["group"], w["word"]): w for w in said["words"]}
    color = words[("functions", "color")]
    verdict("help --json: a function", color["default"] == "white" and color["sentence"] and color["of"], color)
    verdict("help --json: commands", {"render", "frame", "mcp"} <= {c["name"] for c in said["commands"]})
    verdict("help --json: groups", {w["group"] for w in said["words"]} >= {"commands", "kinds", "twerpers", "filters", "options"})


for part in (makes_a_film, must_not, json_of_commands):
    with tempfile.TemporaryDirectory() as there:
        part(sys.argv[1], there)
print(f"{passed} passed, {failed} failed")
sys.exit(failed > 0)
