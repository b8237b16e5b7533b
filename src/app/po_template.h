// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The texts of a film as a gettext catalogue to translate.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "betwixt/result.h"

namespace betwixt {

class PoTemplate {
 public:
  // For LoadOptions::shows.
  std::function<void(const std::string&, const Place&)> listener();
  // Replaces only a catalogue. Errors: file, machine.
  Status write(const std::string& path) const;

 private:
  std::vector<std::pair<std::string, Place>> texts_;  // each once, in the order of the script
  std::set<std::string> seen_;
};

}  // namespace betwixt
