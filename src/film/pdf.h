// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A PDF document whose pages are pictures.
#pragma once

#include <string>
#include <vector>

#include "betwixt/mesh.h"
#include "betwixt/result.h"

namespace betwixt {

class PdfPages {
 public:
  // Adds a page with this picture. A title is a bookmark; it may be empty. Errors: machine.
  Status add(const Picture&, int quality, const std::string& title);
  // Returns the document. It must have a page.
  std::string document(const std::string& title) const;

 private:
  struct Page {
    std::string jpeg, title;
    int width = 0, height = 0;
  };
  std::vector<Page> pages_;
};

}  // namespace betwixt
