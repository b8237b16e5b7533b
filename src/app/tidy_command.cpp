// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt tidy: a script in its canonical form.
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/command.h"

namespace betwixt {
namespace {

// Written beside the file first, with its rights, then put in place.
int replace(const std::string& file, const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code why;
  const fs::path real = fs::canonical(file, why);  // behind a link: the file itself
  const fs::path beside = real.parent_path() / fmt::format(".{}.{}.partial", real.filename().string(), getpid());
  {
    std::ofstream out(beside, std::ios::binary);
    out << text << std::flush;
    if (!out) {
      const int error = errno;
      fs::remove(beside, why);
      return complain(fail(error == ENOSPC ? Code::machine : Code::file,
                           fmt::format("'{}' cannot be written: {}", file, std::strerror(error))),
                      wrong_input);
    }
  }
  fs::permissions(beside, fs::status(real, why).permissions(), why);
  fs::rename(beside, real, why);
  if (!why) return all_done;
  const std::string reason = why.message();
  fs::remove(beside, why);
  return complain(fail(Code::file, fmt::format("'{}' cannot be written: {}", file, reason)), wrong_input);
}

}  // namespace

void add_tidy(CLI::App& app, int& exit_code) {
  auto* sub = app.add_subcommand("tidy", "prints a script in its canonical form");
  auto file = std::make_shared<std::string>();
  auto write = std::make_shared<bool>(false);
  sub->add_option("FILE", *file, "the script")->required()->type_name("");
  sub->add_flag("--write", *write, "put it in place of the script instead of printing it");
  sub->footer("Example:\n  betwixt tidy examples/bounce.bx --write");
  sub->callback([file, write, &exit_code] {
    std::error_code ignored;
    if (std::filesystem::exists(*file, ignored) && !std::filesystem::is_directory(*file, ignored) &&
        !std::filesystem::is_regular_file(*file, ignored)) {  // read twice, a pipe would be empty
      exit_code = complain(fail(Code::file, fmt::format("'{}': only a file can be tidied", *file)), wrong_call);
      return;
    }
    if (!open_script(*file)) {
      exit_code = wrong_input;  // a script that cannot be read is left alone
      return;
    }
    std::ifstream in(*file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    const std::string tidied = tidy(text.str());
    if (!*write)
      std::fwrite(tidied.data(), 1, tidied.size(), stdout);
    else if (tidied != text.str())
      exit_code = replace(*file, tidied);
  });
}

}  // namespace betwixt
