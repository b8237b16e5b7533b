// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tracks from columns of numbers, and back. The first and the last event go through the language: the first checks the
// target and the twerper, and the last updates what depends on the track (instances of kinds). All others are put on
// the track directly, and only written as text.
#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/counted.h"
#include "base/names.h"
#include "betwixt/track.h"
#include "editor/session_state.h"
#include "language/values.h"
#include "scene/document.h"

namespace betwixt {
namespace {

Type type_of(const Scene& scene, const Target& t) {
  const FunctionSpec& spec = spec_of(scene, t.function);
  const Type whole = t.velocity ? row_of(spec.type).rate.value_or(Type::text) : spec.type;
  return t.component < 0 ? whole : component_type(whole);
}

// Appends a value of the target's track, or its component.
bool append_numbers(const Value& v, std::size_t width, int component, std::vector<double>& to) {
  const auto put = [&](Vec3 n) {
    if (component >= 0) return to.push_back(n[component]), true;
    to.insert(to.end(), {n.x, n.y});
    if (width == 3) to.push_back(n.z);
    return width > 1;
  };
  if (const auto* n = std::get_if<double>(&v)) return to.push_back(*n), width == 1;
  if (const auto* n = std::get_if<Vec3>(&v)) return put(*n);
  if (const auto* n = std::get_if<Color>(&v)) return put({n->r, n->g, n->b});
  if (const auto* n = std::get_if<Angles>(&v)) return put(n->xyz);
  return false;
}

Result<Target> one_of(std::string_view name, const Document& document) {
  const auto found = find_targets(std::string(name), document);
  if (!found) return found.error();
  if (found->size() != 1)
    return fail(ErrorCode::name, fmt::format("'{}' does not name one track", name.substr(0, 64)),
                "name one, such as ball.position");
  return found->front();
}

Error no_numbers(const Document& document, const Target& target) {
  return fail(ErrorCode::type, fmt::format("the values of '{}' are not numbers", document.name(target)),
              "numbers can be a number, an angle, a vector, a colour or a rotation by angles");
}

Status check(std::span<const Time> times, std::span<const double> numbers, std::size_t width, const FunctionSpec& spec,
             bool velocity) {
  if (times.empty()) return fail(ErrorCode::range, "a track needs at least one time");
  if (numbers.size() != times.size() * width)
    return fail(ErrorCode::range,
                fmt::format("{} {} {}, not {}", counted(times.size(), "time"), times.size() == 1 ? "needs" : "need",
                            counted(times.size() * width, "number"), numbers.size()));
  for (std::size_t i = 1; i < times.size(); ++i)
    if (times[i] <= times[i - 1])
      return fail(ErrorCode::range, fmt::format("time {} is not after the time before it", i + 1));
  const double low = velocity ? -1e300 : spec.low, high = velocity ? 1e300 : spec.high;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!std::isfinite(numbers[i])) return fail(ErrorCode::range, fmt::format("value {} is not finite", i / width + 1));
    if (numbers[i] < low || numbers[i] > high)
      return fail(ErrorCode::range, fmt::format("value {} is {}, which is not from {} to {}", i / width + 1,
                                                write_number(numbers[i]), write_number(low), write_number(high)));
  }
  return Nothing{};
}

}  // namespace

Session::Answer Session::State::set_track(std::string_view name, std::span<const Time> times,
                                          std::span<const double> numbers, std::string_view twerper) {
  if (looks_only) return only_looks();
  const Document before = document();
  const Result<Target> target = one_of(name, before);
  if (!target) return refused(target.error());
  const Type type = type_of(before.scene(), *target);
  if (width_of(type) == 0) return refused(no_numbers(before, *target));
  if (Status s = check(times, numbers, width_of(type), spec_of(before.scene(), target->function), target->velocity); !s)
    return refused(s.error());
  const std::string opener = before.name(*target);
  const auto rows = std::make_shared<const TrackRows>(TrackRows{spec_of(before.scene(), target->function),
                                                                target->component,
                                                                type,
                                                                before.rate(),
                                                                std::string(twerper),
                                                                {times.begin(), times.end()},
                                                                {numbers.begin(), numbers.end()}});
  const auto row = [&](std::size_t i) {
    std::string line;
    rows->write(i, line);
    return line;
  };
  std::vector<std::string> first{opener, row(0)};
  std::optional<std::pair<Time, Time>> there;  // the times of events that it has, on one track or several
  for (const TrackView& t : tracks(before, *target))
    if (t.event_count > 0)
      there = {std::min(t.first, there ? there->first : t.first), std::max(t.last, there ? there->second : t.last)};
  if (there)
    first.insert(first.begin(), fmt::format("clear {} {}..{}", opener, write_time(there->first, before.rate()),
                                            write_time(there->second, before.rate())));
  Point then = editor.now();
  then.script.close();
  Answer answer;
  const auto carried_out = [&](const std::string& line) {
    CommandResult result = editor.carry_out(then, line);
    if (!result.done) answer = {false, false, true, told(result.said, line), hinted(result.said, line)};
    if (result.done) then = std::move(result.after);
    return result.done;
  };
  if (!std::all_of(first.begin(), first.end(), carried_out)) return answer;
  Scene scene = then.document.scene();
  const std::vector<Track*> all = edit_tracks(scene, *target);  // one, or one for each component
  const bool parts = all.size() > 1;
  for (std::size_t k = 0; k < all.size(); ++k) {
    Events& events = all[k]->events;
    if (events.size() != 1) return refused(no_numbers(before, *target));
    const Event pattern = events.front();
    for (std::size_t i = 1; i + 1 < times.size(); ++i) {
      Event e = pattern;
      e.time = times[i];
      e.value = parts ? Value(numbers[i * width_of(type) + k] + 0) : rows->value(i);
      events.put(std::move(e));
    }
  }
  then.document = Document(std::make_shared<const Scene>(std::move(scene)));
  then.script.close();  // it knows the track as it was
  if (times.size() > 1 && !(carried_out(opener) && carried_out(row(times.size() - 1)))) return answer;
  then.script.close();
  first.pop_back();
  if (Status s = take_track(std::move(then), {std::move(first), "", rows}, opener); !s) return refused(s.error());
  tally.command(), sheet_refused = false;
  return done("");
}

// Takes a step whose lines go to the end of the text. If the text ends with the lines of such a step for the same
// target, the new ones replace them, so that a text does not grow with each call.
Status Session::State::take_track(Point then, Step step, const std::string& opener) {
  if (!in_place) return editor.take(std::move(then), std::move(step));
  if (const auto wrong = std::ranges::find(of_text, Severity::error, &Diagnostic::severity); wrong != of_text.end())
    return fail(ErrorCode::syntax, "an error in the script hides this track",
                fmt::format("correct it first: line {}, {}", wrong->what.place.line, wrong->what.message));
  const bool instead = last_opener == opener && &last_made.scene() == &document().scene();
  UnwrittenRows rows{0, step.lines, step.rows, instead};
  if (Status s = editor.take(std::move(then), std::move(step)); !s) return s;
  rows.step = editor.steps().size() - 1;
  unwritten.push_back(std::move(rows));
  last_opener = opener, last_made = document();
  if (!of_text.empty()) read_text_again();
  return Nothing{};
}

void Session::State::write_rows() const {
  for (UnwrittenRows& rows : std::exchange(unwritten, {})) {
    std::string& text = written.text;
    TextEdit edit{text.size(), {}, {}};
    const bool clears = rows.lines[0].starts_with("clear ");
    bool cleared = false;  // earlier events, in front of the rows that these replace
    if (rows.instead && last_rows.end == text.size()) {
      edit.at = last_rows.begin;
      edit.removed = text.substr(edit.at);
      cleared = clears;
    }
    if (edit.at > 0 && text[edit.at - 1] != '\n') edit.inserted += '\n';
    last_rows.begin = edit.at + edit.inserted.size();
    for (std::size_t i = cleared ? 1 : 0; i < rows.lines.size(); ++i) {
      (edit.inserted += rows.lines[i]) += '\n';
      if (clears && i == 0) last_rows.begin = edit.at + edit.inserted.size();
    }
    rows.rows->write_all("", "\n", edit.inserted);
    text.resize(edit.at);
    text += edit.inserted;
    last_rows.end = text.size();
    written.edits.resize(rows.step);
    written.edits.push_back({std::move(edit)});
  }
}

Session::Answer Session::set_track(std::string_view target, std::span<const Time> times,
                                   std::span<const double> numbers, std::string_view twerper) {
  return state_->set_track(target, times, numbers, twerper);
}

Result<TrackNumbers> track_numbers(const Document& document, std::string_view name) {
  const Result<Target> target = one_of(name, document);
  if (!target) return target.error();
  const Scene& scene = document.scene();
  TrackNumbers made;
  made.width = width_of(type_of(scene, *target));
  if (made.width == 0) return no_numbers(document, *target);
  const std::vector<const Track*> tracks = tracks_of(scene, *target);
  const Slot* const slot = scene.objects[target->object.index].find(target->function, target->layer);
  if (target->component < 0 && slot && !slot->components.empty())
    return fail(ErrorCode::type, fmt::format("the components of '{}' have tracks of their own", document.name(*target)),
                fmt::format("name one, such as {}.{}", document.name(*target),
                            component_name(spec_of(scene, target->function).type, 0)));
  if (tracks.empty()) return made;
  bool good = true;
  made.times.reserve(tracks[0]->events.size());
  made.numbers.reserve(tracks[0]->events.size() * made.width);
  tracks[0]->events.each([&](const Event& e) {
    if (e.keep || e.release || !good) return;
    good = append_numbers(e.value, made.width, target->component, made.numbers);
    made.times.push_back(e.time);
  });
  if (!good)
    return fail(ErrorCode::type, fmt::format("the events of '{}' are not all numbers", document.name(*target)));
  return made;
}

}  // namespace betwixt
