// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/history.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "base/files.h"
#include "editor/journal.h"

namespace betwixt {
namespace {

constexpr std::string_view opens = "# bundle", closes = "# end";  // around a step of several lines, in the script

Error not_kept(const std::string& why) {
  return fail(ErrorCode::machine, "nothing is done, as the history cannot be kept: " + why);
}

std::size_t bytes_of(const Step& step) {
  std::size_t n = step.sheet.size() + 1;
  for (const std::string& line : step.lines) n += line.size() + 1;
  return n;
}

// Rows follow their sheet's line, unless they already stand below it.
std::string written(const Step& step, const Step* above) {
  const bool several = step.lines.size() > 1 || step.lines[0].find('\n') != std::string::npos;
  const bool below = above && !step.sheet.empty() && above->sheet == step.sheet && !several;
  std::string out;
  if (several) out += fmt::format("{}\n", opens);
  if (!step.sheet.empty() && !below) out += step.sheet + "\n";
  for (const std::string& line : step.lines) out += line + "\n";
  if (several) out += fmt::format("{}\n", closes);
  return out;
}

}  // namespace

std::string as_script(const std::string& base, std::span<const Step> steps) {
  std::string out = base;
  for (std::size_t i = 0; i < steps.size(); ++i) out += written(steps[i], i > 0 ? &steps[i - 1] : nullptr);
  return out;
}

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

std::string begun_with(std::string text, std::string& cut) {
  const std::size_t whole = whole_steps(text).size();
  // An author's last line may lack its end; what a server wrote never does.
  const bool torn = whole < text.size() && text.find(opens) != std::string::npos;
  if (torn) cut = text.substr(whole), text.resize(whole);
  if (!text.empty() && text.back() != '\n') text += '\n';
  return text;
}

History::~History() {
  if (file_ >= 0) ::close(file_);
}

Status History::keep_in(const std::string& path, bool overwrite, const std::string& base) {
  const auto there = read_script(path);
  if (!there) return there.error();
  if (*there && !(*there)->empty() && !overwrite)
    return fail(ErrorCode::file, fmt::format("--save: '{}' is there already", path),
                fmt::format("--overwrite lets it go; to go on with it: betwixt serve {} --save {}", path, path));
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file < 0) return fail(ErrorCode::machine, fmt::format("cannot write '{}': {}", path, std::strerror(errno)));
  if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
    ::close(file);
    return fail(ErrorCode::file, fmt::format("another server keeps its history in '{}'", path));
  }
  if (!*there || **there != base) {
    const int why = write_all(file, base, 0);
    if (why || ::ftruncate(file, static_cast<off_t>(base.size())) != 0) {
      ::close(file);
      return fail(ErrorCode::machine, fmt::format("cannot write '{}': {}", path, std::strerror(why ? why : errno)));
    }
  }
  file_ = file, end_ = static_cast<off_t>(base.size()), dirty_ = true;
  return sync();
}

Status History::note(Did what, const Step& step, std::span<const Step> standing) {
  return what == Did::undo ? take_back(step) : append(step, standing);
}

Status History::append(const Step& step, std::span<const Step> standing) {
  const std::size_t more = bytes_of(step);
  if (bytes_ + more > longest_)
    return fail(ErrorCode::range, fmt::format("the history would be longer than {} bytes", longest_),
                "undo takes commands back; betwixt serve --history N lets it grow");
  const off_t begins = end_;
  if (file_ >= 0) {
    const std::string text = written(step, standing.empty() ? nullptr : &standing.back());
    if (const int why = write_all(file_, text, end_)) {
      const int cut = ::ftruncate(file_, end_);
      return not_kept(std::strerror(cut == 0 ? why : errno));
    }
    end_ += static_cast<off_t>(text.size()), dirty_ = true;
  }
  begins_.push_back(begins);
  bytes_ += more;
  return Nothing{};
}

Status History::take_back(const Step& step) {
  if (file_ >= 0 && ::ftruncate(file_, begins_.back()) != 0) return not_kept(std::strerror(errno));
  end_ = begins_.back(), dirty_ = true;
  begins_.pop_back();
  bytes_ -= bytes_of(step);
  return Nothing{};
}

Status History::sync() {
  if (!dirty_) return Nothing{};
  if (file_ >= 0 && ::fdatasync(file_) != 0)
    return fail(ErrorCode::machine, fmt::format("the history cannot be kept: {}", std::strerror(errno)));
  dirty_ = false;
  return Nothing{};
}

}  // namespace betwixt
