// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/sheet_rows.h"

#include <QRegularExpression>
#include <algorithm>
#include <cctype>
#include <set>

#include "betwixt/language.h"
#include "betwixt/object.h"

namespace betwixt::studio {
namespace {

constexpr std::size_t few = 8;  // up to this many objects are opened at first

bool contains(const std::string& text, const std::string& part) {
  const auto alike = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), alike) != text.end();
}

// Tests which tracks match a search.
class Search {
 public:
  Search(const Document& d, const std::string& said) : d_(d), said_(said) {
    pattern_ = said.find_first_of("*?[{") != std::string::npos;
    if (!pattern_) return;
    const std::size_t dot = said.find('.');
    for (const ObjectId id : objects(d, said.substr(0, dot))) objects_.insert(id.index);
    if (dot != std::string::npos) functions_ = said.substr(dot + 1);
  }
  bool may_mean(ObjectId id) const { return !pattern_ || objects_.contains(id.index); }
  bool means(const Target& t) const {
    if (said_.empty()) return true;
    const std::string name = d_.name(t);
    if (!pattern_) return contains(name, said_);
    if (!objects_.contains(t.object.index)) return false;
    const std::string function = name.substr(name.find('.') + 1);
    return functions_.empty() || contains(function, functions_) || matches(function, functions_);
  }

 private:
  static bool matches(const std::string& name, const std::string& pattern) {
    return QRegularExpression(QRegularExpression::wildcardToRegularExpression(QString::fromStdString(pattern)))
        .match(QString::fromStdString(name))
        .hasMatch();
  }

  const Document& d_;
  const std::string& said_;
  bool pattern_ = false;
  std::set<std::uint32_t> objects_;
  std::string functions_;
};

// Adds the parts of groups: man/arm for man.
std::vector<ObjectId> with_parts(const Document& d, const std::vector<ObjectId>& ids) {
  constexpr std::size_t few_wholes = 20;
  std::vector<ObjectId> all;
  std::set<std::uint32_t> there;
  const auto add = [&](ObjectId id) {
    if (there.insert(id.index).second) all.push_back(id);
  };
  for (const ObjectId id : ids) {
    add(id);
    if (ids.size() <= few_wholes && kind(d, id) == Kind::group)
      for (const ObjectId part : objects(d))
        if (d.name(part).starts_with(d.name(id) + "/")) add(part);
  }
  return all;
}

// Calls f(object, its tracks with events) for all objects chosen.
template <class F>
void each_object(const Document& d, const SheetChoice& choice, F&& f) {
  const Search search(d, choice.search);
  for (const ObjectId id : choice.objects.empty() ? objects(d) : with_parts(d, choice.objects)) {
    if (!search.may_mean(id)) continue;
    std::vector<Target> meant;
    for (const TrackView& t : tracks(d, id))
      if (t.event_count > 0 && search.means(t.target)) meant.push_back(t.target);
    if (!meant.empty()) f(id, meant);
  }
}

}  // namespace

std::vector<SheetRow> sheet_rows(const Document& d, const SheetChoice& choice) {
  std::vector<std::pair<ObjectId, std::vector<Target>>> all;
  each_object(d, choice, [&](ObjectId id, std::vector<Target>& tracks) { all.emplace_back(id, std::move(tracks)); });
  std::vector<SheetRow> rows;
  for (const auto& [id, tracks] : all) {
    const auto said = choice.open.find(id.index);
    const bool open = said != choice.open.end() ? said->second : all.size() <= few;
    rows.push_back({id, true, open, {}});
    for (const Target& t : tracks)
      if (open) rows.push_back({id, false, false, t});
  }
  return rows;
}

std::vector<Target> sheet_tracks(const Document& d, const SheetChoice& choice) {
  std::vector<Target> out;
  each_object(d, choice, [&](ObjectId, const std::vector<Target>& tracks) {
    out.insert(out.end(), tracks.begin(), tracks.end());
  });
  return out;
}

std::vector<Target> tracks_of_row(const Document& d, const SheetRow& row) {
  if (!row.whole) return {row.target};
  std::vector<Target> out;
  for (const TrackView& t : tracks(d, row.object))
    if (t.event_count > 0) out.push_back(t.target);
  return out;
}

}  // namespace betwixt::studio
