// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Contacts (collision detection): which drawn objects touch, which groups they form, and which leave the picture.
// Source: Animation Imaging Model, section 5. There, a separate module detects collisions and reports them to the host.
//
// Room: program
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "betwixt/document.h"
#include "betwixt/frame.h"

namespace betwixt {

// Where a box is in the camera's view: fully outside, across the edge of the picture (a box that touches the edge
// counts), or inside. The view has no far limit: it reaches from the eye (perspective) or the camera's plane
// (orthographic) to infinity. Everything behind that is outside.
enum class Sight : std::uint8_t { out, boundary, in };

// An axis-aligned box in world space around one drawn object. Boxes that only share a face, an edge or a corner touch.
struct ContactBox {
  ObjectId id, body;
  Vec3 low, high;
  Sight sight = Sight::out;
};

struct Contact {
  ObjectId a, b;  // a before b in object order
  Time time;      // the frame's time; from `swept`, the time at which they first touch
};

// More than two objects that are connected by contacts.
struct ContactGroup {
  std::vector<ObjectId> objects;  // in object order
  std::vector<Contact> pairs;     // among them
};

struct ContactOptions {
  bool related = false;               // whether to report pairs within one body too (see Item::body)
  std::optional<double> aspect = {};  // width / height of the picture; nullopt: that of the camera
};

struct Contacts {
  // The most pairs that are kept. If more objects touch, `pairs` has this many and `complete` is false.
  static constexpr std::size_t most_pairs = 500'000;

  Time time;
  std::vector<ContactBox> boxes;     // in object order; an object without extent has no box
  std::vector<Contact> pairs;        // sorted by a, then b
  std::vector<ContactGroup> groups;  // ordered by their first object
  bool complete = true;

  const ContactBox* find(ObjectId) const;          // null if the object is not drawn
  Sight sight(ObjectId) const;                     // Sight::out if the object is not drawn
  std::vector<ObjectId> touching(ObjectId) const;  // the objects that touch this one
  bool touching(ObjectId, ObjectId) const;         // whether these two touch
};

// Returns the contacts at the time of the frame.
Contacts contacts(const Frame&, const ContactOptions& = {});
// Returns every pair that touches at some time from `before` to `after`. Each box moves in a straight line at constant
// speed between its two positions, so fast objects cannot pass through each other unnoticed. An object that only one of
// the frames draws exists only at the time of that frame. Boxes and sights are those of `after`.
Contacts swept(const Frame& before, const Frame& after, const ContactOptions& = {});

// A change from one tick to the next: a contact or a group begins or ends, or the sight of an object changes.
struct ContactEvent {
  enum class What : std::uint8_t { contact, group, view };
  What what = What::contact;
  bool begin = true;              // contact, group
  Sight sight = Sight::out;       // view: the new one
  std::vector<ObjectId> objects;  // contact: two; group: more than two; view: one
  std::vector<Contact> pairs;     // group
  Time time;                      // of the tick
};

// Returns one line of JSON, without a line break:
//   {"event":"contact","state":"begin","a":"ball","b":"wall","tick":90}
//   {"event":"group","state":"end","objects":["a","b","c"],"pairs":[["a","b"],["b","c"]],"tick":90}
//   {"event":"view","object":"ball","state":"boundary","tick":90}
std::string to_json(const ContactEvent&, const Document&);

// Reports contacts while a film plays. At first nothing touches and nothing is in view.
class ContactWatch {
 public:
  explicit ContactWatch(ContactOptions options = {}, bool sweep = false) : options_(options), sweep_(sweep) {}

  // Returns what changed since the last frame. Call it for the next tick of forward play, or for the same tick after
  // the film was edited. A frame that is earlier than the last one is a seek. Contacts come first, then groups, then
  // views; what ended comes before what began. With `sweep`, a contact that exists only between two ticks begins and
  // ends at the later tick.
  std::vector<ContactEvent> step(const Frame&);
  // Jumps to another time. Returns no events; later steps compare with this frame.
  void seek(const Frame&);
  const Contacts& now() const { return now_; }

 private:
  ContactOptions options_;
  bool sweep_ = false, begun_ = false;
  Contacts now_;
};

}  // namespace betwixt
