// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/value_parts.h"

#include <fmt/format.h>

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "betwixt/language.h"
#include "betwixt/object.h"
#include "commands/line_head.h"
#include "editor/plain_values.h"
#include "editor/text_rows.h"
#include "language/values.h"
#include "scene/document.h"
#include "studio/panels/filter_lines.h"
#include "studio/shell/text_of.h"
#include "track/filter.h"
#include "track/types.h"

namespace betwixt::studio {
namespace {

using What = ValuePart::What;

// Words of the window, in the user's language.
struct PartWords {
  Q_DECLARE_TR_FUNCTIONS(betwixt::studio::PartWords)
};
template <class... Of>
std::string in_words(QString words, const Of&... of) {
  ((words = words.arg(text_of(of))), ...);
  return words.toStdString();
}

class PartFinder : PartWords {
 public:
  PartFinder(const Document& d, const Program& program, const std::string& text, const Target& whole, Time at)
      : d_(d), program_(program), text_(text), whole_(whole), at_(at), spec_(spec_of(d.scene(), whole.function)) {
    for (const TrackView& t : tracks(d, whole.object))
      if (t.target.function == whole.function && t.event_count > 0) tracks_.push_back(t);
    std::vector<Target> asked{whole};
    for (const TrackView& t : tracks_) asked.push_back(t.target);
    rows_ = rows_about(text, d, asked);
  }

  std::vector<ValuePart> find() {
    const Object* o = find_object(d_.scene(), whole_.object);
    if (!o) return {};
    if (const Slot* own = o->find(whole_.function)) {
      if (own->set) value(*own);
      for (const TrackView& t : tracks_)
        if (!t.target.layer && !t.target.velocity) events(t);
      for (const TrackView& t : tracks_)
        if (!t.target.layer && t.target.velocity) velocity(t);
    }
    filters({});
    for (const LayerView& l : layers(d_))
      if (o->find(whole_.function, l.id)) layer(l), filters(l.id);
    return std::move(all_);
  }

 private:
  std::string name(const Target& t) const { return d_.name(t).substr(d_.name(t.object).size() + 1); }
  std::string when(Time t) const { return format_time(t, d_); }

  // The lines of a sheet, or of an `at` line, that has this track last.
  void place(ValuePart& part, const Target& t) const {
    for (auto s = rows_.sheets.rbegin(); s != rows_.sheets.rend(); ++s) {
      if (std::ranges::find(s->targets, t) == s->targets.end()) continue;
      part.lines = s->opener, part.own = s->targets.size() == 1;
      return;
    }
  }

  void value(const Slot& slot) {
    ValuePart part;
    part.target = whole_;
    const auto* code = std::get_if<Procedure>(&*slot.set);
    part.what = code ? What::code : What::set;
    part.title = in_words(code ? tr("code") : tr("value"));
    part.sentence = in_words(code           ? tr("Code computes the value at each time.")
                             : has_events() ? tr("The value before the first event.")
                                            : tr("The value for the whole film."));
    for (const ValueText& v : rows_.values)
      if (v.target == whole_) part.lines = v.value, part.own = true;
    if (code) {
      part.fields.push_back(code_field(*slot.set));
    } else if (has_events()) {
      part.fields.push_back(numbers_of(*slot.set, whole_));
    }
    all_.push_back(std::move(part));
  }
  bool has_events() const {
    return std::ranges::any_of(tracks_, [](const TrackView& t) { return !t.target.layer && !t.target.velocity; });
  }

  void keys_of(ValuePart& part, const TrackView& t) const {
    each_event(d_, t.target, t.first, t.last, [&](const EventView& e) { part.keys.push_back({t.target, e.time}); });
  }
  std::string count_words(const TrackView& t) const {
    return t.event_count == 1
               ? in_words(tr("1 event at %1"), when(t.first))
               : in_words(tr("%1 events, %2 to %3"), std::to_string(t.event_count), when(t.first), when(t.last));
  }

  void events(const TrackView& t) {
    ValuePart part{.what = What::events, .target = t.target};
    part.title = (t.target.component >= 0 ? name(t.target) + ": " : "") + count_words(t);
    part.sentence = in_words(tr("The events (keyframes). Click to select them and to see their sheet."));
    keys_of(part, t), place(part, t.target);
    all_.push_back(std::move(part));
    each_event(d_, t.target, t.first, t.last, [&](const EventView& e) {
      if (e.value && std::holds_alternative<Procedure>(*e.value)) code_at(t.target, e);
    });
  }

  // Code in the place of an event's value.
  void code_at(const Target& t, const EventView& e) {
    ValuePart part{.what = What::code, .target = t};
    part.title = in_words(tr("code at %1"), when(e.time));
    part.sentence = in_words(tr("Code computes the value from this event to the next one."));
    part.fields.push_back(code_field(*e.value));
    part.keys = {{t, e.time}};
    for (const SheetText& s : rows_.sheets)
      for (const RowText& row : s.rows)
        if (row.when == e.time && std::ranges::find(s.targets, t) != s.targets.end()) part.lines = row.line;
    all_.push_back(std::move(part));
  }
  static PartField code_field(const Value& v) {
    PartField field;
    field.numbers = {std::string(procedure(std::get<Procedure>(v)).source)};
    field.text = true;
    return field;
  }

  void velocity(const TrackView& t) {
    ValuePart part{.what = What::velocity, .target = t.target};
    part.title = name(t.target);
    part.sentence = in_words(
        tr("From its first event on, the velocity moves the value; later events of the value have no effect."));
    part.fields.push_back(numbers_of(program_.read(t.target, at_), t.target));
    keys_of(part, t), place(part, t.target);
    all_.push_back(std::move(part));
  }

  void layer(const LayerView& l) {
    ValuePart part{.what = What::layer, .target = whole_};
    part.target.layer = l.id;
    part.title = in_words(tr("layer %1 (%2)"), d_.name(l.id), l.mode);
    part.sentence = in_words(l.mode == "add" ? tr("Its values, times its weight, are added.")
                                             : tr("Its values replace those below, in proportion to its weight."));
    PartField weight{.key = "weight",
                     .numbers = {plain_value(program_.read(l.weight, at_), l.weight, d_)},
                     .unit = {},
                     .low = 0,
                     .high = 1};
    part.fields.push_back(std::move(weight));
    const Program bare = Program::compile(bare_tracks(d_, {whole_.object}, l.id), program_);
    bool parts = false;
    for (const TrackView& t : tracks_) {
      if (t.target.layer != l.id) continue;
      keys_of(part, t);
      if (part.lines.size == 0) place(part, t.target);
      parts = parts || t.target.component >= 0;
    }
    if (!parts) part.fields.push_back(numbers_of(bare.read(whole_, at_), whole_));
    all_.push_back(std::move(part));
  }

  // The numbers of a value; a value of no numbers is one text.
  PartField numbers_of(const Value& v, const Target& t) const {
    PartField field;
    const Type type = spec_.type;
    const bool angle = row_of(type).angles;
    field.unit = angle ? "deg" : "";
    const auto* vector = std::get_if<Vec3>(&v);
    const auto* angles = std::get_if<Angles>(&v);
    if (!vector && !angles) {
      field.text = !std::holds_alternative<double>(v);
      field.numbers = {plain_value(v, t, d_)};
      return field;
    }
    for (int i = 0; i < (type == Type::pair ? 2 : 3); ++i)
      field.numbers.push_back(
          plain_value(Value(vector ? (*vector)[i] : angles->xyz[i]), Target(t.object, t.function, i), d_));
    return field;
  }

  void filters(ObjectId layer) {
    Target on = whole_;
    on.layer = layer;
    for (FilterLine& f : filter_lines(d_, text_, on)) {
      ValuePart part{.what = What::filter, .target = on};
      part.target.component = f.component;
      part.title = f.name;
      if (f.component >= 0) part.title = in_words(tr("%1 of %2"), part.title, name(part.target));
      if (layer) part.title = in_words(tr("%1 on %2"), part.title, d_.name(layer));
      part.index = f.index, part.off = f.off, part.comment = f.comment, part.lines = f.line, part.own = f.own;
      const FilterSpec* spec = find_filter(f.name);
      part.sentence = spec ? std::string(spec->sentence) : in_words(tr("A filter of your own."));
      part.fields = fields_of(f, spec_);
      all_.push_back(std::move(part));
    }
  }

  const Document& d_;
  const Program& program_;
  const std::string& text_;
  const Target whole_;
  const Time at_;
  const FunctionSpec& spec_;
  std::vector<TrackView> tracks_;
  TextRows rows_;
  std::vector<ValuePart> all_;
};

}  // namespace

std::vector<ValuePart> value_parts(const Document& d, const Program& program, const std::string& text,
                                   const Target& whole, Time at) {
  return PartFinder(d, program, text, whole, at).find();
}

}  // namespace betwixt::studio
