// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "film/samples.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>

#include "base/files.h"
#include "betwixt/sound.h"

namespace betwixt {
namespace {

int nameless_file(const std::string& folder) {
#ifdef O_TMPFILE
  if (const int file = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600); file >= 0) return file;
#endif
  std::string name = folder + "/.betwixt-sound-XXXXXX";
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file >= 0) ::unlink(name.c_str());
  return file;
}

}  // namespace

Samples::~Samples() {
  if (file_ >= 0) ::close(file_);
}

Status Samples::make(const FilmOptions& o, const std::string& folder) {
  const auto pairs = static_cast<std::size_t>(
      std::llround(static_cast<double>(o.frames) * sound_rate * o.rate.den / static_cast<double>(o.rate.num)));
  const std::size_t bytes = std::max<std::size_t>(pairs, 1) * 2 * sizeof(float);
  file_ = nameless_file(folder);
  if (file_ < 0) return system_error(errno, "keep the sound of", o.path);
  // Allocate all now: a write to memory without disk space would kill this program.
  if (const int failed = ::posix_fallocate(file_, 0, static_cast<off_t>(bytes)); failed != 0)
    return system_error(failed, "keep the sound of", o.path);
  void* const at = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
  if (at == MAP_FAILED) return system_error(errno, "keep the sound of", o.path);
  Status filled = o.sounds(std::span(static_cast<float*>(at), 2 * pairs));
  ::munmap(at, bytes);
  return filled;
}

Status Samples::make(std::string_view text, const FilmOptions& o, const std::string& folder) {
  file_ = nameless_file(folder);
  if (file_ < 0) return system_error(errno, "keep the texts of", o.path);
  while (!text.empty()) {
    const ssize_t n = ::write(file_, text.data(), text.size());
    if (n < 0 && errno != EINTR) return system_error(errno, "keep the texts of", o.path);
    text.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
  }
  return Nothing{};
}

std::string Samples::path() const { return fmt::format("/proc/{}/fd/{}", ::getpid(), file_); }

}  // namespace betwixt
