// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "commands/script.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/names.h"
#include "commands/plugins.h"
#include "commands/reader.h"

namespace betwixt {
namespace {

constexpr int most_errors = 1000;  // the most that are reported

}  // namespace

Script::Script(Scene& scene, Diagnostics& to, const LoadOptions& how) : diagnostics(to), options(how) {
  adopt_plugins(scene);
}

Script::Script(Scene& scene, Diagnostics& to, const LoadOptions& how, const ReaderState& from, const Home& home)
    : Script(scene, to, how) {
  static_cast<ReaderState&>(*this) = from;
  live = true;
  root = home.root;
  if (!home.file.empty()) open_files.push_back(home.file);
  files_at_home = open_files.size();
}

Home::Home(const std::string& called) : name(called) {
  std::error_code ignored;
  const std::filesystem::path folder = std::filesystem::path(name).parent_path();
  root = std::filesystem::weakly_canonical(folder.empty() ? "." : folder, ignored);
  if (!name.empty()) file = std::filesystem::weakly_canonical(name, ignored);
}

// Replaces a part of the line by the present time.
void Script::stamp(const Scene& s, std::string_view place, std::string_view before, std::string_view behind) {
  const auto at = static_cast<std::size_t>(place.data() - source.text.data());
  in_time = true;
  stamps.push_back({at, place.size(), fmt::format("{}{}t{}", before, s.ticks.whole(*options.now), behind)});
}

void Script::respell_live(std::string_view place, std::string instead) {
  const auto at = static_cast<std::size_t>(place.data() - source.text.data());
  std::erase_if(stamps, [&](const Stamp& s) { return s.at == at && s.length == place.size(); });  // of another object
  const auto behind = std::find_if(stamps.begin(), stamps.end(), [&](const Stamp& s) { return s.at > at; });
  stamps.insert(behind, {at, place.size(), std::move(instead)});
}

bool Script::in_line(std::string_view place) const {
  const std::less_equal<const char*> up_to;
  return open_files.size() == files_at_home && up_to(source.text.data(), place.data()) &&
         up_to(place.data() + place.size(), source.text.data() + source.text.size());
}

void Script::respell(std::string_view place, std::string instead) {
  if (!spells_out) return;
  const auto at = static_cast<std::size_t>(place.data() - source.text.data());
  std::erase_if(stamps, [&](const Stamp& s) { return s.at >= at; });  // parts of it
  stamps.push_back({at, place.size(), std::move(instead)});
}

std::string Script::stamped() const {
  std::string line(source.text);
  for (auto s = stamps.rbegin(); s != stamps.rend(); ++s) line.replace(s->at, s->length, s->text);
  return line;
}

void Script::report(Severity severity, Error error, std::string_view about) {
  if (severity == Severity::error && ++errors > most_errors) {
    if (!given_up)
      diagnostics.push_back(
          {Severity::error,
           fail(ErrorCode::syntax, fmt::format("there are more than {} errors; the others are not shown", most_errors)),
           {},
           0});
    given_up = true;
    return;
  }
  diagnostics.push_back(source.diagnose(severity, std::move(error), about));
}

const Mentions* Script::mentions(const Scene& s) {
  constexpr std::size_t few = 4;
  if (live || ++asked_ <= few) return nullptr;
  mentions_.follow(s);
  return &mentions_;
}

std::vector<std::uint32_t> Script::speakers(const Scene& s, const std::vector<ObjectId>& of) {
  const Mentions* known = mentions(s);
  return known ? known->of(s, of) : all_of(s.objects);
}

std::vector<ObjectId> Script::below(const Scene& s, const std::string& name, bool drawn) {
  if (!s.names.ever_above(name)) return {};
  const Mentions* known = mentions(s);
  const std::string above = name + "/";
  std::vector<ObjectId> all;
  for (const std::uint32_t i : known ? known->below(name) : all_of(s.objects))
    if (i < s.objects.size())
      if (const Object& o = s.objects[i]; !o.removed && (drawn || !o.derived) && o.name.starts_with(above))
        all.push_back({i});
  return all;
}

void Script::names_nothing(std::string_view pattern) {
  const auto braces =
      live || failed.empty() ? Result<std::vector<std::string>>(std::vector<std::string>()) : expand_braces(pattern);
  const bool followed =
      braces && std::any_of(braces->begin(), braces->end(), [&](const std::string& one) {
        const std::vector<std::string_view> above = with_those_above(one);
        return std::any_of(failed.begin(), failed.end(), [&](const std::string& name) {
          return std::any_of(above.begin(), above.end(), [&](std::string_view part) { return matches(part, name); });
        });
      });
  if (!followed && !file_missing) report(Severity::notice, nothing_named(pattern), pattern);
}

void Script::note(Severity severity, std::string message, std::string_view about, Hint hint) {
  report(severity, fail(ErrorCode::syntax, std::move(message), std::move(hint)), about);
}

std::optional<Diagnostic> Script::withheld(Severity severity, std::string message, std::string_view about) {
  if (given_up) return std::nullopt;
  return source.diagnose(severity, fail(ErrorCode::syntax, std::move(message)), about);
}

}  // namespace betwixt
