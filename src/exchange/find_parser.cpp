// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "exchange/parser_process.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

constexpr const char* name = "betwixt-parser";

// Searches an installed tree, seen from bin, lib, lib/MACHINE or lib/python3.11/dist-packages/betwixt.
std::string near(const fs::path& folder) {
  for (const char* up : {"..", "../..", "../../../.."})
    if (const fs::path there = folder / up / "libexec/betwixt" / name; can_be_run(there)) return there.string();
  return {};
}

}  // namespace

std::string find_parser() {
  if (const char* said = ::secure_getenv("BETWIXT_PARSER")) return can_be_run(said) ? said : "";
  std::error_code ignored;
  std::vector<fs::path> folders;
  if (const fs::path program = fs::read_symlink("/proc/self/exe", ignored); !program.empty())
    folders.push_back(program.parent_path());
  Dl_info library{};
  if (::dladdr(reinterpret_cast<const void*>(&find_parser), &library) != 0 && library.dli_fname != nullptr)
    folders.push_back(fs::absolute(library.dli_fname, ignored).parent_path());
  for (const fs::path& folder : folders)
    if (const fs::path beside = folder / name; can_be_run(beside)) return beside.string();
  const char* path = std::getenv("PATH");
  for (std::string_view rest = path ? path : ""; !rest.empty();) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    if (rest.starts_with('/')) folders.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  for (const fs::path& folder : folders)
    if (std::string found = near(folder); !found.empty()) return found;
  return {};
}

}  // namespace betwixt
