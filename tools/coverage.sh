#!/bin/bash
# SPDX-FileCopyrightText: 2026 The Betwixt authors
# SPDX-License-Identifier: Apache-2.0
#
# coverage.sh: writes build/coverage.md, which lists the tests that show each item of tests/coverage.txt.
# coverage.sh --check: fails if an item has neither a test nor a reason, or if a tag names an unknown item.
#
# A test names its items in a comment: "// shows: G54 R-T5" above a TEST, "# shows: G22" anywhere in a shell script.
# Each line of tests/coverage.txt has an item, a description, and a reason if no test can show the item, separated by
# tabs.
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." || exit 3
page=build/coverage.md
case ${1-} in '' | --check) ;; *) echo "usage: tools/coverage.sh [--check]" >&2; exit 2 ;; esac

# Prints ITEM <tab> TEST <tab> FILE for each tag, in the order of the files.
tags() {
  find tests -type f \( -name '*.cpp' -o -name '*.sh' \) | LC_ALL=C sort | while read -r file; do
    awk -v file="$file" '
      function put(test, n, i, word) {
        n = split(tagged, word, /[ ,]+/)
        for (i = 1; i <= n; ++i) if (word[i] != "") print word[i] "\t" test "\t" file
        tagged = ""
      }
      match($0, /^ *(\/\/|#) shows: */) {
        tagged = tagged " " substr($0, RSTART + RLENGTH)
        if (file ~ /\.sh$/) { name = file; sub(/.*\//, "", name); put(name) }
      }
      /^(TEST|TEST_F|TEST_P|RC_GTEST_PROP)\(/ {
        name = $0
        sub(/^[A-Z_]+\( */, "", name); sub(/[ ,)]*\).*/, "", name)
        split(name, part, / *, */)
        put(part[1] "." part[2])
      }
      END { if (tagged != "") print file ": \"shows:\" without a test below it" > "/dev/stderr" }' "$file"
  done
}

write() {
  tags | awk -F '\t' '
    FILENAME == "-" {
      if (!seen[$1, $2, $3]++) tests[$1] = tests[$1] (tests[$1] != "" ? ", " : "") "[" $2 "](../" $3 ")"
      if ($1 ~ /^G/) used[$1] = $2
      next
    }
    { order[++items] = $1; what[$1] = $2; reason[$1] = $3 }
    END {
      print "# What the tests show\n"
      print "This page lists the tests that show each item that Betwixt set out to do. Where no test can show it, the page says why."
      print "`tools/coverage.sh` writes it from the comments `shows:` in the tests and from `tests/coverage.txt`.\n"
      print "| item | what | tests, or the reason |\n|---|---|---|"
      for (i = 1; i <= items; ++i) {
        id = order[i]
        shown = tests[id] != "" ? tests[id] : reason[id]
        if (shown == "") missing = missing "- " id ": " what[id] "\n"
        print "| " id " | " what[id] " | " shown " |"
      }
      for (id in used) if (!(id in what)) print used[id] " shows \"" id "\", which is no item" > "/dev/stderr"
      if (missing != "") printf "\n## Missing\n\n%s", missing
    }' - tests/coverage.txt
}

mkdir -p build
said=$(write 2>&1 >"$page.new") && mv "$page.new" "$page" || exit 3
missing=$(sed -n '/^## Missing/,$p' "$page" | sed -n 's/^- \(.*\)/no test and no reason for \1/p')
[ -z "$missing" ] || missing+=$'\n'"Tag a test with the item, or give the reason in tests/coverage.txt."
[ -z "$said$missing" ] || { printf '%s\n' "$said" "$missing" | sed '/^$/d' >&2; exit 1; }
[ "${1-}" = --check ] || echo "$page"
