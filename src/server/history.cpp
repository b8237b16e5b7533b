// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/history.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/files.h"
#include "language/journal.h"
#include "server/ceilings.h"

namespace betwixt {
namespace {

constexpr std::string_view opens = "# bundle", closes = "# end";  // around a step of several lines, in the script

Error not_kept(const std::string& why) {
  return fail(Code::machine, "nothing is done, as the history cannot be kept: " + why);
}

}  // namespace

std::string_view whole_steps(std::string_view text) {
  text = text.substr(0, text.rfind('\n') + 1);
  std::size_t open = std::string_view::npos;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::string_view line = text.substr(at, end - at);
    if (line == opens) open = at;
    if (line == closes) open = std::string_view::npos;
    at = end + 1;
  }
  return text.substr(0, open);
}

History::~History() {
  if (file_ >= 0) ::close(file_);
}

Diagnostics History::begin(std::string text, const std::string& name, const LoadOptions& options, std::string& cut) {
  const std::size_t whole = whole_steps(text).size();
  // An author's last line may lack its end; what a server wrote never does.
  const bool torn = whole < text.size() && text.find(opens) != std::string::npos;
  if (torn) cut = text.substr(whole), text.resize(whole);
  if (!text.empty() && text.back() != '\n') text += '\n';
  base_ = std::move(text);
  Scene scene;
  Diagnostics all;
  Reader reader(scene, all, options);
  reader.carry({}, name);
  reader.read_text(base_, name);
  const std::size_t events = count_events({}, 0, scene);
  now_ = {Document(std::make_shared<const Scene>(std::move(scene))), reader.carried(), events};
  return all;
}

Status History::keep_in(const std::string& path, bool overwrite) {
  const auto there = read_script(path);
  if (!there) return there.error();
  if (*there && !(*there)->empty() && !overwrite)
    return fail(Code::file, fmt::format("--save: '{}' is there already", path),
                fmt::format("--overwrite lets it go; to go on with it: betwixt serve {} --save {}", path, path));
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) return fail(Code::machine, fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
  if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
    ::close(file);
    return fail(Code::file, fmt::format("another server keeps its history in '{}'", path));
  }
  if (!*there || **there != base_) {
    const int why = write_all(file, base_, 0);
    if (why || ::ftruncate(file, static_cast<off_t>(base_.size())) != 0) {
      ::close(file);
      return fail(Code::machine, fmt::format("cannot write '{}': {}", path, std::strerror(why ? why : errno)));
    }
  }
  file_ = file, end_ = static_cast<off_t>(base_.size()), dirty_ = true;
  return sync();
}

// Rows follow their sheet's line, unless they already stand below it.
std::string History::written(std::size_t i) const {
  const Step& s = steps_[i];
  const bool several = s.lines.size() > 1 || s.lines[0].find('\n') != std::string::npos;
  const bool below = i > 0 && !s.sheet.empty() && steps_[i - 1].sheet == s.sheet && !several;
  std::string out;
  if (several) out += fmt::format("{}\n", opens);
  if (!s.sheet.empty() && !below) out += s.sheet + "\n";
  for (const std::string& line : s.lines) out += line + "\n";
  if (several) out += fmt::format("{}\n", closes);
  return out;
}

std::string History::text() const {
  std::string out = base_;
  for (std::size_t i = 0; i < steps_.size(); ++i) out += written(i);
  return out;
}

std::size_t History::Step::bytes() const {
  std::size_t n = sheet.size() + 1;
  for (const std::string& line : lines) n += line.size() + 1;
  return n;
}

Status History::append(Step step) {
  const std::size_t bytes = step.bytes();
  if (bytes_ + bytes > longest_)
    return fail(Code::range, fmt::format("the history would be longer than {} bytes", longest_),
                "undo takes commands back; betwixt serve --history N lets it grow");
  if (Status s = write(std::move(step)); !s) return s;
  bytes_ += bytes;
  return Nothing{};
}

Status History::write(Step step) {
  step.begins = end_;
  steps_.push_back(std::move(step));
  if (file_ < 0) return Nothing{};
  const std::string bytes = written(steps_.size() - 1);
  if (const int why = write_all(file_, bytes, end_)) {
    steps_.pop_back();
    const int cut = ::ftruncate(file_, end_);
    return not_kept(std::strerror(cut == 0 ? why : errno));
  }
  end_ += static_cast<off_t>(bytes.size()), dirty_ = true;
  return Nothing{};
}

Status History::take_back() {
  const off_t to = steps_.back().begins;
  if (file_ >= 0 && ::ftruncate(file_, to) != 0) return not_kept(std::strerror(errno));
  end_ = to, dirty_ = true;
  bytes_ -= steps_.back().bytes();
  steps_.pop_back();
  return Nothing{};
}

Status History::take(Point after, const std::vector<std::string>& lines, const std::string& sheet) {
  if (Status s = append({lines, sheet, 0}); !s) return s;
  undone_.clear();
  before_.push_back(std::exchange(now_, std::move(after)));
  if (before_.size() > depth_) before_.pop_front();
  return Nothing{};
}

Status History::undo() {
  if (before_.empty() && !steps_.empty())
    return fail(Code::range, fmt::format("no more than {} commands can be undone", depth_));
  if (before_.empty()) return fail(Code::range, "there is nothing to undo");
  Step step = steps_.back();
  if (Status s = take_back(); !s) return s;
  undone_.emplace_back(std::move(step), std::exchange(now_, std::move(before_.back())));
  before_.pop_back();
  return Nothing{};
}

Status History::redo() {
  if (undone_.empty()) return fail(Code::range, "there is nothing to redo");
  if (Status s = append(undone_.back().first); !s) return s;
  before_.push_back(std::exchange(now_, std::move(undone_.back().second)));
  undone_.pop_back();
  return Nothing{};
}

Status History::sync() {
  if (!dirty_) return Nothing{};
  if (file_ >= 0 && ::fdatasync(file_) != 0)
    return fail(Code::machine, fmt::format("the history cannot be kept: {}", std::strerror(errno)));
  dirty_ = false;
  return Nothing{};
}

}  // namespace betwixt
