// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/assets/look_lines.h"

#include <fmt/format.h>

#include "editor/made_by.h"
#include "scene/document.h"
#include "studio/objects/object_lines.h"
#include "syntax/texts.h"

namespace betwixt::studio {
namespace {

// Lines that show the shape of a new hidden object.
Lines borrowed_lines(const Document& d, const std::vector<ObjectId>& objects, const std::string& name,
                     const std::string& made) {
  Lines lines;
  for (const ObjectId id : objects)
    for (const FunctionView& f : functions(d, id))
      if (f.name == "geometry") lines.push_back(fmt::format("set {}.geometry shape({})", d.name(id), name));
  if (!lines.empty()) lines.insert(lines.begin(), fmt::format("create {} {} display=off", name, made));
  return lines;
}

}  // namespace

Lines look_lines(const Document& d, const std::vector<ObjectId>& objects, const std::string& look, Time t,
                 bool makes_events) {
  const std::string function = look.substr(0, look.find(' ')), value = look.substr(look.find(' ') + 1);
  Lines lines;
  for (const ObjectId id : objects)
    for (const FunctionView& f : functions(d, id)) {
      if (f.name != function) continue;
      const Target target(id, f.id);
      const bool event = makes_events && !spec_of(d.scene(), f.id).by_script;
      lines.push_back(event ? line_of_event(d, target, t, value) : line_that_sets(d, target, t, value));
    }
  return lines;
}

Lines shape_lines(const Document& d, const std::vector<ObjectId>& objects, const std::string& path,
                  const std::string& name) {
  Lines lines;
  std::vector<ObjectId> others;
  for (const ObjectId id : objects)
    if (kind(d, id) == Kind::mesh)
      lines.push_back(fmt::format("set {}.file {}", d.name(id), write_text(path)));
    else
      others.push_back(id);
  for (std::string& line : borrowed_lines(d, others, name, "mesh file=" + write_text(path)))
    lines.push_back(std::move(line));
  return lines;
}

Lines kind_lines(const Document& d, const std::vector<ObjectId>& objects, const std::string& kind) {
  if (!kind.empty()) return borrowed_lines(d, objects, free_name(d, kind + "1"), kind);
  Lines lines;
  for (const ObjectId id : objects)
    for (const FunctionView& f : functions(d, id))
      if (f.name == "geometry" && f.set) lines.push_back(fmt::format("set {}.geometry none", d.name(id)));
  return lines;
}

}  // namespace betwixt::studio
