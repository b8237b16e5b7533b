// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/po_template.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/files.h"
#include "language/translations.h"

namespace betwixt {

std::function<void(const std::string&, const Place&)> PoTemplate::listener() {
  return [this](const std::string& text, const Place& place) {
    if (seen_.insert(text).second) texts_.emplace_back(text, place);
  };
}

Status PoTemplate::write(const std::string& path) const {
  std::string all =
      "# The texts of a film. Write each translation behind its msgstr; an empty one leaves the text as it is.\n"
      "msgid \"\"\nmsgstr \"\"\n\"Content-Type: text/plain; charset=UTF-8\\n\"\n";
  for (const auto& [text, place] : texts_)
    all += fmt::format("\n#: {}:{}\nmsgid {}\nmsgstr \"\"\n", std::filesystem::path(place.file).filename().string(),
                       place.line, write_po_text(text));
  // A catalogue that somebody has translated must not be lost.
  if (const auto there = read_whole(path); there && (!read_po(*there, path) || !read_po(*there, path)->empty()))
    return fail(ErrorCode::file, fmt::format("'{}' already exists and has translations, or is no catalogue", path),
                "choose another name");
  return write_whole(path, all, true);
}

}  // namespace betwixt
