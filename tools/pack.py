# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
"""Packs a folder for npm, Visual Studio Code or Blender. The same files give the same bytes.
   pack.py npm|vsix|blender FOLDER FILE VERSION"""

import gzip
import io
import json
import os
import sys
import tarfile
import time
import zipfile
from xml.sax.saxutils import escape

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
WHEN = int(os.environ.get("SOURCE_DATE_EPOCH", "1767225600"))


def files(folder):
    """Yields the path below the folder and the content of each file, in order."""
    for there, folders, names in os.walk(folder):
        folders.sort()
        folders[:] = [f for f in folders if f not in ("node_modules", "__pycache__")]
        for name in sorted(names):
            path = os.path.join(there, name)
            with open(path, "rb") as file:
                yield os.path.relpath(path, folder), file.read()


def write(path, data):
    with open(path + ".new", "wb") as file:
        file.write(data)
    os.replace(path + ".new", path)


def zipped(parts):
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in parts:
            entry = zipfile.ZipInfo(name, time.gmtime(WHEN)[:6])
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            archive.writestr(entry, data)
    return packed.getvalue()


def npm(folder, version):
    packed = io.BytesIO()
    with tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for name, data in files(folder):
            if name == "package.json":
                assert json.loads(data)["version"] == version, "build/web is of another version"
            entry = tarfile.TarInfo("package/" + name)
            entry.size, entry.mtime, entry.mode = len(data), WHEN, 0o644
            archive.addfile(entry, io.BytesIO(data))
    return gzip.compress(packed.getvalue(), 9, mtime=0)


def license_text():
    with open(os.path.join(ROOT, "LICENSE"), "rb") as file:
        return file.read()


KINDS = {".json": "application/json", ".js": "application/javascript", ".md": "text/markdown", ".txt": "text/plain",
         ".vsixmanifest": "text/xml"}


def vsix(folder, version):
    parts = {f"extension/{name}": data for name, data in files(folder)}
    parts["extension/LICENSE.txt"] = license_text()
    about = json.loads(parts["extension/package.json"])
    about["version"] = version
    parts["extension/package.json"] = json.dumps(about, indent=2).encode() + b"\n"
    manifest = f"""<?xml version="1.0" encoding="utf-8"?>
<PackageManifest Version="2.0.0" xmlns="http://schemas.microsoft.com/developer/vsx-schema/2011">
  <Metadata>
    <Identity Language="en-US" Id="{about["name"]}" Version="{version}" Publisher="{about["publisher"]}"/>
    <DisplayName>{escape(about["displayName"])}</DisplayName>
    <Description xml:space="preserve">{escape(about["description"])}</Description>
    <Categories>{escape(",".join(about["categories"]))}</Categories>
    <Properties>
      <Property Id="Microsoft.VisualStudio.Code.Engine" Value="{escape(about["engines"]["vscode"])}"/>
    </Properties>
    <License>extension/LICENSE.txt</License>
  </Metadata>
  <Installation><InstallationTarget Id="Microsoft.VisualStudio.Code"/></Installation>
  <Dependencies/>
  <Assets>
    <Asset Type="Microsoft.VisualStudio.Code.Manifest" Path="extension/package.json" Addressable="true"/>
    <Asset Type="Microsoft.VisualStudio.Services.Content.Details" Path="extension/README.md" Addressable="true"/>
    <Asset Type="Microsoft.VisualStudio.Services.Content.License" Path="extension/LICENSE.txt" Addressable="true"/>
  </Assets>
</PackageManifest>
"""
    ends = sorted({os.path.splitext(name)[1] for name in parts} | {".vsixmanifest"})
    kinds = "".join(f'  <Default Extension="{e}" ContentType="{KINDS[e]}"/>\n' for e in ends)
    types = ('<?xml version="1.0" encoding="utf-8"?>\n'
             '<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">\n' + kinds + "</Types>\n")
    return zipped([("extension.vsixmanifest", manifest), ("[Content_Types].xml", types), *parts.items()])


def blender(folder, version):
    with open(os.path.join(folder, "betwixt_film.py"), encoding="utf-8") as file:
        text = file.read()
    unset = '"version": (0, 0, 0),  # tools/release.sh writes it'
    assert unset in text, "betwixt_film.py has no version to write"
    text = text.replace(unset, f'"version": ({", ".join(version.split("."))}),')
    # Blender takes an archive whose folder has a file __init__.py for an add-on.
    return zipped([("betwixt_film/__init__.py", text), ("betwixt_film/LICENSE.txt", license_text())])


what, folder, path, version = sys.argv[1:]
write(path, {"npm": npm, "vsix": vsix, "blender": blender}[what](folder, version))
