// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/key_types.h"

#include <QCoreApplication>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <map>

#include "scene/document.h"
#include "studio/shell/text_of.h"
#include "studio/viewport/hand.h"
#include "track/curve.h"
#include "track/twerpers.h"
#include "track/types.h"

namespace betwixt::studio {
namespace {

// The two handles of a segment, as numbers beside its events, and their lengths in time.
struct SegmentHandles {
  double out[4] = {}, in[4] = {};
  Time out_length, in_length;
};

// Gives handles to segments of one track.
class HandleWriter {
 public:
  HandleWriter(const Document& d, const Target& t) : d_(d), t_(t), fcurve_(*find_twerper("fcurve")) {
    const auto tracks = tracks_of(d.scene(), t);
    const Type whole = spec_of(d.scene(), t.function).type;
    const Type of = t.velocity ? row_of(whole).rate.value_or(Type::text) : whole;
    type_ = t.component < 0 ? of : component_track_type(of);
    if (tracks.size() != 1 || tracks[0]->events.empty() || !row_of(type_).tangents) return;
    track_ = tracks[0];
    bool plain = track_->global == Twerper::unset;
    track_->events.each([&](const Event& e) {
      plain = plain && !e.release && (e.keep || (numeric(e.value) && !std::holds_alternative<Quat>(e.value)));
    });
    if (!plain) track_ = nullptr;
    if (!track_) return;
    for (const NamedProcedure& p : *d.scene().procedures) set_.own.push_back(p.code);
    curve_ = set_.add(*track_, type_, t.component >= 0);
  }

  // Gives handles to both sides of an event, where its segments can have them.
  void free(Time at) {
    if (!track_) return;
    const Event* here = track_->events.find(at);
    if (!here) return;
    if (const Event* before = track_->events.last_before(at)) segment(*before, *here);
    if (const Event* after = track_->events.first_from(at + Time{1})) segment(*here, *after);
  }
  // Turns both handles of an event into one line, whose slope is the mean of theirs.
  void align(Time at) {
    const auto e = changed_.find(at);
    if (e == changed_.end() || !e->second.detail->tangent_in || !e->second.detail->tangent_out ||
        e->second.detail->before)
      return;
    EventDetail& detail = e->second.detail.edit();
    double in[4] = {}, out[4] = {};
    const int count = to_numbers(*detail.tangent_out, out);
    to_numbers(*detail.tangent_in, in);
    const double before = detail.handle_in->seconds(), after = detail.handle_out->seconds();
    for (int i = 0; i < count; ++i) {
      const double slope = (out[i] - in[i]) / (before + after);
      out[i] = plain(slope * after), in[i] = plain(-slope * before);
    }
    detail.tangent_out = with_numbers(e->second.value, out, count);
    detail.tangent_in = with_numbers(e->second.value, in, count);
  }

  Lines lines() const {
    Lines all;
    for (const auto& [time, e] : changed_)
      if (const Event* was = track_->events.find(time); was && !(*was == e)) all.push_back(event_line(d_, t_, e));
    return all;
  }

 private:
  static double plain(double v) { return rounded(v, std::max(1e-9, 1e-9 * std::abs(v))); }
  static bool near(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b)); }
  Event& changed(const Event& e) { return changed_.try_emplace(e.time, e).first->second; }

  void segment(const Event& a, const Event& b) {
    if (a.keep || b.keep || a.release || b.release || a.twerper == Twerper::hold) return;
    double from[4] = {}, to[4] = {};
    const int count = to_numbers(a.value, from);
    to_numbers(b.detail->before ? *b.detail->before : b.value, to);
    const Time length = b.time - a.time;
    SegmentHandles h;
    if (a.twerper == fcurve_) {
      // It has handles; those that it does not give become visible.
      h = written(a, b, length);
    } else if (a.twerper == Twerper::bezier) {
      h = of_bezier(a, from, to, count, length);
    } else {
      CubicSegment cubic;
      if (!set_.cubic(curve_, a.time.flicks, cubic) || cubic.ease) return;
      for (int i = 0; i < count; ++i) {
        const auto c = static_cast<std::size_t>(i);
        const double end = cubic.c[0][c] + cubic.c[1][c] + cubic.c[2][c] + cubic.c[3][c];
        if (!near(cubic.c[0][c], from[i]) || !near(end, to[i])) return;  // it passes beside the events
        h.out[i] = cubic.c[1][c] / 3;
        // The last handle begins at the segment's end: c0 + c1 + c2 + c3.
        h.in[i] = -(cubic.c[1][c] / 3 + 2 * cubic.c[2][c] / 3 + cubic.c[3][c]);
      }
      h.out_length = h.in_length = Time{length.flicks / 3};
    }
    Event &one = changed(a), &two = changed(b);
    for (int i = 0; i < count; ++i) h.out[i] = plain(h.out[i]), h.in[i] = plain(h.in[i]);
    one.twerper = fcurve_;
    EventDetail& out = one.detail.edit();
    out.tangent_out = with_numbers(a.value, h.out, count), out.handle_out = h.out_length;
    EventDetail& in = two.detail.edit();
    in.tangent_in = with_numbers(b.value, h.in, count), in.handle_in = h.in_length;
  }

  static SegmentHandles written(const Event& a, const Event& b, Time length) {
    SegmentHandles h;
    const Time third{length.flicks / 3};
    h.out_length = a.detail->handle_out.value_or(third), h.in_length = b.detail->handle_in.value_or(third);
    if (a.detail->tangent_out) to_numbers(*a.detail->tangent_out, h.out);
    if (b.detail->tangent_in) to_numbers(*b.detail->tangent_in, h.in);
    return h;
  }
  static SegmentHandles of_bezier(const Event& a, const double* from, const double* to, int count, Time length) {
    const auto& xy = a.detail->arguments;
    const auto part = [&](double x) {
      return Time{std::max<std::int64_t>(1, std::llround(x * static_cast<double>(length.flicks)))};
    };
    SegmentHandles h;
    for (int i = 0; i < count; ++i) h.out[i] = xy[1] * (to[i] - from[i]), h.in[i] = (xy[3] - 1) * (to[i] - from[i]);
    h.out_length = part(xy[0]), h.in_length = part(1 - xy[2]);
    return h;
  }

  const Document& d_;
  const Target t_;
  const Twerper fcurve_;
  Type type_ = Type::scalar;
  const Track* track_ = nullptr;
  CurveSet set_;
  Curve curve_;
  std::map<Time, Event> changed_;
};

}  // namespace

std::span<const KeyTypeRow> key_types() {
  static constexpr KeyTypeRow rows[] = {
      {KeyType::automatic, QT_TRANSLATE_NOOP("betwixt::studio::KeyTypes", "Auto"),
       QT_TRANSLATE_NOOP("betwixt::studio::KeyTypes", "smooth, and never beyond its events: auto")},
      {KeyType::smooth, QT_TRANSLATE_NOOP("betwixt::studio::KeyTypes", "Smooth"),
       QT_TRANSLATE_NOOP("betwixt::studio::KeyTypes", "smooth, and may swing beyond its events: smooth")},
      {KeyType::vector, QT_TRANSLATE_NOOP("betwixt::studio::KeyTypes", "Vector"),
       QT_TRANSLATE_NOOP("betwixt::studio::KeyTypes", "straight to the next event: linear")},
      {KeyType::aligned, QT_TRANSLATE_NOOP("betwixt::studio::KeyTypes", "Aligned handles"),
       QT_TRANSLATE_NOOP("betwixt::studio::KeyTypes", "two handles that make one line: fcurve")},
      {KeyType::free, QT_TRANSLATE_NOOP("betwixt::studio::KeyTypes", "Free handles"),
       QT_TRANSLATE_NOOP("betwixt::studio::KeyTypes", "two handles, and the curve keeps its shape: fcurve")},
      {KeyType::hold, QT_TRANSLATE_NOOP("betwixt::studio::KeyTypes", "Hold"),
       QT_TRANSLATE_NOOP("betwixt::studio::KeyTypes", "keeps its value until the next event: hold")},
  };
  return rows;
}

Lines key_type_lines(const Document& d, const std::vector<EventAt>& events, KeyType type) {
  switch (type) {
    case KeyType::automatic:
      return twerper_lines(d, events, "auto");
    case KeyType::smooth:
      return twerper_lines(d, events, "smooth");
    case KeyType::vector:
      return twerper_lines(d, events, "linear");
    case KeyType::hold:
      return twerper_lines(d, events, "hold");
    case KeyType::aligned:
    case KeyType::free:
      break;
  }
  Lines lines;
  for (const Picked& p : by_track(events)) {
    HandleWriter writer(d, p.target);
    for (const Time t : p.times) writer.free(t);
    if (type == KeyType::aligned)
      for (const Time t : p.times) writer.align(t);
    for (std::string& line : writer.lines()) lines.push_back(std::move(line));
  }
  return lines;
}

void fill_key_types(QMenu& menu, Workspace& workspace) {
  menu.setToolTipsVisible(true);
  const auto translated = [](const char* words) {
    return QCoreApplication::translate("betwixt::studio::KeyTypes", words);
  };
  for (const KeyTypeRow& row : key_types()) {
    QAction* a = menu.addAction(translated(row.name));
    a->setToolTip(translated(row.sentence));
    QObject::connect(a, &QAction::triggered, &workspace, [&workspace, translated, type = row.type] {
      const Lines lines = key_type_lines(workspace.document(), workspace.events_selected(), type);
      if (lines.empty())
        emit workspace.said({}, translated("no selected event can change so\n"), false);
      else
        workspace.say(lines);
    });
  }
}

}  // namespace betwixt::studio
