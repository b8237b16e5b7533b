// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt diff: what has changed in a film, in words.
#include <fmt/format.h>

#include "app/command.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "betwixt/compare.h"

namespace betwixt {
namespace {

struct DiffCall {
  std::vector<std::string> files;
};

enum DiffExit { no_difference = 0, differences = 1, trouble = 2 };

int diff(DiffCall& call) {
  const auto old = open_script(call.files[0]), now = open_script(call.files[1]);
  if (!old || !now) return trouble;
  const auto all = compare(*old, *now);
  for (const FilmChange& c : all) fmt::print("{}\n", c.words);
  return all.empty() ? no_difference : differences;
}

const Enlisted enlisted_diff(diff, [](DiffCall& call) -> Subcommand {
  return {.rank = 72,
          .name = "diff",
          .sentence = "prints what has changed in a film, in words",
          .takes = {{.name = "FILES", .sentence = "the old and the new script", .into = &call.files, .required = true}},
          .example = "betwixt diff old.bx new.bx"};
});

}  // namespace
}  // namespace betwixt
