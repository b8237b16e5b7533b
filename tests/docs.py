# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Checks the films of the documentation: docs.py PROGRAM.

    ```betwixt         a block that begins like this is a film that must load without a warning
    ```betwixt warns   a block that begins like this is a film that must load with a warning

Also checks that the files of tools/printed.txt are as the program prints them now.
"""

import os
import shutil
import subprocess
import sys
import tempfile
import wave

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "tools"))
from doc_pages import blocks, pages, read  # noqa: E402


def films():
    for page in pages():
        for words, code in blocks(read(page)):
            if words[:1] == ["betwixt"]:
                yield page, "warns" in words, code


def check_film(program, folder, warns, code):
    """Returns None if the film loads as its block says, otherwise the program's messages."""
    script = os.path.join(folder, "film.bx")
    with open(script, "w", encoding="utf-8") as file:
        file.write(code)
    run = subprocess.run([program, "check", script], capture_output=True, text=True)
    output = run.stdout + run.stderr
    return None if run.returncode == 0 and ("warning:" in output) == warns else output or "it has no warning"


def main():
    program, passed, failed, found = os.path.abspath(sys.argv[1]), 0, 0, 0
    with tempfile.TemporaryDirectory() as folder:
        # Some films use these sounds, and this catalogue.
        with open(os.path.join(folder, "de.po"), "w", encoding="utf-8") as catalogue:
            catalogue.write('msgid "The end"\nmsgstr "Ende"\n')
        with wave.open(os.path.join(folder, "music.mp3"), "wb") as sound:
            sound.setparams((1, 2, 8000, 0, "NONE", ""))
            sound.writeframes(bytes(2 * 8000 * 75))
        for name in ("narration.wav", "narration.words"):
            shutil.copy(os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "examples", name), folder)
        examples = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "examples")
        shutil.copy(os.path.join(examples, "videos", "bouncing.mp4"), os.path.join(folder, "talk.mp4"))
        for page, warns, code in films():
            found += 1
            if output := check_film(program, folder, warns, code):
                print(f"FAILED a film of {page}:\n{code}{output}")
                failed += 1
            else:
                passed += 1
    for line in read("tools/printed.txt").splitlines():
        name, path = line.split()
        printed = subprocess.run([program, "help", "--print", name], capture_output=True, text=True).stdout
        if printed == read(path):
            passed += 1
        else:
            print(f"FAILED {path} differs from what 'help --print {name}' prints: call tools/reference.sh PROGRAM")
            failed += 1
    print(f"{passed} passed, {failed} failed")
    return failed > 0 or found < 15


sys.exit(main())
