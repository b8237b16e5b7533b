#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Builds the documentation as a site with search, in which films play: build/site/index.html. The site needs no server.
#   tools/site.sh [PROGRAM [FOLDER]]    the default of PROGRAM is ./betwixt, which first builds the player for pages
root=$(cd -P -- "$(dirname -- "$0")/.." && pwd)
. "$root/tools/setup.sh"
need "$root/tools/site-packages.txt"
BETWIXT_PROGRAM=$(realpath -- "${1:-$root/betwixt}") || exit 3
export BETWIXT_PROGRAM
mkdocs build --clean --quiet --config-file "$root/tools/site/mkdocs.yml" ${2:+--site-dir "$(realpath -m -- "$2")"} || exit
echo "${2:-build/site}/index.html"
