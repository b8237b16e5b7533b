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
#include "editor/step.h"

namespace betwixt {

// Steps without their documents.
struct StepList {
  std::vector<Step> all;     // standing steps, then the undone ones; the next redo comes first
  std::size_t standing = 0;  // the number of standing steps
  std::span<const Step> stand() const { return {all.data(), standing}; }
  std::span<const Step> undone() const { return std::span(all).subspan(standing); }
  void count(Did what, Step step = {});
};

// The history that a script and its journal make together.
struct Kept {
  std::string base;  // the text before the steps: the script, or the part of it before the steps that were saved
  StepList steps;
  std::string remarks;   // one line each
  bool goes_on = false;  // the journal has these steps, and can be appended to
  std::string script;    // the whole text of the file
};

// Finishes a checkpoint that was interrupted after the script was replaced and before the journal was: rewrites the
// journal.
Status finish_checkpoint(Journal&, const std::string& script);

// A new script on the disk that has not replaced the old one yet.
struct ScriptBeside {
  std::string part, place;
  Fingerprint print;
  // The old script when the new one was written, and the identity of its file as the system gives it.
  std::optional<Fingerprint> seen;
  std::string seen_file;
};
Result<ScriptBeside> write_beside(const std::string& path, std::string_view script);
void drop_beside(const std::string& path);  // removes what an interrupted one has left

// A sink of an editor, which gets every step before it is taken.
class History {
 public:
  // `longest`: the limit for the commands in bytes, without the base text.
  explicit History(std::size_t longest) : longest_(longest) {}

  // Locks the journal beside `path`. Errors: file (another process has it), machine.
  Status hold(const std::string& path);
  // Returns the history in the script and the locked journal. `script`: nullopt if the file does not exist. Leaves out
  // records that are torn or damaged; keeps a copy of the journal under another name if it is more than torn.
  Result<Kept> found(const std::optional<std::string>& script);
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
  Status save(const std::string& base, std::span<const Step> steps);
  // Replaces the file by a checkpoint, which contains the first `before` steps, and begins the journal anew with the
  // later `steps`. An interruption at any moment leaves a history of the same document. `to`: nullopt if nothing is
  // stored.
  Status checkpoint(const std::optional<ScriptBeside>& to, std::size_t before, std::span<const Step> steps,
                    std::span<const Step> undone);
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
  Status unchanged() const;
  Status write(const std::string& script);
  void measure(std::span<const Step> steps, std::span<const Step> undone);

  const std::size_t longest_;
  std::string path_;
  std::unique_ptr<Journal> journal_;
  std::optional<Fingerprint> known_;  // of the file when it was last read or written; nullopt if there was none
  bool others_ = false;               // the file existed before this history
  std::size_t bytes_ = 0, length_ = 0;
};

}  // namespace betwixt
