// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The kinds that a script defines (`define kind human2 like man`), and the objects of these kinds. An instance is an
// object of such a kind, with everything below it. It follows later changes of the model, except in its own values.
//
// Room: commands
#pragma once

#include <string>
#include <vector>

#include "betwixt/document.h"

namespace betwixt {

struct InstanceView {
  ObjectId root;
  std::vector<Target> own;           // what no longer follows the model; whole display functions
  std::vector<std::string> missing;  // the parts that it lacks, as in "/hat"
};
struct KindView {
  std::string name;
  ObjectId model;
  bool hidden = false;                  // the model is not shown
  std::vector<InstanceView> instances;  // in order of creation
};
// Returns all kinds that the script defines, in the order of their definition.
std::vector<KindView> own_kinds(const Document&);

}  // namespace betwixt
