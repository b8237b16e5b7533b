// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures of the film's frames that were made and are kept in memory, so that a film plays at its rate even if its
// pictures take long.
#pragma once

#include <map>

#include "studio/shell/workspace.h"
#include "studio/viewport/picture_maker.h"

namespace betwixt::studio {

class KeptPictures {
 public:
  static constexpr std::size_t most_bytes = std::size_t{512} << 20;

  // What the pictures have in common. Forgets all pictures of something else, and returns whether there were any.
  struct Of {
    Program program;
    RenderOptions options;
    std::optional<Camera> eye;
    ObjectId through;
    std::shared_ptr<const Marks> left_out;
    friend bool operator==(const Of& a, const Of& b) {
      return &a.program.compiled() == &b.program.compiled() && a.options == b.options && a.eye == b.eye &&
             a.through == b.through && a.left_out == b.left_out;
    }
  };
  bool use(Of);

  const PictureMade* at(Time) const;  // null: not kept
  // Returns false if the memory is full. A draft never replaces a whole picture.
  bool keep(const PictureMade&);
  std::vector<KeptAt> list() const;
  bool empty() const { return pictures_.empty(); }

 private:
  std::optional<Of> of_;
  std::map<Time, PictureMade> pictures_;
  std::size_t bytes_ = 0;
};

}  // namespace betwixt::studio
