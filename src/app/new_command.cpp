// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt new: writes a film to begin with.
#include <fmt/format.h>

#include <algorithm>

#include "app/command.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "app/templates.h"
#include "base/files.h"
#include "base/names.h"

namespace betwixt {
namespace {

struct NewCall {
  std::string name, file;
};

std::vector<std::string> template_names() {
  std::vector<std::string> all;
  for (const FilmTemplate& t : film_templates()) all.emplace_back(t.name);
  return all;
}

int list_templates() {
  for (const FilmTemplate& t : film_templates()) fmt::print("  {:12} {}\n", t.name, t.sentence);
  fmt::print("\nbetwixt new title FILE.bx begins a film with one of them.\n");
  return all_done;
}

int begin_film(const NewCall& call) {
  if (call.name.empty()) return list_templates();
  const auto found = std::ranges::find(film_templates(), call.name, &FilmTemplate::name);
  if (found == film_templates().end()) {
    std::vector<std::string_view> known;
    for (const FilmTemplate& t : film_templates()) known.push_back(t.name);
    return complain(unknown_name("template", call.name, did_you_mean(call.name, known)), wrong_call);
  }
  if (call.file.empty() || is_stream(call.file)) {
    fmt::print("{}", found->text);
    return all_done;
  }
  const Status written = write_whole(call.file, found->text, false);
  return written ? all_done : complain(written.error(), wrong_input);
}

const Enlisted enlisted_new(begin_film, [](NewCall& call) -> Subcommand {
  return {.rank = 27,
          .name = "new",
          .sentence = "begins a film: writes one of the templates",
          .takes = {{.name = "TEMPLATE",
                     .sentence = "the film to begin with; by default all are listed",
                     .into = &call.name,
                     .words = template_names()},
                    {.name = "FILE",
                     .sentence = "the new script, which must not exist; by default it is printed",
                     .into = &call.file,
                     .offer = Offer::scripts}},
          .example = "betwixt new title film.bx",
          .manual = "The templates are short scripts with comments. The studio shows them at File, New."};
});

}  // namespace
}  // namespace betwixt
