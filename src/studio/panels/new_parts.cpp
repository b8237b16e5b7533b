// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/new_parts.h"

#include <fmt/format.h>

#include <QCoreApplication>
#include <QMenu>
#include <algorithm>
#include <cmath>

#include "betwixt/language.h"
#include "betwixt/object.h"
#include "editor/made_by.h"
#include "editor/plain_values.h"
#include "language/values.h"
#include "scene/document.h"
#include "studio/objects/object_lines.h"
#include "studio/shell/text_of.h"
#include "syntax/texts.h"
#include "track/filter.h"
#include "track/types.h"

namespace betwixt::studio {
namespace {

constexpr double tau = 2 * pi;

// Rounds to one significant digit.
double plain_size(double v) {
  if (!(v > 0)) return 0;
  const double power = std::pow(10, std::floor(std::log10(v)));
  return std::round(v / power) * power;
}

// The lowest and the highest number of each component over the film.
struct Reach {
  std::vector<double> low, high;
  // A tenth of the widest; `unit` if nothing moves.
  double tenth(double unit) const {
    double widest = 0;
    for (std::size_t i = 0; i < low.size(); ++i) widest = std::max(widest, high[i] - low[i]);
    return widest > 1e-9 ? plain_size(widest / 10) : unit;
  }
};
Reach reach_of(const Document& d, const Program& program, const Target& t) {
  constexpr int times = 48;
  Reach all;
  const auto [first, last] = d.range();
  for (int i = 0; i <= times; ++i) {
    const Time at = first + Time{(last - first).flicks / times * i};
    double n[4];
    const int count = to_numbers(program.read(t, at), n);
    for (int k = 0; k < count; ++k) {
      if (all.low.size() <= static_cast<std::size_t>(k)) all.low.push_back(n[k]), all.high.push_back(n[k]);
      const auto c = static_cast<std::size_t>(k);
      all.low[c] = std::min(all.low[c], n[k]), all.high[c] = std::max(all.high[c], n[k]);
    }
  }
  return all;
}

class NewParts {
 public:
  NewParts(const Document& d, const Program& program, const std::vector<Target>& targets, Time at)
      : d_(d), program_(program), targets_(targets), at_(at), type_(spec_of(d.scene(), targets.back().function).type) {}

  std::vector<NewPart> all() {
    if (spec_of(d_.scene(), targets_.back().function).by_script) return {};
    filters(), layers(), velocity(), code(), movement();
    std::erase_if(all_, [](const NewPart& p) { return p.lines.empty(); });
    return std::move(all_);
  }

 private:
  template <class F>
  void add(const char* menu, std::string name, std::string_view sentence, F&& line) {
    NewPart part{menu, std::move(name), std::string(sentence), {}};
    for (const Target& t : targets_)
      if (std::string l = line(t); !l.empty()) part.lines.push_back(std::move(l));
    all_.push_back(std::move(part));
  }

  void filters() {
    for (const FilterSpec& spec : built_in_filters()) {
      if (!suits(spec, type_) || (!spec.orientations && turns())) continue;
      add(QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Filter"), std::string(spec.name), spec.sentence,
          [&](const Target& t) { return "filter " + d_.name(t) + " " + std::string(spec.name) + settings(spec, t); });
    }
    if (!row_of(type_).computed) return;
    for (const ProcedureView& p : procedures(d_))
      if (p.role == "filter")
        add(QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Filter"), std::string(p.name), p.source,
            [&](const Target& t) { return "filter " + d_.name(t) + " " + std::string(p.name); });
  }
  bool turns() const { return std::holds_alternative<Quat>(program_.read(targets_.back(), at_)); }

  // Returns " key=value …" with numbers that fit the values of the target.
  std::string settings(const FilterSpec& spec, const Target& t) const {
    const bool angles = row_of(type_).angles;
    const auto number = [&](double v) { return angles ? write_angle(v) : write_number(v); };
    const Reach reach = reach_of(d_, program_, t);
    const double size = reach.tenth(angles ? tau / 72 : 0.1);
    std::string all;
    for (const FilterParameter& p : spec.parameters) {
      std::string value;
      if (p.time) {
        value = write_seconds(from_seconds(p.rest));
      } else if (p.name == "low" || p.name == "high") {
        if (reach.low.empty()) continue;
        value = number(p.name == "low" ? *std::ranges::min_element(reach.low) : *std::ranges::max_element(reach.high));
      } else if (p.value) {
        const std::string one = number(std::max(size, p.low));
        const bool each = p.type == Type::vector && (type_ == Type::vector || type_ == Type::rotation) && !turns();
        value = each ? fmt::format("({0} {0} {0})", one) : one;
      } else if (p.rest != 0) {
        value = write_number(p.rest);
      }
      if (!value.empty()) all += fmt::format(" {}={}", p.name, value);
    }
    return all;
  }

  // Returns an event of a layer: with `add` a value that adds nothing, otherwise the present value.
  std::string on_layer(const std::string& layer, bool adds, const Target& t) const {
    const std::string name = d_.name(t), when = format_time(at_, d_);
    const Value now = program_.read(t, at_);
    std::string value = plain_value(now, t, d_);
    if (adds) {
      double none[4] = {1, 0, 0, 0};
      if (std::holds_alternative<Quat>(now))
        value = "quat(1 0 0 0)";
      else
        none[0] = 0, value = plain_value(with_numbers(now, none), t, d_);
    }
    return fmt::format("on {} at {} {} {}", layer, when, name, value);
  }

  void layers() {
    if (type_ == Type::attachment || type_ == Type::motion || type_ == Type::shape) return;
    const bool sums = has_velocity(type_) && spec_of(d_.scene(), targets_.back().function).low <= 0;
    for (const LayerView& l : betwixt::layers(d_)) {
      if (l.mode == "add" && !sums) continue;
      const std::string name = d_.name(l.id);
      add(QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Layer"), name,
          QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Adds an event on this layer."), [&](Target t) {
            const Object* o = find_object(d_.scene(), t.object);
            return o && o->find(t.function, l.id) ? std::string() : on_layer(name, l.mode == "add", t);
          });
    }
    const std::string name = free_name(d_, "layer1");
    for (const bool adds : {true, false}) {
      if (adds && !sums) continue;
      add(QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Layer"),
          adds ? QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "new layer that adds")
               : QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "new layer that mixes"),
          adds ? QT_TRANSLATE_NOOP("betwixt::studio::NewPart",
                                   "Its values, times its weight, are added to the motion below.")
               : QT_TRANSLATE_NOOP("betwixt::studio::NewPart",
                                   "Its values replace the motion below, in proportion to its weight."),
          [&](const Target& t) { return on_layer(name, adds, t); });
      all_.back().lines.insert(all_.back().lines.begin(), fmt::format("layer {} {}", name, adds ? "add" : "mix"));
    }
  }

  void velocity() {
    if (!has_velocity(type_)) return;
    add("", QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Velocity"),
        QT_TRANSLATE_NOOP("betwixt::studio::NewPart",
                          "From the playhead on, the value moves at a speed, in units a second."),
        [&](Target t) {
          t.velocity = true;
          const Value now = program_.read(t, at_);
          double n[4];
          const int count = to_numbers(now, n);
          const bool rests = std::all_of(n, n + count, [](double x) { return std::abs(x) < 1e-9; });
          const auto* spin = row_of(type_).angles ? std::get_if<Vec3>(&now) : nullptr;
          const std::string value =
              rests  ? std::string(first_speed())
              : spin ? fmt::format("spin({} {} {})", write_angle(spin->x), write_angle(spin->y), write_angle(spin->z))
                     : plain_value(now, t, d_);
          return fmt::format("at {} {} {}", format_time(at_, d_), d_.name(t), value);
        });
  }
  // The speed of a value that rests.
  std::string_view first_speed() const {
    switch (type_) {
      case Type::pair:
        return "(1 0)";
      case Type::vector:
        return "(1 0 0)";
      case Type::angle:
        return "90deg";
      case Type::rotation:
        return "euler(0 90deg 0)";
      case Type::orientation:
        return "spin(0 90deg 0)";
      case Type::color:
        return "(0.1 0 0)";
      default:
        const Unit unit = spec_of(d_.scene(), targets_.back().function).unit;
        return unit == Unit::opening || unit == Unit::seconds || unit == Unit::moment ? "1s" : "1";
    }
  }

  void code() {
    if (!row_of(type_).computed) return;
    const auto line = [&](const Target& t, const std::string& source) {
      const bool events = made_by(d_, t, at_).events;
      return fmt::format("{} {} = {}", events ? "at " + format_time(at_, d_) : "set", d_.name(t), write_text(source));
    };
    add(QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Code"),
        QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "a formula"),
        QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Computes the value at each time t, in seconds."),
        [&](const Target& t) {
          const std::string source = formula(program_.read(t, at_));
          return source.empty() ? source : line(t, source);
        });
    for (const ProcedureView& p : procedures(d_))
      if (p.role == "value" || p.role == "steps")
        add(QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Code"), std::string(p.name) + "()", p.source,
            [&](const Target& t) { return line(t, std::string(p.name) + "()"); });
    if (targets_.size() < 2) return;
    const std::string leads = d_.name(targets_.back());
    add(QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Code"), "the same as " + leads,
        QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Takes the value of the other object at each time."),
        [&](const Target& t) { return t == targets_.back() ? std::string() : line(t, "value('" + leads + "')"); });
  }
  // Returns code that swings about a value.
  static std::string formula(const Value& now) {
    const auto number = [](double v) { return write_number(std::abs(v) < 1e-9 ? 0 : std::round(v * 1e6) / 1e6); };
    const auto swings = [&](double v) {
      return fmt::format("{} + {} * sin(t * tau)", number(v), number(std::max(plain_size(std::abs(v) / 10), 0.1)));
    };
    if (const auto* v = std::get_if<double>(&now)) return swings(*v);
    if (const auto* v = std::get_if<Vec3>(&now))
      return fmt::format("vec({}, {}, {})", number(v->x), swings(v->y), number(v->z));
    if (const auto* a = std::get_if<Angles>(&now))
      return fmt::format("euler({}, {}, {})", number(a->xyz.x), swings(a->xyz.y), number(a->xyz.z));
    if (const auto* c = std::get_if<Color>(&now))
      return fmt::format("mix(rgb({}, {}, {}), rgb(1, 1, 1), 0.5 + 0.5 * sin(t * tau))", number(c->r), number(c->g),
                         number(c->b));
    if (std::holds_alternative<bool>(now)) return "t % 1 < 0.5";
    return {};
  }

  // Motions and environments move the whole object.
  void movement() {
    const Target& leads = targets_.back();
    if (leads.function != fn::position && leads.function != fn::rotation) return;
    const bool turns = leads.function == fn::rotation;
    const Time until = at_ + d_.rate().span(24);
    add("", QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Motion"),
        QT_TRANSLATE_NOOP("betwixt::studio::NewPart",
                          "An exact movement over a second from the playhead on. Whole turns count."),
        [&](const Target& t) {
          const std::string name = d_.name(t.object);
          return fmt::format("at {}..{} {}.motion {}", format_time(at_, d_), format_time(until, d_), name,
                             turns ? "R(1turn @ " + name + " axis y)" : "T(2 0 0)");
        });
    const std::string spin = free_name(d_, turns ? "spin" : "drift");
    add("", QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "Environment"),
        QT_TRANSLATE_NOOP("betwixt::studio::NewPart", "A transform that is applied again and again, without end."),
        [&](const Target& t) {
          Names all;
          const Value now = program_.read(Target(t.object, environments()), at_);
          if (const auto* names = std::get_if<Names>(&now)) all = *names;
          std::string list;
          for (const std::string& n : *all) list += n + " ";
          return fmt::format("set {}.{} ({}{})", d_.name(t.object), "environments", list, spin);
        });
    all_.back().lines.insert(all_.back().lines.begin(), fmt::format("animate {} every 2t by {}", spin,
                                                                    turns ? "rotate(4deg, y)" : "translate(0.05 0 0)"));
  }
  FunctionId environments() const { return *find_built_in(Kind::group, "environments"); }

  const Document& d_;
  const Program& program_;
  const std::vector<Target>& targets_;
  const Time at_;
  const Type type_;
  std::vector<NewPart> all_;
};

}  // namespace

std::vector<NewPart> new_parts(const Document& d, const Program& program, const std::vector<Target>& targets, Time at) {
  return targets.empty() ? std::vector<NewPart>() : NewParts(d, program, targets, at).all();
}

void fill_new_parts(QMenu& menu, Workspace& workspace, const std::vector<NewPart>& parts) {
  menu.setToolTipsVisible(true);
  // Names of filters and layers stay as they are.
  const auto translated = [](const std::string& words) {
    return QCoreApplication::translate("betwixt::studio::NewPart", words.c_str());
  };
  for (const NewPart& part : parts) {
    QMenu* into = &menu;
    if (!part.menu.empty()) {
      const QString id = text_of(part.menu);
      into = menu.findChild<QMenu*>(id, Qt::FindDirectChildrenOnly);
      if (!into) into = menu.addMenu(translated(part.menu)), into->setObjectName(id), into->setToolTipsVisible(true);
    }
    QAction* a = into->addAction(translated(part.name));
    QString lines;
    for (const std::string& line : part.lines) lines += "\n" + text_of(line);
    a->setToolTip(tip_of(translated(part.sentence) + lines));
    QObject::connect(a, &QAction::triggered, &workspace, [&workspace, lines = part.lines] { workspace.say(lines); });
  }
}

}  // namespace betwixt::studio
