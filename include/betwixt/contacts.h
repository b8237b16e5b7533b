// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Contacts: which of the things drawn touch, in which groups, and what is leaving the picture. (Animation Imaging
// Model, 5: a collision module of its own that tells the host)
//
// Room: program
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "betwixt/document.h"
#include "betwixt/frame.h"

namespace betwixt {

// Where a box is to what the camera sees: fully outside, across the window's boundary (touching it counts), or inside.
// What is seen goes from the eye (in perspective) or from the camera's plane (orthographic) as far as anything is;
// what is behind that is out.
enum class Sight : std::uint8_t { out, boundary, in };

// A box along the axes of the world around one thing drawn; its faces belong to it.
struct ContactBox {
  ObjectId id, body;
  Vec3 low, high;
  Sight sight = Sight::out;
};

struct Contact {
  ObjectId a, b;  // a before b in object order
  Time time;      // of the frame; of a swept test, when they first touch
};

// More than two things that are connected by touching.
struct ContactGroup {
  std::vector<ObjectId> objects;  // in object order
  std::vector<Contact> pairs;     // among them
};

struct ContactOptions {
  bool related = false;               // pairs of one body too (see Item::body)
  std::optional<double> aspect = {};  // width by height of the picture; none: as the camera has it
};

struct Contacts {
  // Where so much touches that the pairs do not fit, there are this many of them, and they are not `complete`.
  static constexpr std::size_t most_pairs = 500'000;

  Time time;
  std::vector<ContactBox> boxes;     // in object order; what has no extent has no box
  std::vector<Contact> pairs;        // sorted by a, then b
  std::vector<ContactGroup> groups;  // by their first object
  bool complete = true;

  const ContactBox* find(ObjectId) const;  // null: it is not drawn
  Sight sight(ObjectId) const;             // of what is not drawn: out
  std::vector<ObjectId> touching(ObjectId) const;
  bool touching(ObjectId, ObjectId) const;
};

// At the time of the frame.
Contacts contacts(const Frame&, const ContactOptions& = {});
// Whatever touches at some time from the one frame to the other while each box goes straight, and evenly, from where it
// was to where it is: what is fast does not slip through. What is drawn in one of them only is there at its time only.
// Boxes and sights are those of `after`.
Contacts swept(const Frame& before, const Frame& after, const ContactOptions& = {});

// What began or ended from one tick to the next.
struct ContactEvent {
  enum class What : std::uint8_t { contact, group, view };
  What what = What::contact;
  bool begin = true;              // contact, group
  Sight sight = Sight::out;       // view
  std::vector<ObjectId> objects;  // two, more than two, one
  std::vector<Contact> pairs;     // group
  Time time;                      // of the tick
};

// One line of JSON, without its end:
//   {"event":"contact","state":"begin","a":"ball","b":"wall","tick":90}
//   {"event":"group","state":"end","objects":["a","b","c"],"pairs":[["a","b"],["b","c"]],"tick":90}
//   {"event":"view","object":"ball","state":"boundary","tick":90}
std::string to_json(const ContactEvent&, const Document&);

// Looks on while a film plays. It begins with nothing touching and nothing in view.
class ContactWatch {
 public:
  explicit ContactWatch(ContactOptions options = {}, bool sweep = false) : options_(options), sweep_(sweep) {}

  // The next tick in forward play, or the same one after the film was changed. A frame from before the last one is a
  // seek. Ends come first, then begins: contacts, groups, views.
  // With `sweep`, what touches between two ticks only begins and ends at the later one.
  std::vector<ContactEvent> step(const Frame&);
  // To any other time: no events, but what holds there is known.
  void seek(const Frame&);
  const Contacts& now() const { return now_; }

 private:
  ContactOptions options_;
  bool sweep_ = false, begun_ = false;
  Contacts now_;
};

}  // namespace betwixt
