// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>

#include "server/frame_clock.h"

namespace betwixt {
namespace {

constexpr std::uint32_t count = 4, page = 4096;

struct Head {
  char magic[8];
  std::uint32_t version, pictures_at, width, height, count, picture_head;
  std::uint64_t stride;
  std::atomic<std::uint64_t> written;  // number of pictures written; the last one is at (written - 1) mod count
  std::atomic<std::uint32_t> over;     // 1 after the server has ended
};
struct PictureHead {
  std::atomic<std::uint64_t> sequence;  // odd during writing (a seqlock)
  std::int64_t flicks, number, moment;
  char unused[32];
};
static_assert(sizeof(Head) == 56 && sizeof(PictureHead) == 64);
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

class Ring final : public Screen {
 public:
  Ring(std::unique_ptr<Renderer> renderer, std::string name, int file, void* at, std::size_t size, std::size_t stride)
      : renderer_(std::move(renderer)), name_(std::move(name)), file_(file), at_(at), size_(size), stride_(stride) {}
  ~Ring() override {
    head()->over.store(1, std::memory_order_release);
    ::munmap(at_, size_);
    ::shm_unlink(name_.c_str());
    ::close(file_);
  }
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;

  Status draw(const Evaluation& e) override {
    if (Status s = renderer_->render(e, picture_); !s) return s;
    PictureHead* const p = next();
    p->sequence.store(2 * head()->written.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    std::atomic_thread_fence(std::memory_order_release);
    std::memcpy(reinterpret_cast<char*>(p) + sizeof(PictureHead), picture_.rgba.data(), picture_.rgba.size());
    return Nothing{};
  }
  Status show(const Shown& s) override {
    PictureHead* const p = next();
    const std::uint64_t n = head()->written.load(std::memory_order_relaxed);
    p->flicks = s.time.flicks, p->number = s.number, p->moment = monotonic_now();
    p->sequence.store(2 * n + 2, std::memory_order_release);
    head()->written.store(n + 1, std::memory_order_release);
    return Nothing{};
  }

 private:
  Head* head() const { return static_cast<Head*>(at_); }
  PictureHead* next() const {
    const std::uint64_t n = head()->written.load(std::memory_order_relaxed);
    return reinterpret_cast<PictureHead*>(static_cast<char*>(at_) + page + n % count * stride_);
  }

  std::unique_ptr<Renderer> renderer_;
  Picture picture_;
  const std::string name_;
  const int file_;
  void* const at_;
  const std::size_t size_, stride_;
};

Error not_had(const std::string& name) {
  return fail(ErrorCode::machine, fmt::format("cannot open the ring '{}': {}", name.substr(1), std::strerror(errno)));
}

// Creates shared memory of this name and locks its file while the server runs. Replaces what a killed server left
// behind.
Result<int> take_name(const std::string& name) {
  if (const int old = ::shm_open(name.c_str(), O_RDWR, 0); old >= 0) {
    const bool held = ::flock(old, LOCK_EX | LOCK_NB) != 0;
    ::close(old);
    if (held) return fail(ErrorCode::file, fmt::format("another server uses the ring '{}'", name.substr(1)));
    ::shm_unlink(name.c_str());
  }
  const int file = ::shm_open(name.c_str(), O_RDWR | O_CREAT | O_EXCL, 0600);
  if (file < 0 || ::flock(file, LOCK_EX | LOCK_NB) != 0) {
    const Error e = not_had(name);
    if (file >= 0) ::close(file);
    return e;
  }
  return file;
}

}  // namespace

NewScreen ring_screen(const std::string& plain, const RenderOptions& picture) {
  return [=]() -> Result<std::unique_ptr<Screen>> {
    if (plain.empty() || plain.size() > 200 || plain.find('/') != std::string::npos)
      return fail(ErrorCode::range, fmt::format("\"{}\" is not the name of a ring", plain), "as in ring:stage");
    const std::string name = "/" + plain;
    auto renderer = make_renderer(picture);
    if (!renderer) return renderer.error();
    const Result<int> file = take_name(name);
    if (!file) return file.error();
    const std::size_t pixels = 4 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    const std::size_t stride = (sizeof(PictureHead) + pixels + page - 1) / page * page, size = page + count * stride;
    // Allocates all memory now: a page that cannot be had later would end the process.
    errno = ::posix_fallocate(*file, 0, static_cast<off_t>(size));
    void* const at = errno ? MAP_FAILED : ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, *file, 0);
    if (at == MAP_FAILED) {
      const Error e = not_had(name);
      ::shm_unlink(name.c_str());
      ::close(*file);
      return e;
    }
    Head* const head = new (at) Head{};
    head->version = 1, head->pictures_at = page, head->count = count, head->picture_head = sizeof(PictureHead);
    head->width = static_cast<std::uint32_t>(picture.width), head->height = static_cast<std::uint32_t>(picture.height);
    head->stride = stride;
    std::atomic_thread_fence(std::memory_order_release);
    std::memcpy(head->magic, "BTWXRING", sizeof head->magic);  // last, because readers wait for it
    return std::unique_ptr<Screen>(std::make_unique<Ring>(*std::move(renderer), name, *file, at, size, stride));
  };
}

}  // namespace betwixt
