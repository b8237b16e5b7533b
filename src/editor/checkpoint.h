// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A checkpoint: a short script that makes the same document as the whole history. A background thread writes the
// script, loads it again to check the result, and puts it on the disk, so that no caller waits.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "betwixt/language.h"
#include "editor/history.h"

namespace betwixt {

class Checkpoint {
 public:
  // Starts the thread. `steps`: the number of history steps that are in the document. `name`: of the script. `path`: of
  // the file that the script will replace, or "" if there is no file.
  Checkpoint(Document, std::size_t steps, std::string name, std::string path, const LoadOptions&);

  bool done() const;
  // Returns the script; valid once done() returns true. Errors: machine (the script would make another document, or it
  // cannot be written), file.
  const Result<std::string>& script() const;
  std::string take_script();
  const std::optional<ScriptBeside>& beside() const;  // nullopt if there is no path
  // Frees steps on another thread, because that may take long.
  static void free_beside(std::vector<Step>);
  std::size_t steps() const { return steps_; }

 private:
  struct Work;
  std::shared_ptr<Work> work_;  // shared with the thread, so that the destructor need not wait for it
  std::size_t steps_;
};

}  // namespace betwixt
