// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Any text at all: it loads, is tidied, compiles and gives frames without a crash; what tidy returns means the same.
#include "betwixt/language.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "betwixt/program.h"

using namespace betwixt;

static void insist(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", what);
  std::abort();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const Loaded loaded = load_text(text, "fuzz.bx");
  for (const Diagnostic& d : loaded.diagnostics) insist(!to_string(d).empty(), "a diagnostic has words");

  const std::string tidied = tidy(text);
  if (!has_errors(loaded.diagnostics)) {
    insist(tidy(tidied) == tidied, "a tidy text is tidy");
    const Loaded again = load_text(tidied, "fuzz.bx");
    insist(!has_errors(again.diagnostics), "a tidy text has no errors");
    insist(again.document == loaded.document, "tidying keeps the document");
    const Loaded written = load_text(write(loaded.document), "fuzz.bx");
    insist(!has_errors(written.diagnostics), "a written document has no errors");
    insist(written.document == loaded.document, "writing keeps the document");
  }

  const Program program = Program::compile(loaded.document);
  const auto [from, to] = loaded.document.range();
  const Time middle{from.flicks / 2 + to.flicks / 2};
  const std::size_t items = program.frame(middle).items.size();
  program.frame(from), program.frame(to);
  insist(program.frame(middle).items.size() == items, "the same time gives the same frame");
  return 0;
}
