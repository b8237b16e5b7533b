# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""The build backend for pip: builds the package with CMake and writes it as a wheel."""

import atexit
import base64
import hashlib
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)


def _project():
    with open(os.path.join(HERE, "pyproject.toml"), "rb") as said:
        project = tomllib.load(said)["project"]
    with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as said:
        version = re.search(r"project\(betwixt VERSION ([0-9.]+)", said.read())
    assert version
    return {**project, "version": version[1]}


def _say(words):
    """Prints words, also directly on the terminal, because pip shows printed lines only with -v."""
    print(words, flush=True)
    try:
        with open("/dev/tty", "w", encoding="utf-8") as terminal:
            terminal.write(f"\r\033[K{words}\n")
    except OSError:
        pass  # there is no terminal


def _run(command):
    """Runs a command, and prints a line for each tenth of ninja's steps. After a failure prints the last 40 lines of
    its output and raises CalledProcessError."""
    environment = {"CCACHE_SLOPPINESS": "pch_defines,time_macros,include_file_mtime,include_file_ctime", **os.environ,
                   "NINJA_STATUS": "[%f/%t] "}
    said, tenth = [], 0
    with subprocess.Popen(command, cwd=ROOT, env=environment, text=True, errors="replace", stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT) as running:
        assert running.stdout
        for line in running.stdout:
            said.append(line)
            step = re.match(r"\[(\d+)/(\d+)\]", line)
            if step and int(step[2]) > 3 and 10 * int(step[1]) // int(step[2]) > tenth:
                tenth = 10 * int(step[1]) // int(step[2])
                _say(f"betwixt: building the module, {step[1]} of {step[2]} steps")
    if running.returncode:
        _say("".join(said[-40:]))
        raise subprocess.CalledProcessError(running.returncode, command)


def _built():
    """Builds the package and returns its folder. A release names the folder of a package that is built.
    The build has a folder of its own, so that the next call is short. The usual build of the source tree may be for
    another Python, so it is not changed."""
    if ready := os.environ.get("BETWIXT_BUILT_PYTHON"):
        return ready
    build = os.path.join(ROOT, "build", f"pip-cp{sys.version_info[0]}{sys.version_info[1]}")
    try:
        os.makedirs(build, exist_ok=True)
    except OSError:  # this user cannot write in the source tree
        build = tempfile.mkdtemp(prefix="betwixt-")
        atexit.register(shutil.rmtree, build, True)
    _say(f"betwixt: building the module in {build}: some minutes the first time")
    quick = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    _run(["cmake", "--preset", "release", "-B", build, "-DBETWIXT_PYTHON=ON", "-DBETWIXT_STUDIO=OFF", "-DBETWIXT_TESTS=OFF",
          f"-DPython_EXECUTABLE={sys.executable}", *quick])
    _run(["cmake", "--build", build, "--target", "betwixt_python"])
    return os.path.join(build, "python", "betwixt")


def _description():
    """Returns the long description: what the wheel needs, and the page of the documentation without its links, which
    lead to files that the wheel does not have."""
    with open(os.path.join(ROOT, "docs", "python.md"), encoding="utf-8") as said:
        page = said.read()
    with open(os.path.join(HERE, "README.md"), encoding="utf-8") as said:
        return said.read() + re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", page.replace("# From Python\n", "", 1))


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    project, package = _project(), _built()
    tag = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    kind = f"{tag}-{tag}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"
    info = f"{project['name']}-{project['version']}.dist-info"
    names = sorted(name for name in os.listdir(package) if name != "__pycache__")
    parts = {f"betwixt/{name}": os.path.join(package, name) for name in names}
    texts = {
        f"{info}/METADATA": "Metadata-Version: 2.1\n"
        + "Name: {name}\nVersion: {version}\nSummary: {description}\n".format(**project)
        + f"License: {project['license']['text']}\nRequires-Python: {project['requires-python']}\n"
        + "".join(f"Requires-Dist: {d}\n" for d in project["dependencies"])
        + "Description-Content-Type: text/markdown\n\n" + _description(),
        f"{info}/WHEEL": f"Wheel-Version: 1.0\nGenerator: betwixt\nRoot-Is-Purelib: false\nTag: {kind}\n",
    }
    name, record = f"{project['name']}-{project['version']}-{kind}.whl", ""
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for inside, what in [*parts.items(), *texts.items()]:
            entry = zipfile.ZipInfo(inside, (2026, 1, 1, 0, 0, 0))
            entry.compress_type = zipfile.ZIP_DEFLATED
            data = what.encode()
            if inside in parts:
                with open(what, "rb") as part:
                    data = part.read()
                entry.external_attr = (os.stat(what).st_mode & 0xFFFF) << 16  # the parser stays executable
            wheel.writestr(entry, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record += f"{inside},sha256={digest},{len(data)}\n"
        wheel.writestr(f"{info}/RECORD", record + f"{info}/RECORD,,\n")
    return name


if __name__ == "__main__":  # without pip: build_wheel.py FOLDER
    print(build_wheel(sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp()))
