// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/completion_names.h"

#include "commands/parts.h"
#include "track/filter.h"

namespace betwixt {

void own_words(const Scene& s, Role role, Words& all) {
  for (const NamedProcedure& p : *s.procedures)
    if (p.role == role) all.push_back(p.name);
}

void filters(const Scene& s, Words& all) {
  all.emplace_back("none");
  for (const FilterSpec& f : built_in_filters()) all.emplace_back(f.name);
  own_words(s, Role::filter, all);
}

void files(const std::filesystem::path& folder, Words& all) {
  std::error_code why;
  for (const auto& e : std::filesystem::directory_iterator(folder, why)) all.push_back(e.path().filename().string());
}

void objects_of(const Scene& s, Kind kind, Words& all) {
  for (std::size_t i = 0; i < s.objects.size(); ++i)
    if (!s.objects[i].removed && s.objects[i].kind == kind) all.push_back(s.objects[i].name);
}

void columns_of_tables(const Scene& s, Words& all) {
  for (const auto& [name, table] : *s.tables)
    for (const std::string_view column : table->column_names()) all.push_back(name + "." + std::string(column));
}

void let_names(const Scene& s, bool colors, Words& all) {
  if (!colors) columns_of_tables(s, all);
  for (const auto& [name, value] : *s.lets)
    if (std::holds_alternative<Color>(value) == colors) all.push_back(name);
}

bool parameters_of_part(const Scene& s, std::string_view name, Words& all) {
  const auto known = part_called(s, name);
  if (!known) return false;
  for (const PartParameter& p : known->parameters) all.push_back(p.name + "=");
  for (const std::string_view f : function_names(s, Kind::group)) all.push_back(std::string(f) + "=");
  return true;
}

}  // namespace betwixt
