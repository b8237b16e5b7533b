// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Fuzzes scripts with any text. The script is loaded, tidied and compiled, and frames are computed, without a crash.
// The tidied script must mean the same.
#include "betwixt/language.h"

#include <cstdint>

#include "betwixt/program.h"
#include "fuzz.h"

using namespace betwixt;

// What is read must not depend on what lies around.
static Loaded load(std::string_view text) { return load_text(text, "fuzz.bx", {.now = {}, .read_nothing = true}); }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Slow slow;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (makes_many(text)) return -1;
  const Loaded loaded = load(text);
  for (const Diagnostic& d : loaded.diagnostics) insist(!to_string(d).empty(), "a diagnostic has words");

  const std::string tidied = tidy(text);
  if (!has_errors(loaded.diagnostics)) {
    insist(tidy(tidied) == tidied, "a tidy text is tidy");
    const Loaded again = load(tidied);
    insist(!has_errors(again.diagnostics), "a tidy text has no errors");
    insist(again.document == loaded.document, "tidying keeps the document");
    const Loaded written = load(write(loaded.document));
    insist(!has_errors(written.diagnostics), "a written document has no errors");
    insist(written.document == loaded.document, "writing keeps the document");
  }

  const Program program = Program::compile(loaded.document);
  const auto [from, to] = loaded.document.range();
  const Time middle{from.flicks / 2 + to.flicks / 2};
  const std::size_t items = program.frame(middle).items.size();
  program.frame(from), program.frame(to);
  insist(program.frame(middle).items.size() == items, "the same time gives the same frame");
  return slow.verdict();
}
