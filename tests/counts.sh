# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# count PREFIX COMMAND…: runs a test that ends with "N passed, M failed". Prints its other lines with the prefix, and adds
# to `passed` and `failed`; a test that does not end so has failed once. Sourced.
count() {
  local prefix=$1 said counts
  said=$("${@:2}" 2>&1)
  printf '%s\n' "$said" | grep -vE '^[0-9]+ passed, [0-9]+ failed$' | sed "s/^/$prefix/"
  counts=$(printf '%s\n' "$said" | sed -nE 's/^([0-9]+) passed, ([0-9]+) failed$/\1 \2/p' | tail -n 1)
  : "${counts:=0 1}"
  passed=$((passed + ${counts% *})) failed=$((failed + ${counts#* }))
}
