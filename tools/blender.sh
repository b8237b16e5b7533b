#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# blender.sh WORD…: Blender with the Python it was built for. Debian's Blender takes the standard library of the first
# python3.11 along PATH. Where that is pyenv's, Debian's numpy is not found.
program=$(command -v blender) || { echo 'betwixt: there is no Blender here' >&2; exit 127; }
PATH=/usr/bin:/bin:$PATH exec "$program" "$@"
