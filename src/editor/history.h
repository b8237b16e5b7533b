// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a document was made of: a script, and every step since. It may be kept: the script in a file, the steps in the
// journal beside it, as a session's are; then a step that has been answered is there, whatever ends the process.
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

// Steps by themselves, without the documents that they make.
struct StepList {
  std::vector<Step> all;     // that stand, then those that were undone, the next one first
  std::size_t standing = 0;  // of them
  std::span<const Step> stand() const { return {all.data(), standing}; }
  std::span<const Step> undone() const { return std::span(all).subspan(standing); }
  void count(Did what, Step step = {});
};

// What a script and the journal beside it make together.
struct Kept {
  std::string base;  // what the steps follow: the script, or what stands in it before the steps that were saved
  StepList steps;
  std::string remarks;   // a line each
  bool goes_on = false;  // the journal holds them: it may be gone on with
  std::string script;    // the whole, as it stands in the file
};

// A checkpoint was stopped between the script, which is the new one, and the journal, which is not: it is written anew
// as it would have been.
Status finish_checkpoint(Journal&, const std::string& script);

// A script on the disk that has not taken its place yet.
struct ScriptBeside {
  std::string part, place;
  Fingerprint print;
  // What stood in the place when it was written, and of which file that was said: the system's words for it.
  std::optional<Fingerprint> seen;
  std::string seen_file;
};
Result<ScriptBeside> write_beside(const std::string& path, std::string_view script);
void drop_beside(const std::string& path);  // what is left of one

// A sink of an editor: it is told of every step before it is done.
class History {
 public:
  // `longest`: so many bytes of commands, beside the text that they follow.
  explicit History(std::size_t longest) : longest_(longest) {}

  // Holds the journal beside `path` from now on. Errors: file (another process has it), machine.
  Status hold(const std::string& path);
  // What stands in the script (none: it is not there) and in the journal that is held. What is torn or damaged is left
  // out, and kept under another name where it was not just torn.
  Result<Kept> found(const std::optional<std::string>& script);
  // From now on the file holds the text, and the journal what will be noted. Errors: file, machine.
  Status keep(const std::string& base);
  // … and they do so already: a history that was found goes on.
  void go_on(std::span<const Step> steps, std::span<const Step> undone, const std::string& script);
  // The same with other steps than the journal has: it begins anew with these.
  Status go_on_with(const std::string& base, std::span<const Step> steps, std::span<const Step> undone,
                    const std::string& script);

  // On failure (the disk is full, the history is too long) nothing has changed.
  Status note(Did what, const Step& step);
  // What was noted is on the disk. A failure leaves unknown what is.
  Status sync();
  // The file holds all that stands. It is refused where somebody else has written there. Errors: file, machine.
  Status save(const std::string& base, std::span<const Step> steps);
  // The file is another text, and the journal begins anew behind it: what stood before the `steps`, so many of them, is
  // in that. A stop at any moment leaves what makes the same. `to`: none where nothing is kept.
  Status checkpoint(const std::optional<ScriptBeside>& to, std::size_t before, std::span<const Step> steps,
                    std::span<const Step> undone);
  // The file holds everything: no journal is needed.
  void finish();

  std::size_t bytes() const { return bytes_; }  // of the commands that stand behind the base
  // Since the base was begun: it grows with every step, undone ones too.
  std::size_t length() const { return length_; }
  // The file's text, as it was read or written last.
  Fingerprint known() const { return known_.value_or(Fingerprint{}); }
  const std::string& path() const { return path_; }  // of the script; empty: nothing is kept
  std::string journal() const { return journal_path(path_); }

 private:
  Status unchanged() const;
  Status write(const std::string& script);
  void measure(std::span<const Step> steps, std::span<const Step> undone);

  const std::size_t longest_;
  std::string path_;
  std::unique_ptr<Journal> journal_;
  std::optional<Fingerprint> known_;  // what the file held when it was last read or written; none: there was none
  bool others_ = false;               // the file was there before us
  std::size_t bytes_ = 0, length_ = 0;
};

}  // namespace betwixt
