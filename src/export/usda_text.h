// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The text of a USD file: lines, attributes with their samples, names, and parts that need no program.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "betwixt/export.h"
#include "betwixt/keys.h"
#include "export/seen.h"

namespace betwixt {

class UsdText {
 protected:
  using Written = std::string (*)(const KeyValue&, std::size_t width);
  UsdText(const Document& document, ExportOptions options, Exported& made)
      : document_(document), options_(std::move(options)), made_(made), rate_(document.rate().per_second()) {}

  static std::string number(double);
  static std::string moment(double frames);  // without an exponent, which some readers do not know there
  static std::string row(const KeyValue&, std::size_t width);
  static std::string turn(const KeyValue&, std::size_t);  // USD has the real part first
  static std::string matrix(const Mat4&);
  static std::string shortest(float);
  static std::string letters(std::string_view name);  // letters, digits and '_'
  // Makes a name like that which is new. No two names in the file are equal, since some readers ignore paths.
  std::string plain(std::string_view name);

  void line(int depth, std::string_view text);
  // Writes an attribute: its value, or its samples.
  void attribute(int depth, const std::string& name, const Channel&, Written written = row);
  // Writes samples of all joints together, at the times of all.
  void together(int depth, const std::string& name, const std::vector<const ObjectKeys*>& joints,
                Channel ObjectKeys::*channel, Written written);
  template <class One>
  void list(int depth, const std::string& name, std::size_t count, const One& one, std::string_view behind = {}) {
    out_.append(static_cast<std::size_t>(4 * depth), ' ');
    out_ += name;
    out_ += " [";
    for (std::size_t i = 0; i < count; ++i) {
      if (i) out_ += ", ";
      out_ += one(i);
    }
    out_ += "]";
    out_ += behind;
    out_ += '\n';
  }
  void visibility(int depth, const Seen&, int form);
  void geometry(int depth, const Mesh&);
  void lens(int depth, bool orthographic, double wide);  // in tenths of a unit, as in USD

  const Document& document_;
  ExportOptions options_;
  Exported& made_;
  const double rate_;
  std::string out_;

 private:
  std::set<std::string> taken_{"film", "camera",   "light",     "looks",   "shapes",
                               "mesh", "skeleton", "animation", "surface", "view"};
};

// Returns the numbers of a finish that UsdPreviewSurface has, by their names there.
std::vector<std::pair<std::string_view, double>> finish_inputs(const Finish&);

}  // namespace betwixt
