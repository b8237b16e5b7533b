// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The scripts and styles of a page, and the content policy that allows these and nothing else: whatever a film's text
// does to the page, no script of its own runs.
#pragma once

#include <string>
#include <string_view>

namespace betwixt {

class PagePolicy {
 public:
  // The element with the text in it.
  std::string script(std::string_view text);
  std::string style(std::string_view text);
  // The element that fetches a file from beside the page.
  std::string script_beside(std::string_view name);
  std::string style_beside(std::string_view name);
  // Returns the policy as an element. Put it before all other elements.
  std::string said() const;

 private:
  std::string scripts_, styles_;
};

}  // namespace betwixt
