// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Writes a document as a script that makes it.
#include <fmt/format.h>

#include <algorithm>

#include "betwixt/language.h"
#include "language/formula.h"
#include "language/values.h"
#include "language/written_scenes.h"
#include "scene/formula_parts.h"
#include "scene/names.h"
#include "scene/own_kinds.h"
#include "scene/power.h"

namespace betwixt {
namespace {

struct Writer {
  const Scene& s;
  Document document;
  std::string out;
  bool brief = false;  // no headings without rows

  std::string name_of(ObjectId id) const {
    const Object* o = find_object(s, id);
    return o ? o->name : "";
  }
  std::string value(const Value& v, const FunctionSpec& spec, int component) const {
    const bool turns = row_of(spec.type).changes == Changes::by_turning;
    if (const auto* m = std::get_if<Moves>(&v))
      return write_value(Moves(about_what_is_there(s, **m)), spec, component, {});
    if (const auto* p = std::get_if<Vec3>(&v); p && turns && component < 0)  // an angular velocity
      return "spin" + value(Angles{*p}, spec, -1).substr(5);
    return write_value(v, spec, component, [this](ObjectId id) { return name_of(id); });
  }
  // Writes a length of time that reads back to the same flicks.
  std::string length(Time t) const {
    const double frames = document.rate().frame_number(t) - 1;
    if (frames == std::round(frames) && document.rate().span(frames) == t) return write_number(frames) + "f";
    return write_seconds(t);
  }
  std::string point(Time t) const { return write_time(t, s.rate); }
  static std::string stops(const Stops& stops) {
    std::string out;
    for (const SaidStop& s : as_said(stops)) {
      out += (out.empty() ? "" : " ") + write_number(s.value);
      if (s.place) out += " " + write_number(*s.place) + "%";
    }
    return out;
  }
  // Writes a twerper with its arguments in brackets.
  std::string twerper(Twerper t, const TwerperArguments& arguments) const {
    std::string text = twerper_name(s, t);
    if (arguments.stops) return fmt::format("{}({})", text, stops(*arguments.stops));
    if (!takes_arguments(t)) return text;
    const TwerperRow& row = row_of(t);
    std::vector<std::string> all;
    for (std::size_t i = 0; i < row.arguments.size(); ++i) all.push_back(write_number(arguments[i]));
    if (!row.words.empty() && arguments[all.size()] > 0)
      all.emplace_back(row.words[static_cast<std::size_t>(arguments[all.size()])]);
    return fmt::format("{}({})", text, fmt::join(all, " "));
  }

  std::string stepping(const Stepping& s) const {
    return (s.every > Time{} ? " every " + length(s.every) : "") + (s.from != Time{} ? " from " + point(s.from) : "") +
           (s.hold ? " hold" : "");
  }

  static std::string parameters(const NamedProcedure& p) {
    std::string out;
    for (const CommandParameter& one : p.parameters)
      out += fmt::format("{}{} {}{}", out.empty() ? "" : ", ", one.name, one.type,
                         one.said.empty() ? "" : " = " + one.said);
    if (!out.empty()) out = " (" + out + ")";
    return p.help.empty() ? out : out + " " + write_text(p.help);
  }

  void row(const Event& e, const FunctionSpec& spec, int component) { row(e, spec, component, "", e.detail->ease_in); }
  void row(const Event& e, const FunctionSpec& spec, int component, const std::string& until, Time ease_in) {
    out += "  " + point(e.time) + until + " ";
    if (e.release) {
      out += "release\n";
      return;
    }
    if (e.keep) {
      out += "keep";
    } else {
      if (e.detail->before) out += value(*e.detail->before, spec, component) + " cut ";
      out += value(e.value, spec, component);
    }
    if (e.twerper != Twerper::unset) out += " " + twerper(e.twerper, e.detail->arguments);
    const auto tangent = [&](const char* side, const std::optional<Value>& v, const std::optional<Time>& handle) {
      if (!v) return;
      const std::string said = value(*v, spec, component);
      out += handle ? fmt::format(" handle-{}=({} {})", side, length(*handle), said)
                    : fmt::format(" tangent-{}={}", side, said);
    };
    tangent("in", e.detail->tangent_in, e.detail->handle_in);
    tangent("out", e.detail->tangent_out, e.detail->handle_out);
    if (ease_in != Time{}) out += " ease-in=" + length(ease_in);
    if (e.detail->ease_out != Time{}) out += " ease-out=" + length(e.detail->ease_out);
    out += "\n";
  }

  // Writes a motion and its end as one row.
  void motions(const Track& t, const FunctionSpec& spec) {
    std::vector<Event> events;
    t.events.each([&](const Event& e) { events.push_back(e); });
    const auto rest = [](const Event& e) {
      const auto* m = std::get_if<Moves>(&e.value);
      EventDetail plain = *e.detail;
      plain.ease_in = {};
      return m && (*m)->factors.empty() && !e.keep && plain == EventDetail{} && e.twerper == Twerper::unset;
    };
    Time eased;  // the ease-in written by the previous row
    for (std::size_t i = 0; i < events.size(); ++i) {
      Event e = events[i];
      const bool ends = i + 1 < events.size() && !rest(e) && !e.keep;
      if (ends) {
        if (e.detail->ease_in != eased)  // an ease-in without a motion before it
          row({e.time, Moves(), {}, Twerper::unset, false, false}, spec, -1, "", e.detail->ease_in);
        eased = events[i + 1].detail->ease_in;
        if (e.detail) e.detail.edit().ease_in = {};
      }
      row(e, spec, -1, ends ? ".." + point(events[i + 1].time) : "", ends ? eased : e.detail->ease_in);
      if (!ends) eased = {};
      if (ends && rest(events[i + 1])) ++i, eased = {};
    }
  }

  void track(const Track& t, const Target& target) {
    const FunctionSpec& spec = spec_of(s, target.function);
    const std::string name = document.name(target), layer = on(target.layer);
    if (!t.events.empty() || (target.component >= 0 && !brief)) {
      out += layer + name + "\n";
      if (spec.type == Type::motion)
        motions(t, spec);
      else
        t.events.each([&](const Event& e) { row(e, spec, target.component); });
    }
    manner(t, target);
  }

  // Writes the track's global twerper, and its values outside its events.
  void manner(const Track& t, const Target& target) {
    const std::string name = document.name(target), layer = on(target.layer);
    if (t.global != Twerper::unset || t.srgb) {
      out += layer + "twerper " + name + " " + (t.global == Twerper::unset ? "none" : twerper(t.global, t.arguments));
      out += t.srgb ? " in=srgb\n" : "\n";
    }
    if (t.before == t.after && t.before != Extrapolation::hold)
      out += layer + fmt::format("extend {} {}\n", name, extrapolation_names[static_cast<std::size_t>(t.before)]);
    if (t.before == t.after) return;
    out += layer + fmt::format("extend {} {} before\n", name, extrapolation_names[static_cast<std::size_t>(t.before)]);
    out += layer + fmt::format("extend {} {} after\n", name, extrapolation_names[static_cast<std::size_t>(t.after)]);
  }

  void rows(const Target& t) {
    const FunctionSpec& spec = spec_of(s, t.function);
    for (const Track* track : tracks_of(s, t)) {
      if (spec.type == Type::motion && !t.velocity)
        motions(*track, spec);
      else
        track->events.each([&](const Event& e) { row(e, spec, t.component); });
    }
  }

  // Writes everything about a function except the rows of `but`.
  void besides(const Target& but) {
    for (const Slot& slot : s.objects[but.object.index].slots) {
      if (slot.function != but.function) continue;
      Target t{but.object, slot.function};
      t.layer = slot.layer;
      const bool own = !slot.layer;
      const Events& rows = slot.track->events;
      const bool code = slot.set && std::holds_alternative<Procedure>(*slot.set);
      const bool counts =
          code || !slot.components.empty() || (!rows.empty() && rows.front().time > Time{});  // visible before its rows
      if (slot.set && (!own || counts)) late(but.object.index, slot);
      own ? manner(slot, t, but.component) : strand(slot, t);
      t.velocity = true;
      own&& but.velocity ? manner(slot.velocity, t, but.component) : strand(slot.velocity, t);
      for (const Filter& f : slot.filters)
        if (but.component < 0 || f.component < 0 || f.component == but.component)
          filter(f, {but.object, slot.function, f.component}, slot.layer);
    }
  }

  // Writes the twerpers and extrapolations of a strand's tracks, without their rows.
  void manner(const Strand& of, Target t, int component) {
    manner(*of.track, t);
    for (std::size_t k = 0; k < of.components.size(); ++k) {
      t.component = static_cast<int>(k);
      if (component < 0 || component == t.component) manner(*of.components[k], t);
    }
  }

  void settings() {
    const auto rate = [](Rate r) { return r.den == 1 ? std::to_string(r.num) : fmt::format("{}/{}", r.num, r.den); };
    if (!(s.rate == Rate{})) out += "rate " + rate(s.rate) + "\n";
    if (!(s.ticks == Rate{30, 1}) || s.smooth_ticks)
      out += "ticks " + rate(s.ticks) + (s.smooth_ticks ? " smooth\n" : "\n");
    if (s.range) out += "range " + point(s.range->first) + " " + point(s.range->second) + "\n";
    out += write_appearance(s);
    if (!s.notes_shown) out += "notes off\n";
    for (const NamedProcedure& p : *s.procedures)
      if (p.code->language == "lua")
        out += fmt::format("procedure {} {}{}{} lua {}\n", p.name, role_names[static_cast<std::size_t>(p.role)],
                           stepping(p.stepping), parameters(p), write_text(p.code->source));
      else
        out += as_comment(fmt::format("{} comes from the plug-in {}", p.name, p.code->source));
    for (const auto& [name, let] : *s.lets) out += fmt::format("let {} = {}\n", name, write_let(let));
    out += write_parts_and_tables(s);
    for (const FunctionSpec& f : *s.defined)
      out += fmt::format("define {} {} {}\n", f.name, row_of(f.type).word, value(f.rest, f, -1));
  }

  // Behind the names that objects have only for a moment: a rename changes aliases.
  void aliases() {
    for (const auto& [name, all] : *s.aliases) out += fmt::format("alias {} = {}\n", name, fmt::join(all, " "));
  }

  bool refers(const Slot& slot) const {
    if (slot.layer || slot.function == fn::attachment || std::holds_alternative<Procedure>(*slot.set)) return true;
    const auto* id = slot.set ? std::get_if<ObjectId>(&*slot.set) : nullptr;
    return id && *id;
  }

  void objects() {
    const FilesObjects files(s);
    std::vector<std::uint32_t> living;
    for (std::uint32_t i = 0; i < s.objects.size(); ++i)
      if (!s.objects[i].removed && !s.objects[i].derived) living.push_back(i);
    for (std::uint32_t i : living) {
      const Object& o = s.objects[i];
      if (files.makes(i)) continue;
      if (o.environment) {
        out += write_environment(flat_name(o.name), *o.environment);
        continue;
      }
      const bool layer = o.kind == Kind::layer;
      out += (layer ? "layer " : "create ") + flat_name(o.name) + " ";
      const std::string* command = files.command(i);
      out += layer     ? *std::get<Text>(*o.find(fn::mode)->set)
             : command ? *command
                       : std::string(betwixt::name_of(o.kind));
      for (const Slot& slot : o.slots) {
        if (!slot.set || refers(slot) || slot.function == fn::mode) continue;
        const FunctionSpec& spec = spec_of(s, slot.function);
        out += " " + write_setting(spec.name, *slot.set, value(*slot.set, spec, -1));
      }
      out += "\n";
    }
    // A name with a slash may no longer match its parent, and the object above may be gone. Such objects get their
    // final names last.
    for (std::uint32_t i : living)
      if (const auto& name = s.objects[i].name; !files.makes(i) && flat_name(name) != name && !formula_above(s, name))
        out += "rename " + flat_name(name) + " " + name + "\n";
    out += write_lists(s);
    // References to other objects come after all objects.
    for (std::uint32_t i : living)
      for (const Slot& slot : s.objects[i].slots)
        if (slot.set && (refers(slot) || files.makes(i)) && !files.sets(i, slot)) late(i, slot);
    for (std::uint32_t i : living)
      for (const Slot& slot : s.objects[i].slots) {
        Target t{{i}, slot.function};
        t.layer = slot.layer;
        if (const auto old = files.outdated(i, slot))
          out += fmt::format("clear {} {}..{}\n", document.name(t), point(old->first), point(old->second));
        if (!files.tracks(i, slot)) strand(slot, t);
        t.velocity = true;
        strand(slot.velocity, t);
        for (const Filter& f : slot.filters) filter(f, {{i}, slot.function, f.component}, slot.layer);
      }
  }

  std::string on(ObjectId layer) const { return layer ? "on " + name_of(layer) + " " : ""; }

  // Writes a value that refers to a name, which must exist first.
  void late(std::uint32_t i, const Slot& slot) {
    const FunctionSpec& spec = spec_of(s, slot.function);
    if (const auto* a = std::get_if<Attachment>(&*slot.set)) {
      if (a->kind >= AttachmentKind::hang && !find_object(s, a->parent)) return;
      const std::string what = value(*slot.set, spec, -1);       // "couple to hand"
      const auto space = std::min(what.find(' '), what.size());  // no blank if nothing holds it
      out += what.substr(0, space) + " " + s.objects[i].name + what.substr(space) + "\n";
      return;
    }
    if (const auto* id = std::get_if<ObjectId>(&*slot.set); id && *id && !find_object(s, *id)) return;
    out +=
        on(slot.layer) + "set " + document.name(Target{{i}, slot.function}) + " " + value(*slot.set, spec, -1) + "\n";
  }

  void strand(const Strand& of, Target t) {
    track(*of.track, t);
    for (std::size_t k = 0; k < of.components.size(); ++k) {
      t.component = static_cast<int>(k);
      track(*of.components[k], t);
    }
  }

  void filter(const Filter& f, const Target& t, ObjectId layer) {
    out += on(layer) + "filter " + document.name(t) + " " + f.name;
    const FilterSpec* spec = f.code ? nullptr : find_filter(f.name);
    for (const auto& [key, v] : f.parameters) {
      bool time = false, angles = false;
      if (spec)
        for (const FilterParameter& p : spec->parameters) {
          if (p.name != key) continue;
          const Type whole = spec_of(s, t.function).type;
          time = p.time, angles = p.value && row_of(t.component < 0 ? whole : component_type(whole)).angles;
        }
      const auto* d = std::get_if<double>(&v);
      const auto* text = std::get_if<Text>(&v);
      const auto* p = std::get_if<Vec3>(&v);
      out += " " + key + "=";
      if (d) out += time ? write_seconds(from_seconds(*d)) : angles ? write_angle(*d) : write_number(*d);
      if (text) out += write_text(**text);
      if (p) out += angles ? write_angles(*p) : write_vector(*p);
    }
    if (f.segment) out += " " + point(f.segment->first) + ".." + point(f.segment->second);
    out += f.off ? " off\n" : "\n";
  }

  // Returns a name without slashes that no object has.
  std::string flat_name(const std::string& name) const {
    if (name.find('/') == std::string::npos) return name;
    if (const auto* const whole = formula_above(s, name)) return flat_name(*whole) + name.substr(whole->size());
    std::string flat = name;
    std::replace(flat.begin(), flat.end(), '/', '-');
    flat += "-" + std::to_string(s.names.find(name).index);  // keeps "a/b-c" and "a-b/c" distinct
    while (s.names.find(flat) || !versions(s, flat).empty()) flat += "-";
    return flat;
  }

  void rest() {
    for (const auto& [time, camera] : *s.cuts) {
      out += (time == Time{INT64_MIN} ? "" : "at " + point(time) + " ") + "look through " + name_of(camera);
      out += s.cut_ways->count(time) == 0 ? "\n" : " " + write_cut_way(s.cut_ways->at(time), s.rate) + "\n";
    }
    for (const auto& [time, note] : *s.notes)
      out += "at " + point(time) + " note " + write_text(note.text) +
             (note.color ? " color=" + write_color(*note.color) : "") + "\n";
    for (const Dial& d : *s.dials) {
      out += "dial " + d.address + " to " + document.name(d.target);
      if (d.mapped) {
        const FunctionSpec spec = unbounded(spec_of(s, d.target.function));
        out += " from " + write_number(d.low) + " " + write_number(d.high) + " to " +
               value(d.from, spec, d.target.component) + " " + value(d.to, spec, d.target.component);
      }
      out += "\n";
    }
    for (const OwnKind& kind : s.kinds->all) {
      out += fmt::format("define kind {} like {}{}", kind.name, name_of(kind.model()), kind.hidden ? " hidden" : "");
      std::string of;
      for (const Cow<KindInstance>& one : kind.instances)
        if (const std::string name = name_of(one->parts.front()); !name.empty()) of += (of.empty() ? "" : " ") + name;
      out += of.empty() ? "\n" : fmt::format(" of ({})\n", of);
    }
    if (s.recording) out += "record on\n";
    if (s.policy != Policy::ask) out += fmt::format("policy {}\n", policy_names[static_cast<std::size_t>(s.policy)]);
  }
};

}  // namespace

std::string write_rows(const Document& document, const Target& target) {
  Writer w{document.scene(), document, {}};
  w.rows(target);
  return std::move(w.out);
}

std::string write_event(const Document& document, const Target& target, const Event& e) {
  Writer w{document.scene(), document, {}};
  w.row(e, spec_of(document.scene(), target.function), target.component);
  w.out.pop_back();
  return w.out.substr(w.out.find(' ', 2) + 1);
}

std::string write_event(const Document& document, const Target& target, Time time) {
  for (const Track* track : tracks_of(document.scene(), target))
    if (const Event* e = track->events.find(time)) return write_event(document, target, *e);
  return {};
}

std::string write_besides(const Document& document, const Target& target) {
  Writer w{document.scene(), document, {}, true};
  return w.besides(target), std::move(w.out);
}

std::string write(const Document& document) {
  Writer w{document.scene(), document, {}};
  w.settings(), w.objects(), w.aliases(), w.out += write_theme(w.s), w.rest(), w.out += write_cues(w.s);
  return std::move(w.out);
}

}  // namespace betwixt
