// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A script that makes a document, in place of all that was said to make it. A thread of its own writes it, and loads it
// again to see that it does.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "betwixt/language.h"

namespace betwixt {

class Checkpoint {
 public:
  // Begins; `steps`: so many of a history are in the document. `name`: of the file that it will stand in.
  Checkpoint(Document, std::size_t steps, std::string name, const LoadOptions&);

  bool done() const;
  // When it is done: none where the script would make another document.
  const std::optional<std::string>& script() const;
  std::size_t steps() const { return steps_; }

 private:
  struct Work;
  std::shared_ptr<Work> work_;  // the thread's, too: whoever asked need not wait for it
  std::size_t steps_;
};

}  // namespace betwixt
