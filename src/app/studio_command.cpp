// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt studio: finds the studio, a separate program, and replaces this process by it.
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "app/streams.h"
#include "app/studio.h"
#include "app/subcommand.h"
#include "app/window.h"
#include "base/files.h"
#include "commands/plugins.h"

namespace betwixt {
namespace {

constexpr const char* program = "betwixt-studio";

std::string find_studio() {
  if (const char* said = ::secure_getenv("BETWIXT_STUDIO")) return can_be_run(said) ? said : "";
  std::error_code ignored;
  const std::filesystem::path here = std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
  for (const auto& there : {here / program, here / "../libexec/betwixt" / program})
    if (can_be_run(there)) return there.string();
  return {};
}

struct StudioCall {
  std::string file, screenshot, at, layout, size, select, panel, session;
  std::vector<std::string> others;
  bool light = false, recover = false, discard = false;
};

int studio(StudioCall& call) {
  if (is_stream(call.file))
    return complain(fail(ErrorCode::range, "the studio needs a file, not standard input"), wrong_call);
  // Qt would abort with a message of its own.
  if (call.screenshot.empty() && !std::getenv("QT_QPA_PLATFORM") && !has_display())
    return complain(fail(ErrorCode::machine, "a window needs a display",
                         "set DISPLAY, or save a picture of the window: --screenshot OUT.png"),
                    machine_failed);
  std::vector<std::string> arguments;
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) arguments.insert(arguments.end(), {option, value});
  };
  add("--screenshot", call.screenshot), add("--at", call.at), add("--layout", call.layout), add("--size", call.size);
  add("--select", call.select), add("--panel", call.panel), add("--session", call.session);
  if (call.light) arguments.emplace_back("--light");
  if (call.recover) arguments.emplace_back("--recover");
  if (call.discard) arguments.emplace_back("--discard");
  std::vector<std::string> files{call.file};
  files.insert(files.end(), call.others.begin(), call.others.end());
  return complain(become_studio(std::move(arguments), files).error(), machine_failed);
}

const Enlisted enlisted_studio(studio, [](StudioCall& call) -> Subcommand {
  return {
      .rank = 25,
      .name = "studio",
      .sentence = "opens the studio, where you edit the film as a picture, a sheet, curves and text",
      .takes =
          {{.name = "FILE",
            .sentence = "the script; a new one if it does not exist",
            .into = &call.file,
            .offer = Offer::scripts},
           {.name = "OTHER", .sentence = "more scripts, each in a tab", .into = &call.others, .offer = Offer::scripts},
           file_option("--screenshot", "OUT.png", "saves a screenshot of the window and ends; needs no display",
                       &call.screenshot),
           option("--at", "TIME", "the time of the playhead: 24f, 1.5s", &call.at),
           {.name = "--layout",
            .value = "NAME",
            .sentence = "the arrangement of the panels: all, animate, script, live or picture",
            .into = &call.layout,
            .words_only = true,
            .words = {"all", "animate", "script", "live", "picture"}},
           option("--size", "WxH", "the size of the window", &call.size),
           option("--select", "PATTERN", "the selected objects: wheel*", &call.select),
           {.name = "--panel",
            .value = "NAME",
            .sentence = "saves a screenshot of this panel only: outliner, sheet, columns, curves …",
            .into = &call.panel,
            .words = {"picture",    "outliner", "timeline", "sheet",       "columns",    "curves", "script",
                      "properties", "console",  "history",  "course",      "assets",     "data",   "live",
                      "server",     "export",   "new",      "preferences", "appearance", "keys"}},
           flag("--light", "uses light colours", call.light),
           file_option("--session", "SESSION.txt", "runs the lines of a file first, such as a saved session",
                       &call.session),
           flag("--recover", "recovers the unsaved commands of an earlier session", call.recover),
           {.name = "--discard",
            .sentence = "discards the unsaved commands of an earlier session",
            .into = &call.discard,
            .excludes = "--recover"}},
      .note = "The first ./betwixt studio builds it.",
      .example = "betwixt studio examples/bounce.bx",
      .manual =
          "Every edit appears in the console as a line of the language. You can undo without limit. The studio writes "
          "each edit to a journal in the folder of the script (.FILE.journal), and changes the script where an author "
          "would change it. Without a file the studio begins with an example."};
});

}  // namespace

bool has_display() {
  const char* wayland = std::getenv("WAYLAND_DISPLAY");
  return (wayland && *wayland) || Window::has_display();
}

bool has_studio() { return !find_studio().empty(); }

Status become_studio(std::vector<std::string> arguments, const std::vector<std::string>& files) {
  const std::string path = find_studio();
  if (path.empty())
    return fail(ErrorCode::machine, "the studio is missing",
                "to build it: ./betwixt studio; in an installation it is beside betwixt if it was built with it");
  arguments.insert(arguments.begin(), path);
  if (load_options().read_anywhere) arguments.emplace_back("--read-anywhere");
  if (load_options().tex) arguments.emplace_back("--tex");
  for (const GivenLet& let : load_options().lets)
    arguments.insert(arguments.end(), {"--let", let.name + "=" + let.value});
  if (load_options().language) arguments.insert(arguments.end(), {"--language", *load_options().language});
  for (const std::string& plugin : plugins_loaded()) arguments.insert(arguments.end(), {"--load", plugin});
  arguments.emplace_back("--");
  for (const std::string& file : files)
    if (!file.empty()) arguments.push_back(file);
  std::vector<char*> raw;
  for (std::string& a : arguments) raw.push_back(a.data());
  raw.push_back(nullptr);
  ::execv(path.c_str(), raw.data());
  return fail(ErrorCode::machine, std::string("the studio cannot be started: ") + std::strerror(errno));
}

}  // namespace betwixt
