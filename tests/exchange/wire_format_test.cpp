// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/wire_format.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <random>

#include "base/files.h"

namespace betwixt {
namespace {

std::shared_ptr<const Mesh> two_triangles() {
  Mesh m;
  m.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  m.normals.assign(4, {0, 0, 1});
  m.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  m.triangles = {0, 1, 2, 0, 2, 3};
  m.edges = {0, 1, 1, 2};
  const auto paint = std::make_shared<const Picture>(Picture{1, 2, {1, 2, 3, 4, 5, 6, 7, 8}});
  m.parts = {{0, 3, {1, 0, 0}, paint}, {3, 3, {0, 1, 0}, nullptr}};
  return std::make_shared<const Mesh>(std::move(m));
}

struct HeldFile {
  OpenFile file{::memfd_create("test", MFD_CLOEXEC)};
  HeldFile() = default;
  explicit HeldFile(const std::string& bytes) { EXPECT_EQ(write_all(file.fd(), bytes), 0); }
  std::string bytes() const {
    std::string all;
    EXPECT_EQ(read_all(file.fd(), all), 0);
    return all;
  }
};

// Whatever is taken over, nothing in it leads out of it.
void expect_sound(const Mesh& m) {
  for (const auto i : m.triangles) ASSERT_LT(i, m.positions.size());
  for (const auto i : m.edges) ASSERT_LT(i, m.positions.size());
  ASSERT_EQ(m.triangles.size() % 3 + m.edges.size() % 2, 0U);
  ASSERT_EQ(m.normals.size(), m.positions.size());
  ASSERT_TRUE(m.uvs.empty() || m.uvs.size() == m.positions.size());
  for (const auto& p : m.positions)
    for (const float f : p) ASSERT_TRUE(std::isfinite(f));
  std::size_t end = 0;
  for (const auto& part : m.parts) {
    ASSERT_EQ(part.first, end);
    end += part.count;
    if (part.texture) {
      ASSERT_EQ(part.texture->rgba.size(), 4U * static_cast<unsigned>(part.texture->width * part.texture->height));
    }
  }
  ASSERT_EQ(end, m.triangles.size());
}

TEST(HandedOver, ComesAsItWent) {
  HeldFile mesh, picture, error;
  ASSERT_EQ(write_parsed(two_triangles(), mesh.file.fd()), 0);
  ASSERT_EQ(write_parsed(two_triangles()->parts[0].texture, picture.file.fd()), 0);
  ASSERT_EQ(
      write_parsed(fail(ErrorCode::range, "too\x1b[2Jlarge", Hint(Permission::read_anywhere, "less")), error.file.fd()),
      0);
  Parsed got;
  ASSERT_EQ(read_parsed(mesh.file.fd(), got), 0);
  const Mesh &m = *std::get<0>(got), wanted = *two_triangles();
  EXPECT_EQ(m.positions, wanted.positions);
  EXPECT_EQ(m.uvs, wanted.uvs);
  EXPECT_EQ(m.edges, wanted.edges);
  EXPECT_EQ(m.parts[0].texture->rgba, wanted.parts[0].texture->rgba);
  EXPECT_EQ(m.parts[1].color, wanted.parts[1].color);
  EXPECT_FALSE(m.parts[1].texture);
  ASSERT_EQ(read_parsed(picture.file.fd(), got), 0);
  EXPECT_EQ(std::get<1>(got)->rgba[7], 8);
  ASSERT_EQ(read_parsed(error.file.fd(), got), 0);
  EXPECT_EQ(std::get<2>(got).code, ErrorCode::range);
  EXPECT_EQ(std::get<2>(got).needs, Permission::read_anywhere);
  EXPECT_EQ(std::get<2>(got).message, "too [2Jlarge") << "a terminal may be shown it";
}

TEST(HandedOver, IsNotBelieved) {
  HeldFile mesh;
  ASSERT_EQ(write_parsed(two_triangles(), mesh.file.fd()), 0);
  const std::string good = mesh.bytes();
  std::mt19937 random(7);
  int refused = 0;
  for (std::size_t i = 0; i < 40'000; ++i) {
    std::string bad = good;
    static constexpr unsigned char odd[] = {0, 1, 2, 3, 0x7f, 0x80, 0xff};
    for (unsigned n = 1 + random() % 3; n > 0; --n)
      bad[random() % bad.size()] = static_cast<char>(random() % 2 ? odd[random() % 7] : random() & 255);
    if (random() % 4 == 0) bad.resize(random() % bad.size());
    Parsed got;
    const int reason = read_parsed(HeldFile(bad).file.fd(), got);
    ASSERT_TRUE(reason == 0 || reason == EBADMSG);
    refused += reason != 0;
    if (reason == 0 && got.index() == 0) expect_sound(*std::get<0>(got));
  }
  EXPECT_GT(refused, 10'000);
  Parsed got;
  EXPECT_EQ(read_parsed(HeldFile().file.fd(), got), EBADMSG);
  EXPECT_EQ(read_parsed(HeldFile(good + '!').file.fd(), got), EBADMSG);
}

TEST(HandedOver, LettersComeAsTheyWentAndAreNotBelieved) {
  const auto line = std::make_shared<const ShapedLine>(
      ShapedLine{{{3, 0, 0.5, {}}, {4, 1, 0.25, {0.125, 0, 0}}}, {{3, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}, {4, {}}}});
  HeldFile letters;
  ASSERT_EQ(write_parsed(line, letters.file.fd()), 0);
  Parsed got;
  ASSERT_EQ(read_parsed(letters.file.fd(), got), 0);
  const ShapedLine& same = *std::get<std::shared_ptr<const ShapedLine>>(got);
  ASSERT_EQ(same.glyphs.size(), 2U);
  EXPECT_EQ(same.glyphs[1].shift.x, 0.125);
  EXPECT_EQ(same.outlines, line->outlines);
  const std::string good = letters.bytes();
  std::mt19937 random(8);
  int refused = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string bad = good;
    for (unsigned n = 1 + random() % 3; n > 0; --n) bad[8 + random() % (bad.size() - 8)] = static_cast<char>(random());
    if (random() % 4 == 0) bad.resize(random() % bad.size());
    const int reason = read_parsed(HeldFile(bad).file.fd(), got);
    ASSERT_TRUE(reason == 0 || reason == EBADMSG);
    refused += reason != 0;
    if (reason == 0)
      for (const auto& [number, contours] : std::get<std::shared_ptr<const ShapedLine>>(got)->outlines)
        for (const auto& contour : contours)
          for (const Vec3& p : contour) ASSERT_LE(std::abs(p.x) + std::abs(p.y), 2e6);
  }
  EXPECT_GT(refused, 1000);
}

TEST(HandedOver, ClaimsNoMemoryThatItNeverHad) {
  // A picture of 16384 x 16384 pixels that are all in the file's hole.
  HeldFile picture;
  ASSERT_EQ(write_parsed(two_triangles()->parts[0].texture, picture.file.fd()), 0);
  std::string bytes = picture.bytes();
  const std::int32_t side = 16384;
  const std::uint64_t size = std::uint64_t{4} * 16384 * 16384;
  bytes.replace(16, 4, reinterpret_cast<const char*>(&side), 4);
  bytes.replace(20, 4, reinterpret_cast<const char*>(&side), 4);
  bytes.replace(24, 8, reinterpret_cast<const char*>(&size), 8);
  const HeldFile hole(bytes);
  ASSERT_EQ(::ftruncate(hole.file.fd(), static_cast<off_t>(32 + size)), 0);
  Parsed got;
  EXPECT_EQ(read_parsed(hole.file.fd(), got), EBADMSG);
}

}  // namespace
}  // namespace betwixt
