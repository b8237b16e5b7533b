// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/made_record.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <sstream>

#include "base/files.h"
#include "base/sha256.h"

namespace betwixt {
namespace {

constexpr std::string_view first_line = "betwixt film 1";

std::string record_of(const std::string& film) {
  const std::filesystem::path path(film);
  return (path.parent_path() / ("." + path.filename().string() + ".made")).string();
}

std::string digest(const std::string& text) {
  std::string out;
  for (const std::uint8_t byte : sha256(text)) out += fmt::format("{:02x}", byte);
  return out;
}

// The size and the time of the last change; "missing" if there is no file.
std::string state_of(const std::string& path) {
  struct stat is {};
  if (::stat(path.c_str(), &is) != 0) return "missing";
  return fmt::format("{} {}.{:09}", is.st_size, is.st_mtim.tv_sec, is.st_mtim.tv_nsec);
}

}  // namespace

bool stands_as_made(const std::string& film, const std::string& parameters) {
  const Result<std::string> record = read_whole(record_of(film));
  if (!record) return false;
  std::istringstream lines(*record);
  std::string line;
  if (!std::getline(lines, line) || line != first_line) return false;
  if (!std::getline(lines, line) || line != digest(parameters)) return false;
  if (!std::getline(lines, line) || line != state_of(film)) return false;
  while (std::getline(lines, line)) {  // STATE<tab>PATH
    const std::size_t tab = line.find('\t');
    if (tab == line.npos || state_of(line.substr(tab + 1)) != line.substr(0, tab)) return false;
  }
  return true;
}

Status write_made_record(const std::string& film, const std::string& parameters, const std::set<std::string>& files) {
  std::string text = fmt::format("{}\n{}\n{}\n", first_line, digest(parameters), state_of(film));
  std::error_code ignored;
  for (const std::string& file : files)
    if (file.find('\n') == file.npos)
      text += fmt::format("{}\t{}\n", state_of(file), std::filesystem::absolute(file, ignored).string());
  return write_whole(record_of(film), text, true);
}

}  // namespace betwixt
