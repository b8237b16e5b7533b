// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/handed_over.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <map>

#include "base/files.h"

namespace betwixt {
namespace {

// A head, then blocks, each with its length before it.
enum class Holds : std::uint32_t { mesh = 1, picture = 2, error = 3 };
struct Head {
  std::uint32_t holds = 0;
  std::uint32_t detail = 0;    // of a mesh whether it is closed, of an error its code
  std::uint64_t pictures = 0;  // of a mesh
};
constexpr std::uint32_t no_picture = ~std::uint32_t{0};
struct FlatPart {
  std::uint32_t first = 0, count = 0;
  std::array<float, 3> color{};
  std::uint32_t picture = no_picture;
};
struct FlatSize {
  std::int32_t width = 0, height = 0;
};

constexpr std::size_t longest_words = 4096, most_pictures = 100'000;
constexpr int largest_side = 16384;

class Giver {
 public:
  explicit Giver(int memory) : memory_(memory) {}
  template <class T>
  void one(const T& value) {
    raw(&value, sizeof value);
  }
  template <class T>
  void block(const T& all) {
    one(static_cast<std::uint64_t>(all.size()));
    raw(all.data(), all.size() * sizeof(*all.data()));
  }
  void picture(const Picture& p) {
    one(FlatSize{p.width, p.height});
    block(p.rgba);
  }
  void mesh(const Mesh& m) {
    std::map<const Picture*, std::uint32_t> numbers;
    std::vector<const Picture*> pictures;
    std::vector<FlatPart> parts;
    for (const MeshPart& p : m.parts) {
      parts.push_back({p.first, p.count, p.color, no_picture});
      if (!p.texture) continue;
      const auto [at, fresh] = numbers.try_emplace(p.texture.get(), static_cast<std::uint32_t>(pictures.size()));
      if (fresh) pictures.push_back(p.texture.get());
      parts.back().picture = at->second;
    }
    one(Head{static_cast<std::uint32_t>(Holds::mesh), m.closed ? 1U : 0U, pictures.size()});
    for (const Picture* p : pictures) picture(*p);
    block(parts), block(m.positions), block(m.normals), block(m.uvs), block(m.triangles), block(m.edges);
  }
  void error(const Error& e) {
    one(Head{static_cast<std::uint32_t>(Holds::error), static_cast<std::uint32_t>(e.code), 0});
    block(e.message.substr(0, longest_words)), block(e.hint.substr(0, longest_words));
  }
  int reason() const { return reason_; }

 private:
  void raw(const void* bytes, std::size_t size) {
    if (reason_ == 0) reason_ = write_all(memory_, {static_cast<const char*>(bytes), size});
  }
  int memory_, reason_ = 0;
};

// Copies out, never looks at what is shared twice: the other process may still be writing.
class Taker {
 public:
  Taker(int memory, std::uint64_t size) : memory_(memory), left_(size) {}
  template <class T>
  bool one(T& value) {
    return raw(&value, sizeof value);
  }
  template <class T>
  bool block(T& all) {
    std::uint64_t count = 0;
    if (!one(count) || count > left_ / sizeof(*all.data())) return false;
    all.resize(count);
    return raw(all.data(), count * sizeof(*all.data()));
  }
  bool done() const { return left_ == 0; }

 private:
  bool raw(void* to, std::uint64_t size) {
    if (size > left_) return false;
    left_ -= size;
    for (auto* at = static_cast<char*>(to); size > 0;) {
      const ssize_t n = ::pread(memory_, at, size, at_);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      at += n, at_ += n, size -= static_cast<std::uint64_t>(n);
    }
    return true;
  }
  int memory_;
  std::uint64_t left_;
  off_t at_ = 0;
};

template <std::size_t N>
bool finite(const std::vector<std::array<float, N>>& all) {
  return std::all_of(all.begin(), all.end(), [](const auto& v) {
    return std::all_of(v.begin(), v.end(), [](float f) { return std::isfinite(f); });
  });
}

bool below(const std::vector<std::uint32_t>& indices, std::size_t per, std::size_t count) {
  return indices.size() % per == 0 &&
         std::all_of(indices.begin(), indices.end(), [&](std::uint32_t i) { return i < count; });
}

bool sound(const Mesh& m) {
  const std::size_t count = m.positions.size();
  return m.normals.size() == count && (m.uvs.empty() || m.uvs.size() == count) && finite(m.positions) &&
         finite(m.normals) && finite(m.uvs) && !m.triangles.empty() && below(m.triangles, 3, count) &&
         below(m.edges, 2, count);
}

// They cover the triangles, one behind the other.
bool take_parts(const std::vector<FlatPart>& flat, const std::vector<std::shared_ptr<const Picture>>& pictures,
                Mesh& m) {
  std::uint64_t covered = 0;
  for (const FlatPart& f : flat) {
    const bool known = f.picture == no_picture || f.picture < pictures.size();
    if (f.first != covered || f.count % 3 != 0 || !known || !finite(std::vector{f.color})) return false;
    covered += f.count;
    m.parts.push_back({f.first, f.count, f.color, f.picture == no_picture ? nullptr : pictures[f.picture]});
  }
  return flat.empty() || covered == m.triangles.size();
}

std::shared_ptr<const Picture> take_picture(Taker& from) {
  FlatSize size;
  auto picture = std::make_shared<Picture>();
  if (!from.one(size) || size.width < 1 || size.height < 1 || size.width > largest_side || size.height > largest_side)
    return nullptr;
  picture->width = size.width, picture->height = size.height;
  const auto bytes = 4 * static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height);
  return from.block(picture->rgba) && picture->rgba.size() == bytes ? picture : nullptr;
}

std::shared_ptr<const Mesh> take_mesh(Taker& from, const Head& head) {
  if (head.detail > 1 || head.pictures > most_pictures) return nullptr;
  std::vector<std::shared_ptr<const Picture>> pictures;
  while (pictures.size() < head.pictures) {
    pictures.push_back(take_picture(from));
    if (!pictures.back()) return nullptr;
  }
  std::vector<FlatPart> parts;
  auto mesh = std::make_shared<Mesh>();
  mesh->closed = head.detail == 1;
  const bool whole = from.block(parts) && from.block(mesh->positions) && from.block(mesh->normals) &&
                     from.block(mesh->uvs) && from.block(mesh->triangles) && from.block(mesh->edges);
  return whole && sound(*mesh) && take_parts(parts, pictures, *mesh) ? mesh : nullptr;
}

// Words that a terminal may be shown.
bool take_words(Taker& from, std::string& words) {
  if (!from.block(words) || words.size() > longest_words) return false;
  std::replace_if(
      words.begin(), words.end(), [](unsigned char c) { return c < 32 || c == 127; }, ' ');
  return true;
}

bool take(Taker& from, Parsed& out) {
  Head head;
  if (!from.one(head)) return false;
  if (head.holds == static_cast<std::uint32_t>(Holds::mesh)) {
    auto mesh = take_mesh(from, head);
    out = mesh;
    return mesh != nullptr;
  }
  if (head.holds == static_cast<std::uint32_t>(Holds::picture)) {
    auto picture = take_picture(from);
    out = picture;
    return picture != nullptr;
  }
  Error e;
  if (head.holds != static_cast<std::uint32_t>(Holds::error) ||
      head.detail > static_cast<std::uint32_t>(ErrorCode::machine) || !take_words(from, e.message) ||
      !take_words(from, e.hint))
    return false;
  e.code = static_cast<ErrorCode>(head.detail);
  out = e;
  return true;
}

}  // namespace

int hand_over(const Parsed& parsed, int memory) {
  Giver to(memory);
  if (const auto* mesh = std::get_if<std::shared_ptr<const Mesh>>(&parsed)) {
    to.mesh(**mesh);
  } else if (const auto* picture = std::get_if<std::shared_ptr<const Picture>>(&parsed)) {
    to.one(Head{static_cast<std::uint32_t>(Holds::picture), 0, 0});
    to.picture(**picture);
  } else {
    to.error(std::get<Error>(parsed));
  }
  return to.reason();
}

int take_over(int memory, Parsed& out) {
  struct stat about {};
  if (::fstat(memory, &about) != 0) return errno;
  // Memory that it claims it must have had.
  const auto size = static_cast<std::uint64_t>(about.st_size);
  if (!S_ISREG(about.st_mode) || static_cast<std::uint64_t>(about.st_blocks) * 512 < size) return EBADMSG;
  Taker from(memory, size);
  return take(from, out) && from.done() ? 0 : EBADMSG;
}

}  // namespace betwixt
