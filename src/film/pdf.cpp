// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/pdf.h"

#include <fmt/format.h>

#include "base/utf8.h"
#include "betwixt/film.h"

namespace betwixt {
namespace {

// A text as PDF writes it: UTF-16 with a mark, in hexadecimal digits.
std::string pdf_text(std::string_view text) {
  std::string out = "<FEFF";
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t n = std::max<std::size_t>(1, character_length(text, i));
    const auto byte = [&](std::size_t k) { return static_cast<unsigned>(static_cast<unsigned char>(text[i + k])); };
    unsigned code = n == 1 ? byte(0) : byte(0) & (0xffU >> (n + 1));
    for (std::size_t k = 1; k < n; ++k) code = code << 6 | (byte(k) & 0x3f);
    if (code < 0x10000)
      out += fmt::format("{:04X}", code);
    else
      out += fmt::format("{:04X}{:04X}", 0xd800 + ((code - 0x10000) >> 10), 0xdc00 + ((code - 0x10000) & 0x3ff));
    i += n;
  }
  return out + ">";
}

// Writes objects one after the other, and remembers where each begins.
class PdfObjects {
 public:
  void put(std::size_t number, std::string_view content) {
    if (places_.size() < number) places_.resize(number);
    places_[number - 1] = out_.size();
    out_ += fmt::format("{} 0 obj\n", number);
    (out_ += content) += "\nendobj\n";
  }
  std::string end(std::size_t info) {
    const std::size_t table = out_.size();
    out_ += fmt::format("xref\n0 {}\n0000000000 65535 f \n", places_.size() + 1);
    for (const std::size_t at : places_) out_ += fmt::format("{:010} 00000 n \n", at);
    out_ += fmt::format("trailer\n<< /Size {} /Root 1 0 R /Info {} 0 R >>\nstartxref\n{}\n%%EOF\n", places_.size() + 1,
                        info, table);
    return std::move(out_);
  }

 private:
  std::string out_ = "%PDF-1.4\n%\xe2\xe3\xcf\xd3\n";
  std::vector<std::size_t> places_;
};

std::string pdf_stream(std::string_view keys, std::string_view bytes) {
  return fmt::format("<< {}/Length {} >>\nstream\n", keys, bytes.size()).append(bytes).append("\nendstream");
}

}  // namespace

Status PdfPages::add(const Picture& picture, int quality, const std::string& title) {
  Result<std::string> jpeg = jpeg_of(picture, quality);
  if (!jpeg) return jpeg.error();
  pages_.push_back({*std::move(jpeg), title, picture.width, picture.height});
  return Nothing{};
}

// PdfObjects: 1 the catalogue, 2 the pages, 3 the bookmarks, 4 the title; then four for each page: itself, what it
// draws, its picture and its bookmark.
std::string PdfPages::document(const std::string& title) const {
  PdfObjects objects;
  const auto first = [](std::size_t page) { return 5 + 4 * page; };
  std::vector<std::size_t> marked;
  std::string kids;
  for (std::size_t i = 0; i < pages_.size(); ++i) {
    kids += fmt::format("{} 0 R ", first(i));
    if (!pages_[i].title.empty()) marked.push_back(i);
  }
  objects.put(1, marked.empty() ? "<< /Type /Catalog /Pages 2 0 R >>"
                                : "<< /Type /Catalog /Pages 2 0 R /Outlines 3 0 R /PageMode /UseOutlines >>");
  objects.put(2, fmt::format("<< /Type /Pages /Count {} /Kids [ {}] >>", pages_.size(), kids));
  objects.put(3, marked.empty() ? "<< /Type /Outlines >>"
                                : fmt::format("<< /Type /Outlines /First {} 0 R /Last {} 0 R /Count {} >>",
                                              first(marked.front()) + 3, first(marked.back()) + 3, marked.size()));
  objects.put(4, fmt::format("<< /Title {} /Producer (Betwixt) >>", pdf_text(title)));
  for (std::size_t i = 0, m = 0; i < pages_.size(); ++i) {
    const Page& page = pages_[i];
    const double width = 0.75 * page.width, height = 0.75 * page.height;  // 96 pixels to the inch
    objects.put(first(i), fmt::format("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 {} {}] /Contents {} 0 R "
                                      "/Resources << /XObject << /P {} 0 R >> >> >>",
                                      width, height, first(i) + 1, first(i) + 2));
    objects.put(first(i) + 1, pdf_stream("", fmt::format("q {} 0 0 {} 0 0 cm /P Do Q", width, height)));
    objects.put(first(i) + 2,
                pdf_stream(fmt::format("/Type /XObject /Subtype /Image /Width {} /Height {} /ColorSpace /DeviceRGB "
                                       "/BitsPerComponent 8 /Filter /DCTDecode ",
                                       page.width, page.height),
                           page.jpeg));
    if (page.title.empty()) {
      objects.put(first(i) + 3, "null");
      continue;
    }
    std::string mark = fmt::format("<< /Title {} /Parent 3 0 R /Dest [{} 0 R /Fit]", pdf_text(page.title), first(i));
    if (m > 0) mark += fmt::format(" /Prev {} 0 R", first(marked[m - 1]) + 3);
    if (m + 1 < marked.size()) mark += fmt::format(" /Next {} 0 R", first(marked[m + 1]) + 3);
    objects.put(first(i) + 3, mark + " >>"), ++m;
  }
  return objects.end(4);
}

}  // namespace betwixt
