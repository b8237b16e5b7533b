// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt tidy: rewrites a script in its canonical form.
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "app/command.h"
#include "app/streams.h"
#include "app/subcommand.h"
#include "base/files.h"

namespace betwixt {
namespace {

// Writes a file beside the script, with the same permissions, then renames it.
int replace(const std::string& file, const std::string& text) {
  const int reason = put_file(file, text, {.like_old = true});
  if (reason == 0) return all_done;
  return complain(fail(reason == ENOSPC ? ErrorCode::machine : ErrorCode::file,
                       fmt::format("'{}' cannot be written: {}", file, std::strerror(reason))),
                  wrong_input);
}

struct TidyCall {
  std::string file;
  bool write = false;
};

int tidy(const TidyCall& call) {
  std::error_code ignored;
  if (call.write && is_stream(call.file))
    return complain(fail(ErrorCode::range, "standard input cannot be rewritten"), wrong_call);
  if (std::filesystem::exists(call.file, ignored) && !std::filesystem::is_directory(call.file, ignored) &&
      !std::filesystem::is_regular_file(call.file, ignored))  // a pipe would be empty at the second reading
    return complain(fail(ErrorCode::file, fmt::format("'{}': only a file can be tidied", call.file)), wrong_call);
  if (!open_script(call.file)) return wrong_input;  // a script with errors stays as it is
  const Result<std::string> text = script_text(call.file);
  if (!text) return complain(text.error(), wrong_input);
  const std::string tidied = betwixt::tidy(*text);
  if (!call.write)
    std::fwrite(tidied.data(), 1, tidied.size(), stdout);
  else if (tidied != *text)
    return replace(call.file, tidied);
  return all_done;
}

const Enlisted enlisted_tidy(tidy, [](TidyCall& call) -> Subcommand {
  return {.rank = 70,
          .name = "tidy",
          .sentence = "prints a script in its canonical form",
          .takes = {script_parameter(call.file),
                    flag("--write", "writes the result to the script instead of printing it", call.write)},
          .example = "betwixt tidy examples/bounce.bx --write",
          .manual = "Comments and commands stay, and the film is the same."};
});

}  // namespace
}  // namespace betwixt
