// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Measures the memory of a million events of one number each, as Betwixt counts it and as the allocator does. Also
// measures how fast one core copies memory now, as the unit for other results.
#include "program/memory.h"

#include <malloc.h>

#include <cmath>

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "copying.h"
#include "scene/memory.h"
#include "scenes.h"
#include "timing.h"

using namespace betwixt;

namespace {

double allocated() {
  malloc_trim(0);
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

}  // namespace

int main() {
  constexpr double events = 1e6;
  for (const double rate : copy_rates()) report("copy", rate);
  const std::string text = scenes::million("radius");
  const double before = allocated();
  const Document document = load_text(text, "bench.bx").document;
  const double loaded = allocated();
  const Program program = Program::compile(document);
  const double compiled = allocated();
  const SceneSize size = size_of(document.scene());
  insist(size.events == static_cast<std::size_t>(events), "as many events");
  const double code = static_cast<double>(bytes_of(program));
  report("document", static_cast<double>(size.bytes) / events);
  report("document-allocated", (loaded - before) / events);
  report("program", code / events);
  report("program-allocated", (compiled - loaded) / events);
}
