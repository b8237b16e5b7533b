# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""What pip asks for: a wheel, which is what CMake installs, zipped."""

import base64
import hashlib
import os
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
        return tomllib.load(said)["project"]


def _built():
    """The folder of the package, from the source tree's own build."""
    build = os.path.join(ROOT, "build", "release")
    for command in (["cmake", "--preset", "release", "-DBETWIXT_PYTHON=ON", f"-DPython_EXECUTABLE={sys.executable}"],
                    ["cmake", "--build", build, "--target", "betwixt_python"]):
        subprocess.run(command, cwd=ROOT, check=True)
    return os.path.join(build, "python", "betwixt")


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
        + "".join(f"Requires-Dist: {d}\n" for d in project["dependencies"]),
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
                entry.external_attr = (os.stat(what).st_mode & 0xFFFF) << 16  # the parser stays a program
            wheel.writestr(entry, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record += f"{inside},sha256={digest},{len(data)}\n"
        wheel.writestr(f"{info}/RECORD", record + f"{info}/RECORD,,\n")
    return name


if __name__ == "__main__":  # without pip: build_wheel.py FOLDER
    print(build_wheel(sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp()))
