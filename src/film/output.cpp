// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/output.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>

#include "base/files.h"
#include "base/names.h"

namespace betwixt {
namespace {

// Reads the %d or %0Nd in a picture's name.
Result<Output> read_number(Output out) {
  const Error wrong =
      fail(ErrorCode::range, fmt::format("the name of numbered pictures needs one number, unlike \"{}\"", out.name),
           "as in frame-%04d.png; one picture: betwixt frame FILE --at 24f -o NAME.png");
  const std::size_t at = out.name.find('%');
  if (at == std::string::npos) return wrong;
  std::size_t end = at + 1;
  while (end < out.name.size() && std::isdigit(static_cast<unsigned char>(out.name[end]))) ++end;
  const std::string digits = out.name.substr(at + 1, end - at - 1);
  const bool padded = digits.size() == 2 && digits[0] == '0' && digits[1] != '0';
  if (!(digits.empty() || padded) || out.name[end] != 'd') return wrong;
  if (out.name.find('%', end) != std::string::npos) return wrong;
  out.digits = padded ? digits[1] - '0' : 1;
  out.before = out.name.substr(0, at);
  out.after = out.name.substr(end + 1);
  return out;
}

constexpr std::size_t longest_stem = 50;  // leaves room for the name of the machine

std::string this_machine() {
  char name[50] = "";
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "";
}

}  // namespace

std::string Output::path() const { return folder + '/' + name; }
std::string Output::path(int number) const {
  return fmt::format("{}/{}{:0{}}{}", folder, before, number, digits, after);
}
std::string Output::hidden(const std::string& tail) const {
  std::string stem = format ? name : before + after;
  stem = stem.substr(0, stem.rfind('.')).substr(0, longest_stem);
  return hidden_beside(fmt::format("{}/{}.{}", folder, stem, this_machine()), tail);
}

Result<Output> read_output(const std::string& path) {
  Output out;
  const std::size_t slash = path.rfind('/');
  out.folder = slash == std::string::npos ? "." : path.substr(0, slash);
  if (slash == 0) out.folder = "/.";
  out.name = slash == std::string::npos ? path : path.substr(slash + 1);
  const std::size_t dot = out.name.rfind('.');
  std::string ending = dot == std::string::npos ? "" : out.name.substr(dot);
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  out.exr = ending == ".exr";
  if (out.exr || ending == ".png") return read_number(out);
  out.format = find_format(ending);
  if (out.format && dot > 0) return out;
  const std::string known_endings = film_endings() + ", or numbered pictures: frame-%04d.png, frame-%04d.exr";
  if (dot == std::string::npos || dot == 0)
    return fail(ErrorCode::range, fmt::format("\"{}\" has no file extension that says what to make", path),
                known_endings);
  std::vector<std::string_view> names;
  for (const Format& f : formats()) names.push_back(f.ending);
  return fail(ErrorCode::range,
              fmt::format("a film cannot have the extension \"{}\"; known extensions: {}", ending, known_endings),
              did_you_mean(ending, names));
}

}  // namespace betwixt
