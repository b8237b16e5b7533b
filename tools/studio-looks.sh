#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# Saves pictures of all panels and dialogs of the studio, in two languages, dark and light, in three window sizes and
# with small and large text, to look through them. PROGRAM is build/…/bin/studio_looks_test.
#   tools/studio-looks.sh PROGRAM FOLDER
[ $# = 2 ] || { sed -n '7s/^# *//p' "$0"; exit 2; }
mkdir -p -- "$2" && QT_QPA_PLATFORM=offscreen BETWIXT_LOOKS=$(realpath -- "$2") "$1"
