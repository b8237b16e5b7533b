// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The history of a document: a script, and every step since. It may be stored: the script in a file, the steps in a
// journal beside it, in the format of a session. Then an acknowledged step survives any end of the process.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "betwixt/result.h"
#include "editor/journal.h"
#include "editor/next_history.h"
#include "editor/step_list.h"

namespace betwixt {

// The history that a script and its journal make together.
struct StoredHistory {
  std::string base;  // the text before the steps: the script, or the part of it before the steps that were saved
  StepList steps;
  std::string remarks;   // one line each
  bool goes_on = false;  // the journal has these steps, and can be appended to
  std::string script;    // the whole text of the file
};

// A sink of an editor, which gets every step before it is taken.
class History {
 public:
  // `longest`: the limit for the commands in bytes, without the base text.
  explicit History(std::size_t longest, CheckpointStep step = {});
  ~History();  // waits for a checkpoint whose files are being put in place
  History(const History&) = delete;
  History& operator=(const History&) = delete;

  // Locks the journal beside `path`. Errors: file (another process has it), machine.
  Status hold(const std::string& path);
  // Returns the history in the script and the locked journal. `script`: nullopt if the file does not exist. Leaves out
  // records that are torn or damaged; keeps a copy of the journal under another name if it is more than torn.
  Result<StoredHistory> found(const std::optional<std::string>& script);
  // Writes the base text to the file and begins an empty journal. Errors: file, machine.
  Status keep(const std::string& base);
  // Continues a history that found() returned: file and journal hold it already.
  void go_on(std::span<const Step> steps, std::span<const Step> undone, const std::string& script);
  // Rewrites the journal with other steps, then continues.
  Status go_on_with(const std::string& base, std::span<const Step> steps, std::span<const Step> undone,
                    const std::string& script);

  // Writes a step to the journal. On failure (the disk is full, the history is too long) nothing has changed.
  Status note(Did what, const Step& step);
  // Flushes the journal to the disk. After a failure it is unknown which steps are there.
  Status sync();
  // Writes all standing steps to the file; refuses if another process has changed it. Errors: file, machine.
  Status save(const std::string& base, std::span<const Step> steps, std::span<const Step> undone);

  // Goes over to the files of a checkpoint. From now on, each step is noted in both journals. The next sync() starts a
  // thread that puts the files in place. An interruption at any moment leaves a history of the same document. On
  // failure nothing has changed.
  Status go_over_to(NextHistory);
  bool goes_over() const { return change_ != nullptr; }
  void wait();  // for that thread, if it has been started
  // Returns nullopt until the thread has ended. On failure the steps stay in the journal.
  std::optional<Status> gone_over();
  // Does all of it now: the script is replaced, and the journal has these steps.
  Status replace(const PendingScript& script, std::span<const Step> steps, std::span<const Step> undone);
  // Without files: the history has only these steps now.
  void measure(std::span<const Step> steps, std::span<const Step> undone);
  // Removes the journal, as the file holds everything.
  void finish();

  std::size_t bytes() const { return bytes_; }  // of the standing commands after the base
  // Bytes since the base began; every step adds to it, and undone ones still count.
  std::size_t length() const { return length_; }
  // The fingerprint of the file when it was last read or written.
  Fingerprint known() const { return known_.value_or(Fingerprint{}); }
  const std::string& path() const { return path_; }  // of the script; "" if nothing is stored
  std::string journal() const { return journal_path(path_); }

 private:
  bool in_place() const;

  const std::size_t longest_;
  const CheckpointStep step_;
  std::string path_;
  std::unique_ptr<Journal> journal_;
  std::optional<Fingerprint> known_;     // of the file when it was last read or written; nullopt if there was none
  bool others_ = false;                  // the file existed before this history
  std::unique_ptr<Replacement> change_;  // while a checkpoint's files are being put in place
  std::size_t bytes_ = 0, length_ = 0;
};

}  // namespace betwixt
