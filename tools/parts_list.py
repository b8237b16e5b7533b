# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Prints all parts of Betwixt with their versions and licences, as CycloneDX 1.5. The versions are those of the Debian
packages that are installed here.   parts_list.py VERSION DATE"""

import json
import os
import re
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
TOOLS = {"clang-19", "cmake", "ninja-build", "ccache", "pkgconf", "python3-dev"}  # they build, and are no part


def listed(name):
    with open(os.path.join(ROOT, "tools", name), encoding="utf-8") as file:
        rows = [line.split("#")[0].split(None, 1) for line in file]
    return {row[0]: row[1].strip() for row in rows if len(row) == 2}


def version(package):
    said = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package], capture_output=True, text=True)
    return said.stdout if said.returncode == 0 else None


def licence(package):
    """Returns what the package's copyright file says of all files, or None if it has no such row."""
    try:
        with open(f"/usr/share/doc/{package}/copyright", encoding="utf-8", errors="replace") as file:
            rows = re.split(r"\n\s*\n", file.read())
    except OSError:
        return None
    for row in rows:
        files = re.search(r"^Files:\s*(.*)", row, re.M)
        said = re.search(r"^License:[ \t]*(\S.*)", row, re.M)
        if files and said and files[1].split()[:1] == ["*"]:
            return said[1].strip()
    return None


def component(package, purpose, scope):
    now = version(package)
    if now is None:
        return None
    named = licence(package) or "see the copyright file of the package"
    return {
        "type": "library" if package.endswith("-dev") or package.startswith("lib") else "application",
        "name": package,
        "version": now,
        "description": purpose,
        "scope": scope,
        "licenses": [{"license": {"name": named}}],
        "purl": f"pkg:deb/debian/{package}@{now}",
    }


def main(version_now, date):
    built = {k: v for f in ("packages.txt", "studio-packages.txt", "python-packages.txt") for k, v in listed(f).items()}
    runs = listed("run-packages.txt")
    parts = [component(p, why, "required") for p, why in sorted({**built, **runs}.items()) if p not in TOOLS]
    print(
        json.dumps(
            {
                "bomFormat": "CycloneDX",
                "specVersion": "1.5",
                "version": 1,
                "metadata": {
                    "timestamp": date + "T00:00:00Z",
                    "component": {
                        "type": "application",
                        "name": "betwixt",
                        "version": version_now,
                        "licenses": [{"license": {"id": "Apache-2.0"}}],
                    },
                },
                "components": [p for p in parts if p],
            },
            indent=2,
            ensure_ascii=False,
        )
    )


main(*sys.argv[1:])
