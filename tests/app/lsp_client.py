# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""A small client of the Language Server Protocol. It starts a server, sends requests and waits for the answers."""
import json
import subprocess
import urllib.parse


class Client:
    def __init__(self, *command, cwd=None):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, cwd=cwd)
        self.last = 0
        self.answers = {}
        self.said = []  # notifications that no test has read yet

    def send_bytes(self, data):
        self.process.stdin.write(data)
        self.process.stdin.flush()

    def send(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.send_bytes(b"Content-Length: %d\r\n\r\n" % len(body) + body)

    def notify(self, method, **params):
        self.send({"method": method, "params": params})

    def receive(self):
        length = None
        while line := self.process.stdout.readline().strip():
            key, _, value = line.partition(b":")
            if key.lower() == b"content-length":
                length = int(value)
        if length is None:
            raise EOFError("the server has ended")
        message = json.loads(self.process.stdout.read(length))
        if "id" in message and "method" not in message:
            self.answers[message["id"]] = message
        else:
            self.said.append(message)
        return message

    def ask(self, method, **params):
        """Returns the whole answer, with `result` or `error`."""
        self.last += 1
        self.send({"id": self.last, "method": method, "params": params})
        return self.wait(self.last)

    def wait(self, number):
        while number not in self.answers:
            self.receive()
        return self.answers.pop(number)

    def result(self, method, **params):
        answer = self.ask(method, **params)
        if "error" in answer:
            raise RuntimeError(f"{method}: {answer['error']['message']}")
        return answer["result"]

    # Scripts, by their URIs

    def begin(self):
        capabilities = self.result("initialize", processId=None, rootUri=None, capabilities={})["capabilities"]
        self.notify("initialized")
        return capabilities

    def open(self, uri, text, version=1):
        self.notify("textDocument/didOpen",
                    textDocument={"uri": uri, "languageId": "betwixt", "version": version, "text": text})

    def change(self, uri, version, *changes):
        self.notify("textDocument/didChange", textDocument={"uri": uri, "version": version},
                    contentChanges=list(changes))

    def diagnostics(self, uri, version=None):
        """Returns the next diagnostics of a text, or those of this version of it."""
        while True:
            for i, m in enumerate(self.said):
                if m["method"] == "textDocument/publishDiagnostics" and m["params"]["uri"] == uri and \
                        (version is None or m["params"].get("version") == version):
                    del self.said[i]
                    return m["params"]["diagnostics"]
            self.receive()

    def at(self, method, uri, line, character, **more):
        return self.result("textDocument/" + method, textDocument={"uri": uri},
                           position={"line": line, "character": character}, **more)

    def of(self, method, uri, **more):
        return self.result("textDocument/" + method, textDocument={"uri": uri}, **more)

    def end(self):
        """Ends the server and returns its exit code."""
        self.ask("shutdown")
        self.notify("exit")
        self.process.stdin.close()
        return self.process.wait(timeout=30)


def uri_of(path):
    return "file://" + urllib.parse.quote(str(path))


def units(text):
    return len(text.encode("utf-16-le")) // 2


def place_of(text, position):
    """Returns the index in a text of a position of the protocol."""
    lines = text.split("\n")
    if position["line"] >= len(lines):
        return len(text)
    before = sum(len(line) + 1 for line in lines[:position["line"]])
    line = lines[position["line"]].removesuffix("\r")
    count = 0
    for i, c in enumerate(line):
        if count >= position["character"]:
            return before + i
        count += units(c)
    return before + len(line)


def part(text, span):
    return text[place_of(text, span["start"]):place_of(text, span["end"])]


def with_edits(text, edits):
    for e in sorted(edits, key=lambda e: place_of(text, e["range"]["start"]), reverse=True):
        text = text[:place_of(text, e["range"]["start"])] + e["newText"] + text[place_of(text, e["range"]["end"]):]
    return text
