// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt merge: the changes of two authors in one script; a merge driver of Git.
#include <fmt/format.h>

#include "app/command.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "base/counted.h"
#include "base/files.h"
#include "base/tell_user.h"
#include "betwixt/compare.h"

namespace betwixt {
namespace {

struct MergeCall {
  std::string base, mine, theirs, out, as;
};

enum MergeExit { merged = 0, conflicts = 1, no_merge = 2 };

void report(const MergedFilm& film, const std::string& name) {
  if (film.by_lines) tell_user(fmt::format("{}: warning: merged by lines: {}\n", name, film.why));
  for (const std::string& notice : film.notices) tell_user(fmt::format("{}: notice: {}\n", name, notice));
  for (const MergeConflict& c : film.conflicts) {
    tell_user(fmt::format("{}:{}: conflict: {}: mine: {}; theirs: {}\n", name, c.place, c.name, c.mine, c.theirs));
    if (!c.line.empty()) tell_user(fmt::format("  mine stays; for theirs, write: {}\n", c.line));
  }
  if (!film.conflicts.empty())
    tell_user(fmt::format("{}: look at the marked lines, then delete the marks\n",
                          counted(film.conflicts.size(), "conflict")));
}

int merge(const MergeCall& call) {
  std::array<std::string, 3> texts;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Result<std::string> text = script_text(std::array{call.base, call.mine, call.theirs}[i]);
    if (!text) return complain(text.error(), no_merge);
    texts[i] = *text;
  }
  const std::string name = !call.as.empty() ? call.as : call.mine, out = call.out.empty() ? call.mine : call.out;
  const MergedFilm film = merge_films(texts[0], texts[1], texts[2], name, load_options());
  if (is_stream(out)) {
    fmt::print("{}", film.text);
  } else if (const int reason = put_file(out, film.text, {.like_old = true}); reason != 0) {
    return complain(system_error(reason, "write", out), no_merge);
  }
  report(film, name);
  return film.clean() ? merged : conflicts;
}

const Enlisted enlisted_merge(merge, [](MergeCall& call) -> Subcommand {
  return {.rank = 74,
          .name = "merge",
          .sentence = "merges the changes of two authors in one script, by objects, tracks and events",
          .takes = {{.name = "BASE",
                     .sentence = "the script that both began with",
                     .into = &call.base,
                     .required = true,
                     .offer = Offer::scripts},
                    {.name = "MINE",
                     .sentence = "your script, which gets the result",
                     .into = &call.mine,
                     .required = true,
                     .offer = Offer::scripts},
                    {.name = "THEIRS",
                     .sentence = "the other author's script",
                     .into = &call.theirs,
                     .required = true,
                     .offer = Offer::scripts},
                    file_option("-o,--output", "FILE", "writes the result there instead; - prints it", &call.out),
                    file_option("--as", "FILE",
                                "the script's own name, if the three are copies elsewhere: its files "
                                "are looked for beside it",
                                &call.as)},
          .example = "betwixt merge base.bx mine.bx theirs.bx -o merged.bx",
          .manual =
              "Lines, comments and layout of MINE stay. Where both changed the same event or value differently, "
              "MINE stays, and a comment \"# conflict: theirs: …\" beside it has the other. The exit code is 0 "
              "without conflicts, 1 with some, and 2 if nothing was written. As a merge driver of Git: git config "
              "merge.betwixt.driver 'betwixt merge %O %A %B --as %P'"};
});

}  // namespace
}  // namespace betwixt
