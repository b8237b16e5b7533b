// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A temporary folder for one test. It is removed at the end of the test.
#pragma once

#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace betwixt {

class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "betwixt-XXXXXX").string();
    at_ = ::mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(at_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const std::filesystem::path& path() const { return at_; }
  std::string operator/(const std::string& name) const { return (at_ / name).string(); }
  // Writes a file and the folders above it. Returns its path.
  std::string put(const std::string& name, std::string_view text) const {
    std::filesystem::create_directories((at_ / name).parent_path());
    std::ofstream(at_ / name, std::ios::binary) << text;
    return *this / name;
  }
  std::string get(const std::string& name) const {
    std::ifstream in(at_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  bool has(const std::string& name) const { return std::filesystem::exists(at_ / name); }
  // Returns the names of all files in the folder, sorted.
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(at_)) all.push_back(entry.path().filename().string());
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  std::filesystem::path at_;
};

}  // namespace betwixt
