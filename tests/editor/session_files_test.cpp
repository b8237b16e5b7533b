// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests how a session keeps files: it overwrites, loses or leaves nothing without asking.
#include "betwixt/language.h"
#include "betwixt/session.h"
#include "editor/author.h"

namespace betwixt {
namespace {

// shows: G22
TEST(Session, SavingKeepsTheAuthorsText) {
  const Folder folder;
  Session s = opened(folder, author);
  expect_done(s, "set ball.radius 2");
  expect_done(s, "undo");
  expect_done(s, "set ball.radius 3  # larger");
  expect_done(s, "save");
  EXPECT_EQ(folder.get("film.bx"), std::string(author) + "\nset ball.radius 3  # larger\n");
  EXPECT_EQ(s.unsaved(), 0u);
  expect_done(s, "undo");  // what has been saved can be taken back too
  EXPECT_EQ(s.unsaved(), 1u);
  expect_done(s, "save");
  EXPECT_EQ(folder.get("film.bx"), author);
  expect_done(s, "quit");
  EXPECT_FALSE(folder.has(".film.bx.journal"));
}

// shows: G22
TEST(Session, OverwritingIsAsked) {
  const Folder folder;
  folder.put("other.bx", "# precious\n");
  std::string asked;
  Session s = opened(folder, nullptr, answering({"maybe", "no", "yes"}, &asked));
  expect_done(s, "rate 25");
  EXPECT_FALSE(s.enter("save " + folder / "other.bx").done);
  EXPECT_NE(asked.find("already exists; overwrite it: yes or no?"), std::string::npos) << asked;
  EXPECT_EQ(folder.get("other.bx"), "# precious\n");
  expect_done(s, "save " + folder / "other.bx");
  EXPECT_EQ(folder.get("other.bx"), "rate 25\n");
}

// shows: G22
TEST(Session, QuittingIsGuarded) {
  const Folder folder;
  std::string asked;
  Session s = opened(folder, nullptr, answering({"stay", "save"}, &asked));
  expect_done(s, "rate 25");
  EXPECT_FALSE(s.enter("quit").quit);
  EXPECT_NE(asked.find("1 command is not saved: save, discard or stay?"), std::string::npos);
  EXPECT_TRUE(s.enter("quit").quit);
  EXPECT_EQ(folder.get("film.bx"), "rate 25\n");
}

// shows: G22
TEST(Session, TheSecondMayOnlyLook) {
  const Folder folder;
  folder.put("film.bx", author);
  Session first, second;
  first.open(folder / "film.bx");
  EXPECT_NE(second.open(folder / "film.bx").said.find("is read-only"), std::string::npos);
  EXPECT_FALSE(second.may_change());
  EXPECT_FALSE(second.enter("rate 25").done);
  EXPECT_FALSE(second.enter("save").done);
  expect_done(second, "list");
  expect_done(first, "rate 25");
}

// shows: G22
TEST(Session, CtrlCAtAQuestionStays) {
  const Folder folder;
  folder.put("other.bx", "rate 30\n");
  Session s = opened(folder, nullptr,
                     answering({std::string(Session::called_off), std::string(Session::called_off), "discard"}));
  expect_done(s, "rate 25");
  EXPECT_FALSE(s.enter("quit").quit);
  EXPECT_EQ(s.enter("save " + folder / "other.bx").said, "not saved\n");
  EXPECT_EQ(folder.get("other.bx"), "rate 30\n");
  EXPECT_EQ(s.unsaved(), 1u);
  const auto missing = s.enter("open " + folder / "nowhere.bx");  // nothing is asked
  EXPECT_EQ(missing.said.substr(0, missing.said.find('\n')), "error: there is no file '" + folder / "nowhere.bx" + "'");
  EXPECT_EQ(s.unsaved(), 1u);
  EXPECT_TRUE(s.enter("quit").quit);
}

// shows: G22
TEST(Plugins, SavingSaysThatTheFilmNeedsThem) {
  ASSERT_TRUE(use_plugin(std::string(PLUGIN_DIR "/example.so")));
  const std::string file = testing::TempDir() + "betwixt-plugged.bx";
  std::filesystem::remove(file);
  Session s;
  s.open(file, Session::Earlier::discard);
  s.enter("create overshooter sphere");  // no word of the plug-in
  EXPECT_EQ(s.enter("save").said, "saved '" + file + "'\n");
  s.enter("at 1f overshooter.radius 2 overshoot");
  EXPECT_EQ(s.enter("save").said, "it uses a plug-in; to show it: betwixt play --load " +
                                      std::string(PLUGIN_DIR "/example.so") + " " + file + "\nsaved '" + file + "'\n");
}

}  // namespace
}  // namespace betwixt
