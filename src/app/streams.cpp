// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/streams.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

#include "base/files.h"

namespace betwixt {
namespace {

constexpr std::size_t most_read = std::size_t{1} << 30;  // the limit for script files, too

Result<std::string> standard_input() {
  std::string text;
  std::array<char, 65536> part;
  for (;;) {
    const ssize_t n = ::read(STDIN_FILENO, part.data(), part.size());
    if (n == 0) return text;
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return fail(ErrorCode::file, "standard input cannot be read");
    text.append(part.data(), static_cast<std::size_t>(n));
    if (text.size() > most_read) return fail(ErrorCode::file, "a script can have at most 1 GiB");
  }
}

}  // namespace

bool is_stream(const std::string& file) { return file == "-"; }

Result<std::string> script_text(const std::string& file) {
  static std::optional<Result<std::string>> input;
  if (!is_stream(file)) return read_whole(file);
  if (!input) input = standard_input();
  return *input;
}

Result<Outgoing> Outgoing::begin(std::string& out, const std::string& usual) {
  Outgoing made;
  const bool plain = out == "-", ending = out.starts_with("-.") && out.find('/') == out.npos;
  if (!plain && !ending) return made;
  if (plain && usual.empty())
    return fail(ErrorCode::range, "the format is missing", "write the extension after '-', as in -o -.glb");
  if (::isatty(STDOUT_FILENO) == 1)
    return fail(ErrorCode::range, "standard output is a terminal, which cannot show such files",
                "write -o FILE, or > FILE");
  std::error_code failed;
  std::string folder = (std::filesystem::temp_directory_path(failed) / "betwixt-XXXXXX").string();
  if (failed || !::mkdtemp(folder.data()))
    return fail(ErrorCode::machine, "cannot make a temporary file for standard output: " + folder);
  made.folder_ = folder;
  made.path_ = out = folder + "/out" + (plain ? "." + usual : out.substr(1));
  return made;
}

Outgoing::Outgoing(Outgoing&& other) noexcept
    : folder_(std::exchange(other.folder_, {})), path_(std::exchange(other.path_, {})) {}
Outgoing& Outgoing::operator=(Outgoing&& other) noexcept {
  std::swap(folder_, other.folder_), std::swap(path_, other.path_);
  return *this;
}
Outgoing::~Outgoing() {
  std::error_code ignored;
  if (!folder_.empty()) std::filesystem::remove_all(folder_, ignored);
}

Status Outgoing::send() const {
  if (path_.empty()) return Nothing{};
  std::ifstream file(path_, std::ios::binary);
  std::array<char, 65536> part;
  while (file.read(part.data(), part.size()), file.gcount() > 0) {
    const auto n = static_cast<std::size_t>(file.gcount());
    if (std::fwrite(part.data(), 1, n, stdout) != n)
      return fail(ErrorCode::machine, "the output cannot be written to standard output");
  }
  return file.bad() ? Status(fail(ErrorCode::machine, "the output cannot be read again")) : Status(Nothing{});
}

}  // namespace betwixt
