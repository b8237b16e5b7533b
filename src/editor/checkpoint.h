// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A script that makes a document, in place of all that was said to make it. A thread of its own writes it, loads it
// again to see that it does, and puts it on the disk, so that nobody waits for any of that.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "betwixt/language.h"
#include "editor/history.h"

namespace betwixt {

class Checkpoint {
 public:
  // Begins; `steps`: so many of a history are in the document. `name`: of the script; `path`: of the file that it will
  // stand in, "" for none.
  Checkpoint(Document, std::size_t steps, std::string name, std::string path, const LoadOptions&);

  bool done() const;
  // When it is done. Errors: machine (the script would make another document; it cannot be written), file.
  const Result<std::string>& script() const;
  std::string take_script();
  const std::optional<ScriptBeside>& beside() const;  // none: there is no path
  // Frees what is not needed any more, as that may take long.
  static void free_beside(std::vector<Step>);
  std::size_t steps() const { return steps_; }

 private:
  struct Work;
  std::shared_ptr<Work> work_;  // the thread's, too: whoever asked need not wait for it
  std::size_t steps_;
};

}  // namespace betwixt
