// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "language/moments.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/counted.h"
#include "base/names.h"
#include "language/captions.h"
#include "language/formula.h"
#include "program/audible_part.h"
#include "scene/names.h"

namespace betwixt {
namespace {

constexpr std::size_t most_offered = 500;

bool of_moment_name(char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '-' || c == '/'; }

// The form of such a time: NAME:"…" or NAME.start or NAME.end.
struct MomentForm {
  std::string_view name;
  bool words = false;
  explicit operator bool() const { return !name.empty(); }
};

// Returns whether a dot and this word are there, and the word ends.
bool dotted(const char* at, const char* end, std::string_view word) {
  if (at == end || *at != '.' || !between(at + 1, end).starts_with(word)) return false;
  const char* const behind = at + 1 + word.size();
  return behind == end || !(is_letter(*behind) || is_digit(*behind) || *behind == '_');
}

MomentForm form_of_moment(const char* at, const char* end) {
  const char* p = at;
  if (p == end || !is_letter(*p)) return {};
  while (p < end && of_moment_name(*p)) ++p;
  if (end - p >= 2 && p[0] == ':' && p[1] == '"') return {between(at, p), true};
  if (dotted(p, end, "start") || dotted(p, end, "end")) return {between(at, p), false};
  return {};
}

// A sound that the script has named, and its part that is heard.
struct NamedSound {
  std::string_view name;
  std::string file;
  const SpokenWords* words = nullptr;
  AudiblePart part;
  double in_film(double own) const { return part.at + (own - part.from); }
};

// Returns the value at the beginning of the film, as the mix of the sounds takes it.
Value beginning_of(const Object& o, FunctionId f) {
  const Slot* const slot = o.find(f);
  if (slot && !slot->track->events.empty()) return slot->track->events.front().value;
  if (slot && slot->set) return *slot->set;
  return built_in_functions()[f].rest;
}

std::string text_of(const Object& o, FunctionId f) {
  const Value v = beginning_of(o, f);
  const Text* const text = std::get_if<Text>(&v);
  return text ? **text : std::string();
}

NamedSound sound_of(const Scene& s, const Object& o) {
  NamedSound sound{o.name, text_of(o, fn::sound_file), nullptr, {}};
  const std::string named = text_of(o, fn::sound_words);
  // A text that is said has its words by the name of its sound.
  if (const auto words = s.words->find(named.empty() ? sound.file : named); words != s.words->end())
    sound.words = words->second.get();
  const auto known = s.sounds->find(sound.file);
  double length = known == s.sounds->end() ? 0 : known->second->seconds;
  if (length <= 0 && sound.words && !sound.words->words.empty()) length = sound.words->words.back().end;  // in pages
  sound.part = audible_part(length, [&](FunctionId f) {
    const Value v = beginning_of(o, f);
    const double* const number = std::get_if<double>(&v);
    return number ? *number : 0.0;
  });
  return sound;
}

bool find_sound(Cursor& c, std::string_view name, NamedSound& out) {
  if (!c.moments) return c.fail(ErrorCode::name, fmt::format("the times of '{}' are not known here", name), name);
  const Scene& s = *c.moments;
  const ObjectId id = s.names.find(name);
  if (!id) return c.fail(unknown_name("object", name, near_object(s, name)), name);
  const Object& o = s.objects[id.index];
  if (o.kind != Kind::sound)
    return c.fail(ErrorCode::type, fmt::format("'{}' is no sound, so it has no words and no end", name), name);
  out = sound_of(s, o);
  return true;
}

Hint times_of(const NamedSound& sound, const std::vector<SpokenRun>& runs) {
  constexpr std::size_t most = 5;
  std::string said;
  for (std::size_t i = 0; i < std::min(runs.size(), most); ++i)
    said += fmt::format("{}{:.2f}s", i == 0 ? "" : ", ", sound.in_film(sound.words->words[runs[i].first].start));
  return fmt::format("they begin at {}{}", said, runs.size() > most ? " …" : "");
}

bool not_spoken(Cursor& c, const NamedSound& sound, std::string_view letters, std::string_view about) {
  const std::string message = fmt::format("{} is not spoken in '{}'", about, sound.name);
  const auto near = nearest_spoken(*sound.words, letters);
  if (!near) return c.fail(ErrorCode::name, message, about);
  const std::string instead = fmt::format("\"{}\"", spelt(*sound.words, *near));
  const double at = sound.in_film(sound.words->words[near->first].start);
  return c.fail(ErrorCode::name, message, about,
                Hint(fmt::format("did you mean {}? It begins at {:.2f}s", instead, at), instead));
}

// Finds the words, and removes those that the sound's `from` and `until` cut off.
bool find_runs(Cursor& c, const NamedSound& sound, std::string_view said, std::string_view about,
               std::vector<SpokenRun>& runs) {
  const std::string letters = letters_of(said);
  if (letters.empty()) return c.fail(ErrorCode::syntax, "words are missing between the quotes", about);
  runs = find_spoken(*sound.words, letters);
  if (runs.empty()) return not_spoken(c, sound, letters, about);
  const std::vector<SpokenRun> all = runs;
  std::erase_if(runs, [&](const SpokenRun& run) {
    const SpokenWord& word = sound.words->words[run.first];
    return word.start < sound.part.from || word.start >= sound.part.until;
  });
  if (!runs.empty()) return true;
  return c.fail(ErrorCode::name, fmt::format("{} is not in the part of '{}' that is heard", about, sound.name), about,
                fmt::format("it is at second {:.2f} of the file; from= and until= cut it off",
                            sound.words->words[all.front().first].start));
}

// Takes #2 behind the words.
bool which_time(Cursor& c, std::size_t& out) {
  out = 1;
  if (c.peek() != '#') return true;
  const char* const start = c.at++;
  std::size_t n = 0;
  while (c.at < c.end && is_digit(*c.at) && n < 100'000'000) n = 10 * n + static_cast<std::size_t>(*c.at++ - '0');
  if (n > 0) return out = n, true;
  return c.fail(ErrorCode::syntax, "a number from 1 is missing after '#'", c.since(start), "as in voice:\"square\"#2");
}

bool time_of_words(Cursor& c, const NamedSound& sound, double& out) {
  const char* const start = ++c.at;  // behind the colon
  std::string said;
  if (!c.text(said)) return false;
  const std::string_view about = c.since(start);
  std::size_t which = 1;
  if (!which_time(c, which)) return false;
  const std::string_view whole = c.since(start);
  bool ends = false;
  if (dotted(c.at, c.end, "end"))
    ends = true, c.at += 4;
  else if (dotted(c.at, c.end, "start"))
    c.at += 6;
  else if (c.end - c.at > 1 && *c.at == '.' && is_letter(c.at[1]))
    return c.fail_here(ErrorCode::name, fmt::format("words have no '{}'", c.peek_word().substr(0, 40)),
                       "write .end for when they end, and .start or nothing for when they begin");
  if (!sound.words)
    return c.fail(ErrorCode::type, fmt::format("'{}' has no words", sound.name), about,
                  fmt::format("say words=\"FILE\" where you create {}; betwixt words makes the file", sound.name));
  std::vector<SpokenRun> runs;
  if (!find_runs(c, sound, said, about, runs)) return false;
  if (which > runs.size())
    return c.fail(ErrorCode::range,
                  fmt::format("{} is spoken {} in '{}'", about, counted(runs.size(), "time"), sound.name), whole,
                  times_of(sound, runs));
  const SpokenRun run = runs[which - 1];
  out = ends ? sound.words->words[run.last].end : sound.words->words[run.first].start;
  return true;
}

// Reads NAME.start or NAME.end of a section. Objects come first: their names may be those of sections.
std::optional<Result<Time>> edge_of_section(const Cursor& c, const MomentForm& form) {
  if (form.words || !c.sections || (c.moments && c.moments->names.find(form.name))) return std::nullopt;
  Result<Time> edge = (*c.sections)(form.name, dotted(form.name.data() + form.name.size(), c.end, "end"));
  if (!edge && edge.error().code == ErrorCode::name && edge.error().hint.empty() && c.moments &&
      !near_object(*c.moments, form.name).empty())
    return std::nullopt;
  return edge;
}

}  // namespace

bool moment_begins(const Cursor& c, const char* at) {
  const MomentForm form = form_of_moment(at, c.end);
  if (!form) return false;
  const std::size_t stop = form.name.find_first_of("-/");
  if (stop == std::string_view::npos || (c.moments && c.moments->names.find(form.name))) return true;
  // beat-voice.end is a difference.
  const std::string_view before = form.name.substr(0, stop);
  return !is_formula_word(before) && !(c.lets && c.lets->find(before) != c.lets->end());
}

bool moment(Cursor& c, Quantity& out) {
  const MomentForm form = form_of_moment(c.at, c.end);
  if (const auto edge = edge_of_section(c, form)) {
    if (!*edge) return c.fail(edge->error(), form.name);
    c.at += form.name.size() + (dotted(form.name.data() + form.name.size(), c.end, "end") ? 4 : 6);
    return out = {Quantity::Of::time, (*edge)->seconds(), 1, true}, true;
  }
  NamedSound sound;
  if (!find_sound(c, form.name, sound)) return false;
  c.at += form.name.size();
  double own = sound.part.from;
  if (form.words) {
    if (!time_of_words(c, sound, own)) return false;
  } else if (dotted(c.at, c.end, "end")) {
    own = std::max(own, sound.part.end()), c.at += 4;
  } else {
    c.at += 6;
  }
  // Frame 1 is the beginning of the film, so that 12f behind it are a length of 12 frames.
  return out = {Quantity::Of::time, sound.in_film(own), 1, true}, true;
}

std::size_t moment_length(std::string_view text) {
  const char* const end = text.data() + text.size();
  const MomentForm form = form_of_moment(text.data(), end);
  if (!form) return 0;
  const char* at = text.data() + form.name.size();
  if (form.words) {
    const QuotedEnd quoted = quoted_end(at + 1, end);
    at = quoted.at;
    if (!quoted.closed) return static_cast<std::size_t>(at - text.data());
    if (at < end && *at == '#') at = std::find_if_not(at + 1, end, is_digit);
  }
  if (dotted(at, end, "end")) at += 4;
  if (dotted(at, end, "start")) at += 6;
  return static_cast<std::size_t>(at - text.data());
}

std::vector<SpokenWord> words_heard(const Scene& s, ObjectId id) {
  const NamedSound sound = sound_of(s, s.objects[id.index]);
  std::vector<SpokenWord> all;
  if (!sound.words) return all;
  for (const SpokenWord& word : sound.words->words)
    if (word.start >= sound.part.from && word.start < sound.part.until)
      all.push_back({sound.in_film(word.start), sound.in_film(std::min(word.end, sound.part.until)), word.text});
  return all;
}

std::vector<std::string> moments_like(const Scene& s, std::string_view begun) {
  std::vector<std::string> all;
  const MomentForm form = form_of_moment(begun.data(), begun.data() + begun.size());
  const ObjectId id = form.words ? s.names.find(form.name) : ObjectId{};
  if (!id || s.objects[id.index].kind != Kind::sound) return all;
  const NamedSound sound = sound_of(s, s.objects[id.index]);
  if (!sound.words) return all;
  const std::string_view said = begun.substr(form.name.size() + 2);
  const std::size_t blank_at = said.rfind(' ');
  const std::size_t partial = blank_at == std::string_view::npos ? 0 : blank_at + 1;
  const std::string before = letters_of(said.substr(0, partial)), part = letters_of(said.substr(partial));
  const auto offer = [&](std::size_t i) {
    if (i >= sound.words->words.size() || !letters_of(sound.words->words[i].text).starts_with(part)) return;
    std::string word = spelt(*sound.words, {i, i});
    if (!word.starts_with(said.substr(partial))) word = letters_of(word);
    all.push_back(fmt::format("{}{}\"", begun.substr(0, begun.size() - (said.size() - partial)), word));
  };
  if (before.empty())
    for (std::size_t i = 0; i < sound.words->words.size() && all.size() < most_offered; ++i) offer(i);
  else
    for (const SpokenRun& run : find_spoken(*sound.words, before))
      if (all.size() < most_offered) offer(run.last + 1);
  return all;
}

std::vector<std::string> moment_names(const Scene& s) {
  std::vector<std::string> all;
  for (std::size_t i = 0; i < s.objects.size() && all.size() < most_offered; ++i) {
    const Object& o = s.objects[i];
    if (o.removed || o.kind != Kind::sound) continue;
    if (sound_of(s, o).words) all.push_back(o.name + ":\"");
    all.push_back(o.name + ".start"), all.push_back(o.name + ".end");
  }
  return all;
}

}  // namespace betwixt
