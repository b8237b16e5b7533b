// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests create NAME scene file="logo.svg": the objects that an SVG drawing becomes.
#include "support/folder.h"
#include "support/loaded_film.h"

namespace betwixt {
namespace {

class Drawings : public testing::Test {
 protected:
  void SetUp() override {
    folder_.put(
        "face.svg",
        "<svg viewBox='0 0 100 100'><rect id='paper' width='100' height='100' fill='white'/><g id='eyes'>"
        "<circle id='left' cx='30' cy='40' r='10' fill='#204080'/><circle id='right' cx='70' cy='40' r='10'/></g>"
        "<path id='mouth' d='M20 70q30 20 60 0' fill='none' stroke='red' stroke-width='4'/></svg>");
  }
  Loaded load(const std::string& text) const { return load_file(folder_.put("film.bx", text)); }
  std::vector<std::string> wrong(const std::string& text) const { return all_told(load(text)); }
  const Folder folder_;
};

TEST_F(Drawings, TheirThingsAreObjects) {
  auto loaded = load("create face scene file=\"face.svg\" position=(1 2 3) scale=(10 10 10)\n");
  ASSERT_FALSE(has_errors(loaded.diagnostics)) << said(loaded.diagnostics);
  LoadedFilm film(write(loaded.document));
  const Program program = Program::compile(loaded.document);
  const auto world = [&](const char* what) {
    const auto found = find_targets(std::string(what) + ".world", loaded.document);
    EXPECT_TRUE(found && found->size() == 1) << what;
    return transform_point(*std::get<Matrix>(program.read(found->front(), Time{})), {});
  };
  EXPECT_NEAR(world("face/left").x, 1 + 10 * -0.2, 1e-9);
  EXPECT_NEAR(world("face/left").y, 2 + 10 * 0.1, 1e-9);
  EXPECT_NEAR(world("face/eyes").x, 1, 1e-9) << "a group stands in the middle of what is in it";
  EXPECT_EQ(film.numbers("face/left.color", "1f"), numbers(Color{0x20 / 255.0, 0x40 / 255.0, 0x80 / 255.0}));
}

TEST_F(Drawings, MoveLikeAllElse) {
  Loaded loaded = load(
      "create face scene file=\"face.svg\"\nface/eyes.rotation.z\n  1f 0deg linear\n  25f 90deg\n"
      "face/mouth.trim\n  1f (0 0)\n  24f (0 0.5)\nset face/*.material matte\ncreate twin like face\n"
      "rename face head\nremove twin/left\n");
  EXPECT_FALSE(has_errors(loaded.diagnostics)) << said(loaded.diagnostics);
}

TEST_F(Drawings, AreWrittenSoThatTheyReadBack) {
  const Loaded loaded = load("create face scene file=\"face.svg\"\nhide face/left\n");
  const std::string once = write(loaded.document);
  const Loaded again = load_text(once, "again.bx");
  ASSERT_FALSE(has_errors(again.diagnostics)) << said(again.diagnostics);
  EXPECT_EQ(write(again.document), once);
}

TEST_F(Drawings, SayWhatIsWrong) {
  using All = std::vector<std::string>;
  EXPECT_EQ(wrong("create a scene\n"), All{"syntax 1:8 a"});
  EXPECT_EQ(wrong("create a scene file=\"none.svg\"\n"), All{"file 1:8 a"});
  EXPECT_TRUE(mentions(load("create a scene file=\"none.svg\"\n"), "none.svg"));
  EXPECT_EQ(wrong("create a scene file=\"../face.svg\"\n"), All{"file 1:8 a"});
  EXPECT_TRUE(mentions(load("create a scene file=\"../face.svg\"\n"), "../face.svg"));
  EXPECT_EQ(wrong("create a scene file=\"film.bx\"\n"), All{"file 1:8 a"});
  EXPECT_TRUE(mentions(load("create a scene file=\"film.bx\"\n"), "film.bx"));
  EXPECT_EQ(wrong("create a scene file=\"face.svg\" radius=3\n"), All{"name 1:32 radius"});
  EXPECT_EQ(wrong("create a group\ncreate a scene file=\"face.svg\"\n"), All{"name 2:8 a"});
  EXPECT_EQ(wrong("create x/a scene file=\"face.svg\"\n"), All{"name 1:8 x/a"});
  folder_.put("photo.svg", "<svg viewBox='0 0 9 9'><circle r='1'/><image/></svg>");
  const Loaded photo = load("create a scene file=\"photo.svg\"\n");
  EXPECT_EQ(remarks_told(photo), All{"warning syntax 1:8 a"});
  EXPECT_TRUE(mentions(photo, "photo.svg") && mentions(photo, "<image>"));
}

}  // namespace
}  // namespace betwixt
