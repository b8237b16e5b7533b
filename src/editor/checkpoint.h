// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A checkpoint: a short script that makes the same document as the whole history. A background thread writes the
// script, loads it again to check the result, and puts it on the disk with a journal of all later steps, so that no
// caller waits.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "betwixt/language.h"
#include "editor/next_history.h"

namespace betwixt {

class Checkpoint {
 public:
  // Starts the thread. `steps`: the number of history steps that are in the document. `name`: of the script. `path`: of
  // the file that the script will replace, or "" if there is no file. `step`: see CheckpointStep.
  Checkpoint(Document, std::size_t steps, std::string name, std::string path, const LoadOptions&,
             CheckpointStep step = {});
  ~Checkpoint();  // does not wait for the thread
  Checkpoint(const Checkpoint&) = delete;
  Checkpoint& operator=(const Checkpoint&) = delete;

  bool done() const;
  // Returns the script; valid once done() returns true. Errors: machine (the script would make another document, or it
  // cannot be written), file.
  const Result<std::string>& script() const;
  std::string take_script();
  std::optional<NextHistory> take_next();  // nullopt if there is no path
  std::size_t steps() const { return steps_; }

 private:
  struct Work;
  std::shared_ptr<Work> work_;  // shared with the thread, so that the destructor need not wait for it
  std::size_t steps_;
};

}  // namespace betwixt
