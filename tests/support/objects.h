// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A short function that makes objects.
#pragma once

#include <string>
#include <utility>

#include "scene/document.h"
#include "support/events.h"

namespace betwixt {

// Adds an object, coupled to its parent if it has one.
inline ObjectId add(Scene& s, const std::string& name, Kind kind = Kind::sphere, ObjectId parent = {}) {
  Object o;
  o.name = name;
  o.kind = kind;
  if (parent) o.slot(fn::attachment).set = Attachment{AttachmentKind::couple, parent, false};
  return add_object(s, std::move(o));
}

}  // namespace betwixt
