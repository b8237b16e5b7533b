// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt web: makes a page that plays films, and in which readers can edit them.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/command.h"
#include "app/player_file.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "app/web_page.h"
#include "base/counted.h"
#include "base/files.h"
#include "base/tell_user.h"
#include "commands/plugins.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

struct WebCall {
  std::vector<std::string> files;
  std::string out, title;
  std::optional<std::pair<int, int>> size;
  bool no_edit = false, link = false, keep_old = false, present = false;
};

Status ready(const WebCall& call) {
  if (const std::string end = ending(call.out); end != "html" && end != "htm")
    return fail(ErrorCode::range, fmt::format("a page must be a .html file, not \"{}\"", call.out));
  if (call.present && call.files.size() != 1)
    return fail(ErrorCode::range, "--present makes a page of one film", "write one script");
  if (!plugins_loaded().empty())
    return fail(ErrorCode::range, "a page cannot use plug-ins, because they are programs", "leave out --load");
  std::error_code ignored;
  for (const std::string& file : call.files)
    if (fs::exists(file, ignored) && !fs::is_directory(file, ignored) && !fs::is_regular_file(file, ignored))
      return fail(ErrorCode::file, fmt::format("'{}': only a file can be part of a page", file));
  return check_place(call.out, !call.keep_old);
}

// A page can have only one file of each name.
Status no_two_of_one_name(const std::vector<PageFilm>& films) {
  PageFiles all;
  for (const PageFilm& film : films)
    for (const auto& [name, bytes] : film.files)
      if (const auto [there, fresh] = all.try_emplace(name, bytes); !fresh && there->second != bytes)
        return fail(ErrorCode::file, fmt::format("two films use the name '{}' for two different files", name),
                    "make one page for each, or put the films in one folder");
  return Nothing{};
}

// Writes a file that all pages of a folder share. All its versions begin with `mark`; a file that does not is an error.
Status put_beside(const fs::path& page, std::string_view name, std::string_view text, std::string_view mark,
                  bool overwrite) {
  const std::string path = (page.parent_path() / name).string();
  const auto there = read_contents(path);
  if (there.problem == ReadProblem::missing) return write_whole(path, text, overwrite);
  if (there.problem == ReadProblem::none && there.text == text) return Nothing{};
  if (there.problem != ReadProblem::none || !there.text.starts_with(mark))
    return fail(ErrorCode::file, fmt::format("'{}' already exists and is not a file of Betwixt", path),
                "move it away, or leave out --link");
  return write_whole(path, text, overwrite);
}

int web(WebCall& call) {
  call.out = output_or(call.out, call.files.front(), "html");
  const Result<Outgoing> outgoing = Outgoing::begin(call.out, "html");
  if (!outgoing) return complain(outgoing.error(), wrong_call);
  if (*outgoing && call.link)
    return complain(fail(ErrorCode::range, "--link needs a page in a file, not on standard output", "leave out --link"),
                    wrong_call);
  if (const Status s = ready(call); !s) return complain(s.error(), wrong_call);
  if (const auto there = find_player(); !there) return complain(there.error(), machine_failed);
  std::vector<PageFilm> films;
  std::size_t files = 0;
  for (const std::string& file : call.files) {
    auto film = film_for_page(file);
    if (!film) return wrong_input;
    if (!*film) return complain(film->error(), wrong_input);
    films.push_back(**std::move(film));
    files += films.back().files.size();
  }
  if (const Status s = no_two_of_one_name(films); !s) return complain(s.error(), wrong_input);
  PlayerParts parts{call.link, call.link, call.link};
  for (const PageFilm& film : films) {
    const PlayerParts needed = needed_parts(film);
    parts.reader |= needed.reader, parts.formulas |= needed.formulas, parts.code |= needed.code;
  }
  const auto player = read_player(parts);
  if (!player) return complain(player.error(), machine_failed);
  PageOptions options;
  options.title = !call.title.empty()              ? call.title
                  : films.size() == 1 || *outgoing ? fs::path(films[0].name).stem().string()
                                                   : fs::path(call.out).stem().string();
  options.size = call.size, options.edit = !call.no_edit;
  if (!call.link) options.player = *player;
  const std::string page = call.present ? talk_page(films[0], options) : web_page(films, options);
  if (const Status s = write_whole(call.out, page, !call.keep_old); !s) return complain(s.error(), wrong_call);
  struct Beside {
    std::string_view name, text, mark;
  };
  if (call.link)
    for (const Beside& b : {Beside{"betwixt-player.js", *player, "// Betwixt "},
                            Beside{"betwixt-page.css", page_look(), "/* SPDX-FileCopyrightText: 2026 The Betwixt"}})
      if (const Status s = put_beside(call.out, b.name, b.text, b.mark, !call.keep_old); !s)
        return complain(s.error(), wrong_call);
  if (const Status sent = outgoing->send(); !sent) return complain(sent.error(), machine_failed);
  for (const PageFilm& film : films)
    for (const std::string& lost : film.lost) tell_user(fmt::format("betwixt: notice: {}: {}\n", film.name, lost));
  tell_user(fmt::format("{}, {}, {:.0f} kB, {}\n", counted(films.size(), "film"), counted(files, "file"),
                        std::ceil(static_cast<double>(page.size()) / 1000), *outgoing ? "standard output" : call.out));
  return all_done;
}

const Enlisted enlisted_web(web, [](WebCall& call) -> Subcommand {
  return {
      .rank = 18,
      .name = "web",
      .sentence = "makes a web page that plays films in any browser and lets you edit them",
      .takes = {{.name = "FILE",
                 .sentence = "the scripts, in the order of the page; - is standard input",
                 .into = &call.files,
                 .required = true,
                 .offer = Offer::scripts},
                output_parameter(call.out, "PAGE.html", "the page; - is standard output", "html"),
                option("--title", "TEXT", "the title; by default the film's name", &call.title),
                size_parameter(call.size, "the size of the pictures; by default the width of the page"),
                {.name = "--present",
                 .sentence = "makes a page that shows the film as a talk, from step to step",
                 .into = &call.present,
                 .excludes = "--link"},
                flag("--no-edit", "shows the films without their scripts", call.no_edit),
                flag("--link",
                     "writes the player (betwixt-player.js, betwixt-page.css) into the page's folder, for many pages",
                     call.link),
                flag("--no-overwrite", "keeps an existing file", call.keep_old)},
      .note = "The first ./betwixt web builds the player.",
      .example = "betwixt web examples/bounce.bx -o bounce.html",
      .manual =
          "The page is one file and needs no other. It plays offline, also from a folder. It contains the script as "
          "text, and the files that the script uses. The film changes while you edit the text. The command prints a "
          "line for each thing that a page cannot show: motion blur, depth of field, live input. If a "
          "server's policy forbids inline scripts and styles, --link makes a page without them. A page of --present "
          "goes "
          "on with the right arrow, space, a click, a touch on the right or a swipe to the left; n opens a window with "
          "the speaker's notes, b blanks the picture, f fills the screen."};
});

}  // namespace
}  // namespace betwixt
