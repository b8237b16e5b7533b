// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A PLY reader of our own, because assimp never returns from a truncated PLY file.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <map>
#include <optional>

#include "exchange/assembly.h"

namespace betwixt {
namespace {

enum class Number : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };
std::optional<Number> number_type(std::string_view word) {
  static const std::map<std::string_view, Number> types{
      {"char", Number::i8},   {"int8", Number::i8},     {"uchar", Number::u8},   {"uint8", Number::u8},
      {"short", Number::i16}, {"int16", Number::i16},   {"ushort", Number::u16}, {"uint16", Number::u16},
      {"int", Number::i32},   {"int32", Number::i32},   {"uint", Number::u32},   {"uint32", Number::u32},
      {"float", Number::f32}, {"float32", Number::f32}, {"double", Number::f64}, {"float64", Number::f64}};
  const auto i = types.find(word);
  return i == types.end() ? std::nullopt : std::optional(i->second);
}

struct Property {
  std::string name;
  Number type;
  std::optional<Number> length;  // for a list
};
struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};
enum class Form : std::uint8_t { ascii, little, big };
struct Header {
  Form form = Form::ascii;
  std::vector<Element> elements;
};

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

class Ply {
 public:
  Ply(const std::string& bytes, const std::string& path) : bytes_(bytes), assembly_(path) {}

  Result<std::shared_ptr<const Mesh>> read() {
    const auto header = read_header();
    if (!header) return header.error();
    form_ = header->form;
    for (const auto& element : header->elements)
      for (std::size_t i = 0; i < element.count; ++i) {
        const bool ok = element.name == "vertex" ? vertex(element)
                        : element.name == "face" ? face(element)
                                                 : skip(element);
        if (!ok)
          return assembly_.error(
              fmt::format("{} {} of {} is incomplete or not valid", element.name, i + 1, element.count));
      }
    if (!polygons_) piece_.edges.clear();
    if (const Status s = assembly_.add(std::move(piece_), {}, {}); !s) return s.error();
    return std::move(assembly_).finish();
  }

 private:
  std::vector<std::string> line() {
    const auto end = std::find(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), bytes_.end(), '\n');
    std::vector<std::string> words{{}};
    for (; at_ < static_cast<std::size_t>(end - bytes_.begin()); ++at_) {
      if (!is_space(bytes_[at_]))
        words.back() += bytes_[at_];
      else if (!words.back().empty())
        words.emplace_back();
    }
    if (words.back().empty()) words.pop_back();
    at_ = std::min(at_ + 1, bytes_.size());
    return words;
  }

  Result<Header> read_header() {
    Header header;
    if (line() != std::vector<std::string>{"ply"}) return assembly_.error("it does not begin with \"ply\"");
    while (at_ < bytes_.size()) {
      const auto words = line();
      if (words.empty()) continue;
      if (words[0] == "end_header") return header;
      // All other lines are comments.
      const bool known = words[0] == "format" || words[0] == "element" || words[0] == "property";
      if (known && !take(words, header))
        return assembly_.error(fmt::format("its header has a line that is not valid: \"{}\"", words[0].substr(0, 40)));
    }
    return assembly_.error("its header has no end");
  }

  static bool take(const std::vector<std::string>& words, Header& header) {
    const auto& w = words;
    if (w[0] == "format" && w.size() > 1) {
      header.form = w[1] == "ascii" ? Form::ascii : w[1] == "binary_big_endian" ? Form::big : Form::little;
      return w[1] == "ascii" || w[1] == "binary_big_endian" || w[1] == "binary_little_endian";
    }
    if (w[0] == "element" && w.size() == 3) {
      header.elements.push_back({w[1], 0, {}});
      const char* end = w[2].data() + w[2].size();
      const auto [stop, error] = std::from_chars(w[2].data(), end, header.elements.back().count);
      return error == std::errc{} && stop == end;
    }
    if (w[0] != "property" || header.elements.empty()) return false;
    const bool list = w.size() == 5 && w[1] == "list";
    if (!list && w.size() != 3) return false;
    const auto type = number_type(w[w.size() - 2]), length = list ? number_type(w[2]) : std::nullopt;
    if (!type || (list && !length)) return false;
    header.elements.back().properties.push_back({w.back(), *type, length});
    return true;
  }

  template <class T>
  bool binary(double& out) {
    if (bytes_.size() - at_ < sizeof(T)) return false;
    std::array<std::uint8_t, sizeof(T)> raw{};
    std::copy_n(bytes_.begin() + static_cast<std::ptrdiff_t>(at_), sizeof(T), raw.begin());
    if ((form_ == Form::big) != (std::endian::native == std::endian::big)) std::reverse(raw.begin(), raw.end());
    out = static_cast<double>(std::bit_cast<T>(raw));
    at_ += sizeof(T);
    return true;
  }

  bool ascii(double& out) {
    while (at_ < bytes_.size() && is_space(bytes_[at_])) ++at_;
    const char* begin = bytes_.data() + at_;
    const auto [stop, error] = std::from_chars(begin, bytes_.data() + bytes_.size(), out);
    at_ += static_cast<std::size_t>(stop - begin);
    return error == std::errc{} || error == std::errc::result_out_of_range;
  }

  bool number(Number type, double& out) {
    if (form_ == Form::ascii) return ascii(out);
    // In the order of Number.
    static constexpr bool (Ply::*read[])(double&) = {&Ply::binary<std::int8_t>,  &Ply::binary<std::uint8_t>,
                                                     &Ply::binary<std::int16_t>, &Ply::binary<std::uint16_t>,
                                                     &Ply::binary<std::int32_t>, &Ply::binary<std::uint32_t>,
                                                     &Ply::binary<float>,        &Ply::binary<double>};
    return (this->*read[static_cast<std::size_t>(type)])(out);
  }

  // Reads the property's numbers into values_.
  bool numbers(const Property& p) {
    double count = 1;
    if (p.length && !number(*p.length, count)) return false;
    if (!(count >= 0 && count <= static_cast<double>(bytes_.size() - at_) + 1)) return false;
    values_.resize(static_cast<std::size_t>(count));
    return std::all_of(values_.begin(), values_.end(), [&](double& v) { return number(p.type, v); });
  }

  // Fails for elements of zero bytes, whose number would be unlimited.
  bool skip(const Element& e) {
    return !e.properties.empty() &&
           std::all_of(e.properties.begin(), e.properties.end(), [&](const auto& p) { return numbers(p); });
  }

  bool vertex(const Element& e) {
    std::array<float, 3> position{}, normal{};
    std::array<float, 2> uv{};
    bool normals = false, uvs = false;
    const auto find = [&](const std::string& n) -> float* {
      static const std::array<std::string_view, 3> xyz{"x", "y", "z"}, turned{"nx", "ny", "nz"};
      for (std::size_t k = 0; k < 3; ++k) {
        if (n == xyz[k]) return &position[k];
        if (n == turned[k]) return normals = true, &normal[k];
      }
      if (n == "s" || n == "u" || n == "texture_u") return uvs = true, uv.data();
      if (n == "t" || n == "v" || n == "texture_v") return uvs = true, &uv[1];
      return nullptr;
    };
    for (const auto& p : e.properties) {
      if (!numbers(p)) return false;
      if (float* to = p.length ? nullptr : find(p.name)) *to = static_cast<float>(values_[0]);
    }
    piece_.positions.push_back(position);
    if (normals) piece_.normals.push_back(normal);
    if (uvs) piece_.uvs.push_back({uv[0], 1 - uv[1]});
    return !e.properties.empty();
  }

  bool face(const Element& e) {
    for (const auto& p : e.properties) {
      if (!numbers(p)) return false;
      if (!p.length || (p.name != "vertex_index" && p.name != "vertex_indices")) continue;
      std::vector<std::uint32_t> corners;
      for (const double v : values_) {
        if (!(v >= 0 && v < 4e9)) return false;
        corners.push_back(static_cast<std::uint32_t>(v));
      }
      polygons_ = polygons_ || corners.size() > 3;
      for (std::size_t i = 0; i < corners.size() && corners.size() >= 3; ++i) {
        piece_.edges.insert(piece_.edges.end(), {corners[i], corners[(i + 1) % corners.size()]});
        if (i >= 2) piece_.triangles.insert(piece_.triangles.end(), {corners[0], corners[i - 1], corners[i]});
      }
    }
    return !e.properties.empty();
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
  Form form_ = Form::ascii;
  bool polygons_ = false;
  std::vector<double> values_;
  Mesh piece_;
  Assembly assembly_;
};

}  // namespace

Result<std::shared_ptr<const Mesh>> load_ply(const std::string& path, FileSource& files) {
  const auto bytes = files.read(path);
  if (!bytes) return bytes.error();
  if (bytes->empty()) return fail(ErrorCode::file, fmt::format("{} is empty", path));
  return Ply(*bytes, path).read();
}

}  // namespace betwixt
