// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/diff_page.h"

#include <fmt/format.h>

#include "app/markup.h"
#include "base/base64.h"
#include "base/files.h"
#include "base/sha256.h"
#include "betwixt/picture.h"

namespace betwixt {
namespace {

constexpr std::string_view look = R"(
body { margin: 2rem auto; max-width: 76rem; padding: 0 1rem; font: 1rem/1.5 system-ui, sans-serif;
  color: #222; background: #fff; }
h1 { font-size: 1.3rem; } h2 { font-size: 1.05rem; margin: 2rem 0 0.5rem; }
li { margin: 0.15rem 0; }
.row { display: grid; grid-template-columns: repeat(3, 1fr); gap: 0.75rem; }
figure { margin: 0; } img { width: 100%; display: block; } figcaption { font-size: 0.85rem; color: #555; }
@media (prefers-color-scheme: dark) {
  body { color: #ddd; background: #181818; } figcaption { color: #aaa; }
}
)";

Result<std::string> figure(const Picture& picture, const std::string& caption, const std::string& of) {
  const Result<std::string> png = to_png(picture);
  if (!png) return png.error();
  return fmt::format(
      "<figure><img alt=\"{}, {}\" src=\"data:image/png;base64,{}\"><figcaption>{}</figcaption></figure>\n", caption,
      of, base64(*png), caption);
}

}  // namespace

Result<std::string> diff_page(const std::string& title, const std::vector<FilmChange>& changes,
                              const std::string& frames, const std::vector<DiffPicture>& pictures) {
  const auto hash = sha256(look);
  std::string page = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'sha256-{}'; img-src "
      "data:; "
      "base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{}</title>\n<style>{}</style>\n<h1>{}</h1>\n",
      base64(as_text(hash)), escaped(title), look, escaped(title));
  if (changes.empty()) page += "<p>The films are the same.</p>\n";
  if (!changes.empty()) page += "<ul>\n";
  for (const FilmChange& c : changes) page += fmt::format("<li>{}</li>\n", escaped(c.words));
  if (!changes.empty()) page += "</ul>\n";
  for (std::size_t at = 0; at <= frames.size();) {
    const std::size_t feed = std::min(frames.find('\n', at), frames.size());
    page += fmt::format("<p>{}</p>\n", escaped(frames.substr(at, feed - at)));
    at = feed + 1;
  }
  for (const DiffPicture& p : pictures) {
    page += fmt::format("<h2>{}</h2>\n<div class=\"row\">\n", escaped(p.title));
    const Picture difference = picture_of_difference(p.old, p.now);
    for (const auto& [picture, caption] : {std::pair(&p.old, "old"), {&p.now, "new"}, {&difference, "difference"}}) {
      const Result<std::string> one = figure(*picture, caption, escaped(p.title));
      if (!one) return one.error();
      page += *one;
    }
    page += "</div>\n";
  }
  return page + "</html>\n";
}

}  // namespace betwixt
