// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "server/time_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cinttypes>
#include <cstdio>
#include <cstring>

namespace betwixt {
namespace {

// There are two halves, written in turn, each with a checksum, so one is always valid.
constexpr std::size_t half = 512;

Error time_not_kept(const std::string& path) {
  return fail(ErrorCode::machine, fmt::format("'{}' cannot be written: {}", path, std::strerror(errno)));
}

}  // namespace

Result<TimeFile> TimeFile::open(const std::string& script) {
  std::string path = journal_path(script);
  path.replace(path.rfind(".journal"), std::string::npos, ".time");
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
  if (file < 0) return time_not_kept(path);
  TimeFile out(std::move(path), file);
  out.read();
  return out;
}

void TimeFile::read() {
  std::string all;
  if (read_all(file_.fd(), all, 2 * half) != 0) return;
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string one = all.substr(std::min(k * half, all.size()), half);
    const std::size_t check = one.rfind(' ', one.find('\n'));
    std::uint64_t number = 0, sum = 0;
    int running = 0;
    KeptTime kept;
    Fingerprint of;
    const char* const form = "betwixt-time 1 %" SCNu64 " %d %" SCNd64 " %" SCNu64 " %" SCNx64 " %" SCNx64;
    if (check == std::string::npos ||
        std::sscanf(one.c_str(), form, &number, &running, &kept.at.flicks, &of.size, &of.hash, &sum) != 6 ||
        sum != fingerprint(std::string_view(one).substr(0, check)).hash || number < number_)
      continue;
    kept.running = running != 0;
    number_ = number, found_ = kept, of_ = of;
  }
}

bool TimeFile::is_of(std::string_view text) const {
  return found_ && text.size() >= of_.size && fingerprint(text.substr(0, of_.size)) == of_;
}

Status TimeFile::write(const KeptTime& kept, const Fingerprint& of) {
  ++number_;
  std::string text = fmt::format("betwixt-time 1 {} {:d} {} {}", number_, kept.running, kept.at.flicks, to_string(of));
  text += fmt::format(" {:016x}\n", fingerprint(text).hash);
  if (const int reason = write_all(file_.fd(), text, static_cast<off_t>(number_ % 2 * half))) {
    errno = reason;
    return time_not_kept(path_);
  }
  if (::fdatasync(file_.fd()) != 0) return time_not_kept(path_);
  return Nothing{};
}

}  // namespace betwixt
