// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Values in text: reads them by type, and writes them so that they read back the same.
#pragma once

#include <functional>

#include "language/cursor.h"
#include "language/formula.h"
#include "scene/document.h"
#include "syntax/texts.h"

namespace betwixt {

// Returns the same function without limits, because shifts and speeds may have any size.
inline FunctionSpec unbounded(FunctionSpec spec) {
  spec.low = -1e300, spec.high = 1e300;
  return spec;
}

struct ValueReader {
  Cursor& c;
  const Scene& scene;
  // Reads the file that a value names, and sets the path to keep. nullptr: files are not read.
  std::function<bool(FunctionId, std::string& path, std::string_view about)> file;
  std::function<void(std::string message, std::string_view about, std::string hint)> warn;
  // Receives the text of a value that the policy has translated from an invalid one. May be nullptr.
  std::function<void(std::string_view place, std::string instead)> translated;

  // Reads a value for a function, or for one component of it.
  bool value(const FunctionSpec& spec, int component, Value& out, FunctionId f = 0xffff);
  bool color(Color& out);
  // `open`: the third number may be left out; it is then 0.
  bool vector(int numbers, Vec3& out, Unit unit = Unit::none, bool open = false);
  bool scalar(double& out, Unit unit = Unit::none);
  bool angle(double& radians);
  bool in_unit(const Quantity&, Unit, double& out, std::string_view about);
  bool is_vector();
  // Takes the next word if it is a name of this type, and returns its value; otherwise returns nullopt.
  template <class T>
  std::optional<T> let() {
    Cursor ahead = c;
    const auto item = let_here(ahead);
    if (ahead.error && !c.error) c.error = ahead.error, c.where = ahead.where;
    const T* value = item ? std::get_if<T>(&*item) : nullptr;
    if (!value) return std::nullopt;
    c.at = ahead.at;
    return *value;
  }
  bool meant_as_number(const char* start, double& out);
  bool looks_like_number() const;
  bool translates() const { return scene.policy == Policy::translate; }
  void translate(const char* start, std::string instead) {
    if (translated) translated(c.since(start), std::move(instead));
  }
  bool orientation(Value& out, bool angles);
  bool rotation_of(const Mat4&, std::string_view about, Value& out);
  bool points(Points& out);
  // Reads one ring of points, or a list of rings, each of which then ends with its first point again (see rings()).
  bool holes(Points& out);
  bool point(Vec3& out);       // (x y) or (x y z)
  bool object(ObjectId& out);  // an existing name
  bool axis(Vec3& out);        // x, y, z or (x y z)
  // Reads translate(x y z), rotate(90deg, z) [@ (x y z)], scale(x y z) [@ (x y z)], matrix(16 numbers), or several
  // in succession: the leftmost is applied last. With `noticed`, a single matrix(…) that is a rigid motion except for
  // rounding is read as an exact one; if that changed it, `noticed` is its word.
  bool transform(Mat4& out, std::string_view* noticed = nullptr);
  bool motion(Moves& out);  // T(…) R(…) S(…); "" for none
  // Reads one name or a list of names, which need not exist yet: (spin drift).
  bool names(Names& out);
};

// The reverse. `name_of` returns the names of objects.
std::string write_parts_and_tables(const Scene&);  // the commands `part` and `data`
std::string write_number(double v);                // shortest form that reads back to the same double
std::string write_seconds(Time);                   // a time that reads back to the same flick
std::string write_time(Time, Rate);                // the same, in frames if it is on a frame
std::string write_cut_way(const CutWay&, Rate);    // what follows the camera: for 12f wipe=left
// Write lines of a script. write_cues(): all sections, steps and descriptions.
std::string write_pause(const Pause&, Rate);
std::string write_description(const Description&, Rate);
std::string write_cues(const Scene&);
std::string write_color(Color);
std::string write_vector(Vec3, int numbers = 3);
std::string write_angles(Vec3 radians);
std::string write_angle(double radians);     // in degrees if that reads back to the same value, otherwise in radians
std::string write_matrix(const Mat4&);       // row by row
std::string write_appearance(const Scene&);  // commands
std::string write_theme(const Scene&);       // commands; they stand behind all objects, which have their colors
std::string write_rows(const DisplayList&);  // indented lines
std::string write_lists(const Scene&);       // the display lists at the beginning, then their later versions
std::string write_environment(const std::string& name, const Environment&);  // all commands about it, a line each
// write_rows(): the target's rows; for a component, its part of the rows of the whole. write_besides(): everything else
// that determines its value, one command or sheet each: `set`, twerper, extend, velocity, filters, layers.
std::string write_rows(const Document&, const Target&);
std::string write_besides(const Document&, const Target&);
// Returns the part of an event's row after its time, or "" if there is no event. The track must not be a motion's.
std::string write_event(const Document&, const Target&, Time);
std::string write_event(const Document&, const Target&, const Event&);  // for an event that need not exist
std::string write_value(const Value&, const FunctionSpec& spec, int component,
                        const std::function<std::string(ObjectId)>& name_of);

}  // namespace betwixt
