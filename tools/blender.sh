#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# blender.sh WORD…: runs Blender with Debian's Python. Debian's Blender uses the standard library of the first
# python3.11 in PATH. If that is pyenv's, Blender does not find Debian's numpy.
program=$(command -v blender) || { echo 'betwixt: there is no Blender here' >&2; exit 127; }
PATH=/usr/bin:/bin:$PATH exec "$program" "$@"
