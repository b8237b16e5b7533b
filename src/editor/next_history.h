// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The files that replace a script and its journal at a checkpoint: written beside the old ones, then put in place.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

#include "betwixt/result.h"
#include "editor/journal.h"

namespace betwixt {

// A new script on the disk that has not replaced the old one yet.
struct PendingScript {
  std::string part, place;
  Fingerprint print;
  // The old script when the new one was written, and the identity of its file as the system gives it.
  std::optional<Fingerprint> seen;
  std::string seen_file;
};
Result<PendingScript> write_beside(const std::string& path, std::string_view script);
void drop_beside(const std::string& path);  // removes what an interrupted one has left

// Called after each step of a checkpoint, with the name of the step, by the thread that took it. A test can look at the
// files then, as if the process had been killed at that moment.
using CheckpointStep = std::function<void(const char* step)>;

// What replaces script and journal at a checkpoint: on the disk already, under other names.
struct NextHistory {
  PendingScript script;
  std::unique_ptr<Journal> journal;
  JournalText copied;                // of the present journal, without the records: the later ones are to be copied
  std::size_t before = 0, gone = 0;  // steps that are in the script now, and the bytes of their text
  std::size_t length = 0;            // bytes of the steps in the new journal
};
// Writes script and journal beside those of `path`: the script has the first `before` steps, the journal all others.
// Reads those from the present journal, which another thread may append to. Errors: file, machine.
Result<NextHistory> write_next(const std::string& path, std::string_view script, std::size_t before,
                               const CheckpointStep& done);

// Finishes a checkpoint that was interrupted after the script was replaced and before the journal was: rewrites the
// journal.
Status finish_checkpoint(Journal&, const std::string& script);

// Refuses to replace a text that another process has written.
Status unchanged(const std::string& path, const std::optional<Fingerprint>& known);

// Puts the files of a checkpoint in place, on a thread of its own.
struct Replacement {
  NextHistory next;
  std::string path;
  std::optional<Fingerprint> known;
  bool others = false;
  CheckpointStep step;
  std::thread thread;
  bool started = false;
  std::atomic<bool> done{false};
  bool script_there = false;  // this and the result are valid once `done` is set
  Status result = Nothing{};

  void start();

 private:
  void run();
  Status put_in_place();
};

}  // namespace betwixt
