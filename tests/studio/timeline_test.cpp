// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/timeline/timeline.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QFile>
#include <QLineEdit>
#include <QTemporaryDir>
#include <QToolButton>

#include "betwixt/language.h"
#include "hands.h"
#include "studio/shell/sound.h"
#include "studio/timeline/ruler.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

const std::string film = R"(rate 24
range 1f 100f
create ball sphere
create eye camera
at 30f note "up"
at 30f note "and on"
at 60f note "down"
)";

}  // namespace

class TimelineTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void dragging_on_the_ruler_goes_to_frames();
  void a_typed_number_goes_to_that_frame();
  void the_keys_play_step_and_stop();
  void a_note_is_dragged();
  void the_ends_of_the_film_are_dragged();
  void sounds_are_bars_with_their_loudness();
  void sections_are_blocks_that_are_dragged();
  void the_end_of_a_section_is_dragged();
  void only_the_line_of_a_section_changes();
  void steps_are_marks_with_their_texts();
  void words_are_below_their_sound();
  void what_is_called_off_changes_nothing();
  void a_double_click_writes_a_note();
  void a_note_of_several_gets_other_words();
  void delete_takes_a_note_out();
  void alt_chooses_the_part_that_is_played();
  void the_wheel_zooms_where_the_hand_is();
};

namespace {

// The panel with its ruler; x of a frame's time in it.
struct Shown {
  Film at{film};
  Timeline panel{at.workspace};
  Ruler& ruler;
  Shown() : ruler(*panel.findChild<Ruler*>("ruler")) { show(panel, 1000, 150); }
  int x(double frame) const { return static_cast<int>(std::lround(ruler.x_of(at.frame(frame)))); }
  QPoint note(double frame) const {
    return {x(frame) + 2, static_cast<int>(ruler.note_box(at.frame(frame)).center().y())};
  }
};

}  // namespace

void TimelineTest::dragging_on_the_ruler_goes_to_frames() {
  Shown s;
  drag(s.ruler, {s.x(10), 5}, {s.x(42) + 2, 5});
  QCOMPARE(s.at.workspace.time(), s.at.frame(42));
  drag(s.ruler, {s.x(10), 5}, {s.x(42) + 3, 5}, Qt::ControlModifier);
  QVERIFY(s.at.workspace.time() > s.at.frame(42) && s.at.workspace.time() < s.at.frame(43));
  QVERIFY(s.at.said.empty());  // time is no part of the film
}

void TimelineTest::a_typed_number_goes_to_that_frame() {
  Shown s;
  auto* at = s.panel.findChild<QLineEdit*>("at");
  at->selectAll();
  QTest::keyClicks(at, "17");
  QTest::keyClick(at, Qt::Key_Return);
  QCOMPARE(s.at.workspace.time(), s.at.frame(17));
  at->selectAll();
  QTest::keyClicks(at, "2.5s");
  QTest::keyClick(at, Qt::Key_Return);
  QCOMPARE(s.at.workspace.time(), s.at.frame(61));
  QCOMPARE(at->text(), "61");
  s.panel.findChild<QToolButton*>("seconds")->click();
  QCOMPARE(at->text(), "2.500 s");
  at->selectAll();
  QTest::keyClicks(at, "1");
  QTest::keyClick(at, Qt::Key_Return);
  QCOMPARE(s.at.workspace.time(), s.at.frame(25));
}

void TimelineTest::the_keys_play_step_and_stop() {
  Shown s;
  const auto click = [&](const char* name) { s.panel.findChild<QToolButton*>(name)->click(); };
  click("end");
  QCOMPARE(s.at.workspace.time(), s.at.frame(100));
  click("back");
  QCOMPARE(s.at.workspace.time(), s.at.frame(99));
  click("begin"), click("on");
  QCOMPARE(s.at.workspace.time(), s.at.frame(2));
  click("play");
  QCOMPARE(s.at.workspace.playhead().direction(), 1);
  click("play_back");
  QCOMPARE(s.at.workspace.playhead().direction(), -1);
  click("play_back");
  QVERIFY(!s.at.workspace.playhead().playing());
  QVERIFY(s.at.workspace.playhead().loops());
  click("loop");
  QVERIFY(!s.at.workspace.playhead().loops());
}

void TimelineTest::a_note_is_dragged() {
  Shown s;
  drag(s.ruler, s.note(60), s.note(60) + QPoint(s.x(72) - s.x(60), 0));
  QCOMPARE(s.at.said, std::vector<std::string>{"move notes 60f..60f by 12f"});
  QVERIFY(
      s.at.is("rate 24\nrange 1f 100f\ncreate ball sphere\ncreate eye camera\nat 30f note \"up\"\n"
              "at 30f note \"and on\"\nat 72f note \"down\"\n"));
  s.at.workspace.undo();
  QVERIFY(s.at.is(film));
  QCOMPARE(s.at.workspace.text(), film);
}

void TimelineTest::the_ends_of_the_film_are_dragged() {
  Shown s;
  const int y = s.ruler.part_box().center().y();
  const auto pull = [&](double from, double to) { drag(s.ruler, {s.x(from), y}, {s.x(to), y}); };
  pull(100, 72);
  QCOMPARE(s.at.said, std::vector<std::string>{"range 1f 72f"});
  pull(1, 13);
  QCOMPARE(s.at.said.back(), "range 13f 72f");
  QVERIFY(s.at.workspace.text().find("range 13f 72f\n") != std::string::npos);
  QVERIFY(s.at.workspace.text().find("range 1f") == std::string::npos);
  pull(13, 90);  // no further than the other end
  QCOMPARE(s.at.said.back(), "range 72f 72f");
  for (int k = 0; k < 3; ++k) s.at.workspace.undo();
  QCOMPARE(s.at.workspace.text(), film);
  drag(s.ruler, {s.x(50), y}, {s.x(60), y});  // not at an end
  QVERIFY(!s.at.said.back().starts_with("range"));
}

// A WAV file of a second: silence, then a tone of full volume.
void TimelineTest::sounds_are_bars_with_their_loudness() {
  constexpr int rate = 8000;
  QTemporaryDir folder;
  QByteArray wav("RIFF\0\0\0\0WAVEfmt \20\0\0\0\1\0\1\0\x40\x1f\0\0\x80\x3e\0\0\2\0\20\0data\x80\x3e\0\0", 44);
  for (int i = 0; i < rate; ++i) {
    const auto v = static_cast<std::int16_t>(i < rate / 2 ? 0 : 32000 * std::sin(i * 0.5));
    wav.append(reinterpret_cast<const char*>(&v), 2);
  }
  const auto put = [&](const QString& name, const QByteArray& bytes) {
    QFile f(folder.filePath(name));
    QVERIFY(f.open(QIODevice::WriteOnly));
    f.write(bytes);
  };
  put("a.wav", wav);
  put("film.bx",
      "rate 24\nrange 1f 96f\ncreate one sound file=\"a.wav\" at=25f\ncreate two sound file=\"a.wav\" at=31f\n");
  Workspace workspace;
  QVERIFY(workspace.open(folder.filePath("film.bx")));
  Timeline panel(workspace);
  show(panel, 1000, 200);
  Ruler& ruler = *panel.findChild<Ruler*>("ruler");
  QCOMPARE(ruler.sounds().size(), std::size_t{2});
  const SoundBar& one = ruler.sounds()[0];
  const auto frame = [&](double n) { return workspace.document().rate().frame(n); };
  QCOMPARE(one.from, frame(25));
  QVERIFY(std::abs((one.to - frame(49)).seconds()) < 0.01);
  QCOMPARE(one.row, 0);
  QCOMPARE(ruler.sounds()[1].row, 1);  // they overlap
  QVERIFY(one.loudness(frame(26), frame(35)) < 0.01);
  const double loud = one.loudness(frame(40), frame(44));
  // A sine's root mean square, 3 dB lower because one channel goes to two.
  QVERIFY2(std::abs(loud - 32000 / 32768.0 / 2) < 0.02, std::to_string(loud).c_str());
  const QPoint at = ruler.sound_box(one).center().toPoint();
  drag(ruler, at, at + QPoint(static_cast<int>(std::lround(ruler.x_of(frame(37)) - ruler.x_of(frame(25)))), 0));
  QCOMPARE(workspace.selected(), std::vector{workspace.document().find("one")});
  QVERIFY2(workspace.text().find("create one sound file=\"a.wav\" at=1.5s\n") != std::string::npos,
           workspace.text().c_str());
  workspace.undo();
  // A short piece is heard where the playhead is dragged.
  studio::Sound sound(workspace);
  workspace.go_to(frame(40));
  QVERIFY(!sound.plays());
  sound.play_piece();
  QVERIFY(sound.plays());
  QVERIFY(QTest::qWaitFor([&] { return !sound.plays(); }, 2000));
}

namespace {

// `intro` is at 1f..25f. `proof` has 48 frames of its own at twice the speed: 25f..49f.
struct WithSections {
  Film at{R"(rate 24
range 1f 100f
create ball sphere
section intro for 24f
  at 1f ball.color red
section proof after intro speed=2  # the rest
  at 49f ball.radius 2
)"};
  Timeline panel{at.workspace};
  Ruler& ruler;
  WithSections() : ruler(*panel.findChild<Ruler*>("ruler")) { show(panel, 1000, 200); }
  QPoint place(std::size_t block, double frame) const {
    const QRectF box = ruler.section_box(ruler.sections()[block]);
    return {static_cast<int>(std::lround(ruler.x_of(at.frame(frame)))), static_cast<int>(box.center().y())};
  }
  bool has(const std::string& line) const { return at.workspace.text().find("\n" + line + "\n") != std::string::npos; }
};

}  // namespace

void TimelineTest::sections_are_blocks_that_are_dragged() {
  WithSections s;
  QCOMPARE(s.ruler.sections().size(), std::size_t{2});
  QCOMPARE(s.ruler.sections()[1].row, 0);
  QTest::mouseClick(&s.ruler, Qt::LeftButton, Qt::NoModifier, s.place(1, 40));
  QCOMPARE(s.at.workspace.time(), s.at.frame(25));
  QVERIFY(s.at.said.empty());  // a click changes nothing
  drag(s.ruler, s.place(1, 30), s.place(1, 42));
  QVERIFY2(s.has("section proof at 37f speed=2  # the rest"), s.at.workspace.text().c_str());
  QCOMPARE(s.ruler.sections()[1].section.end, s.at.frame(61));
  QVERIFY(s.ruler.accessibleDescription().contains("section proof from 37f to 61f"));
  s.at.workspace.undo();
  QVERIFY(s.has("section proof after intro speed=2  # the rest"));
  // The first one gets a beginning, and the one after it follows.
  drag(s.ruler, s.place(0, 10), s.place(0, 15));
  QVERIFY2(s.has("section intro at 6f for 24f"), s.at.workspace.text().c_str());
  QCOMPARE(s.ruler.sections()[1].section.begin, s.at.frame(30));
  // While it is held over another one, it overlaps; Escape puts it back.
  drag(s.ruler, s.place(1, 40), s.place(1, 20), Qt::NoModifier, true);
  QVERIFY(s.at.workspace.looks_ahead());
  QCOMPARE(s.ruler.sections()[1].section.begin, s.at.frame(10));
  QCOMPARE(s.ruler.sections()[1].row, 0);
  QTest::keyClick(&s.ruler, Qt::Key_Escape);
  QCOMPARE(s.ruler.sections()[1].section.begin, s.at.frame(30));
}

void TimelineTest::the_end_of_a_section_is_dragged() {
  WithSections s;
  const QPoint left(-2, 0);
  drag(s.ruler, s.place(1, 49) + left, s.place(1, 73) + left);  // twice as long
  QVERIFY2(s.has("section proof after intro speed=1  # the rest"), s.at.workspace.text().c_str());
  QCOMPARE(s.ruler.sections()[1].section.end, s.at.frame(73));
  drag(s.ruler, s.place(0, 25) + left, s.place(0, 37) + left);
  QVERIFY2(s.has("section intro for 36f"), s.at.workspace.text().c_str());
  QCOMPARE(s.ruler.sections()[1].section.begin, s.at.frame(37));
  drag(s.ruler, s.place(0, 37) + left, s.place(0, 1) + left);  // no length
  QVERIFY(s.has("section intro for 36f"));
}

// What looks like the line but is in a text, and lines that end as in Windows, stay as they are.
void TimelineTest::only_the_line_of_a_section_changes() {
  const std::string before =
      "rate 24\r\nrange 1f 100f\r\ncreate t text text=\"\"\"\r\nsection one\r\n\"\"\"\r\n"
      "create ball sphere\r\nsection one  for 24f speed = 2\r\n  at 1f ball.color red\r\n";
  Film at(before);
  Timeline panel(at.workspace);
  Ruler& ruler = *panel.findChild<Ruler*>("ruler");
  show(panel, 1000, 200);
  const auto box = [&] { return ruler.section_box(ruler.sections().at(0)); };
  const int frames = static_cast<int>(std::lround(ruler.x_of(at.frame(13)) - ruler.x_of(at.frame(1))));
  drag(ruler, box().center().toPoint(), box().center().toPoint() + QPoint(frames, 0));
  std::string after = before;
  after.replace(after.find("one  for"), 8, "one at 13f  for");
  QCOMPARE(QByteArray::fromStdString(at.workspace.text()).replace("\r", ""),
           QByteArray::fromStdString(after).replace("\r", ""));
  // A section of another file has no line here.
  std::ofstream(at.folder.path().toStdString() + "/part.bx") << "section two for 24f\n  at 1f ball.color blue\n";
  QVERIFY2(at.workspace.say(std::string("use \"part.bx\"")), at.workspace.last_said().c_str());
  QCOMPARE(ruler.sections().size(), std::size_t{2});
  const std::string used = at.workspace.text();
  const QPoint two = ruler.section_box(ruler.sections()[1]).center().toPoint();
  drag(ruler, two, two + QPoint(frames, 0));
  QCOMPARE(at.workspace.text(), used);
}

void TimelineTest::steps_are_marks_with_their_texts() {
  Film at(R"(rate 24
range 1f 100f
section one for 24f
  step "A first question" note="wait"
section two for 48f
  at 25f step "An answer"
)");
  Timeline panel(at.workspace);
  Ruler& ruler = *panel.findChild<Ruler*>("ruler");
  show(panel, 1000, 200);
  QCOMPARE(ruler.steps().size(), std::size_t{2});
  QVERIFY(ruler.step_box(0).top() >= ruler.section_box(ruler.sections()[0]).bottom());
  const QPoint second = ruler.step_box(1).center().toPoint(), first = ruler.step_box(0).center().toPoint();
  QTest::mouseClick(&ruler, Qt::LeftButton, Qt::NoModifier, second);
  QCOMPARE(at.workspace.time(), at.frame(49));  // 24 frames after the section's beginning at 25f
  QTest::mouseMove(&ruler, first);
  QTRY_VERIFY(ruler.toolTip().contains("A first question") && ruler.toolTip().contains("wait"));
  QVERIFY(ruler.accessibleDescription().contains("An answer"));
  // They can be dragged, deleted and named.
  const std::string before_edits = at.workspace.text();
  const int frames = static_cast<int>(std::lround(ruler.x_of(at.frame(13)) - ruler.x_of(at.frame(1))));
  drag(ruler, second, second + QPoint(frames, 0));
  QCOMPARE(ruler.steps()[1], (Pause{at.frame(61), "An answer", ""}));
  const QPoint there = ruler.step_box(1).center().toPoint();
  QTest::mouseClick(&ruler, Qt::LeftButton, Qt::NoModifier, there);
  QTest::keyClick(&ruler, Qt::Key_Delete);
  QCOMPARE(ruler.steps().size(), std::size_t{1});
  QTest::mouseDClick(&ruler, Qt::LeftButton, Qt::NoModifier, first);
  QLineEdit* const words = ruler.findChild<QLineEdit*>("note_words");
  QVERIFY(words && words->text() == "A first question");
  words->setText("Why?");
  QTest::keyClick(words, Qt::Key_Return);
  QCOMPARE(ruler.steps()[0], (Pause{at.frame(1), "Why?", "wait"}));
  for (int i = 0; i < 3; ++i) at.workspace.undo();
  QCOMPARE(at.workspace.text(), before_edits);
  // Without steps the lane is not there.
  const int before = ruler.sizeHint().height();
  QVERIFY(at.workspace.say(Session::rewrite_line(4, 4, "  # no step")));
  QVERIFY(at.workspace.say(Session::rewrite_line(6, 6, "  # no step")));
  QVERIFY(ruler.steps().empty() && ruler.sizeHint().height() < before);
}

// The sound begins at 25f and half a second into the file, so a word at second 1.5 of the file is at second 2.
void TimelineTest::words_are_below_their_sound() {
  QTemporaryDir folder;
  constexpr int samples = 4 * 8000;
  const auto number = [](std::uint32_t n) { return QByteArray(reinterpret_cast<const char*>(&n), 4); };
  const QByteArray wav = "RIFF" + number(36 + 2 * samples) + "WAVEfmt " + number(16) + QByteArray("\1\0\1\0", 4) +
                         number(8000) + number(16000) + QByteArray("\2\0\20\0", 4) + "data" + number(2 * samples) +
                         QByteArray(2 * samples, '\0');
  const auto put = [&](const QString& name, const QByteArray& bytes) {
    QFile f(folder.filePath(name));
    QVERIFY(f.open(QIODevice::WriteOnly));
    f.write(bytes);
  };
  put("a.wav", wav);
  put("a.words", "0.1 0.4 square\n0.6 0.9 The\n1.0 1.4 Square,\n1.5 1.9 and\n2.5 2.9 square.\n");
  put("film.bx",
      "rate 24\nrange 1f 121f\ncreate voice sound file=\"a.wav\" words=\"a.words\" at=25f from=0.5s\n"
      "create other sound file=\"a.wav\" at=31f\n");
  Workspace workspace;
  QVERIFY2(workspace.open(folder.filePath("film.bx")), workspace.last_said().c_str());
  Timeline panel(workspace);
  show(panel, 1000, 250);
  Ruler& ruler = *panel.findChild<Ruler*>("ruler");
  const SoundBar& voice = ruler.sounds()[0];
  QVERIFY(voice.words);
  QCOMPARE(voice.heard_words(), std::pair(std::size_t{1}, std::size_t{5}));
  QVERIFY(ruler.word_box(voice, 3).top() >= ruler.sound_box(voice).bottom());
  QVERIFY(ruler.word_box(voice, 3).bottom() <= ruler.sound_box(ruler.sounds()[1]).top());
  QTest::mouseClick(&ruler, Qt::LeftButton, Qt::NoModifier, ruler.word_box(voice, 3).center().toPoint());
  QVERIFY(std::abs(workspace.time().seconds() - 2) < 1e-6);
  const auto copied = [&](std::size_t word) {
    const QPoint at = ruler.word_box(ruler.sounds()[0], word).center().toPoint();
    QContextMenuEvent e(QContextMenuEvent::Mouse, at, ruler.mapToGlobal(at));
    QApplication::sendEvent(&ruler, &e);
    return QApplication::clipboard()->text();
  };
  QCOMPARE(copied(3), "voice:\"and\"");
  QCOMPARE(copied(2), "voice:\"Square\"");  // the one before is cut off
  QCOMPARE(copied(4), "voice:\"square\"#2");
  // The language means the same times.
  for (const std::size_t word : {1, 2, 3, 4}) {
    const Time at = ruler.sounds()[0].time_of_word(word);
    QVERIFY2(workspace.say("at " + copied(word).toStdString() + " note \"here\""), workspace.last_said().c_str());
    QCOMPARE(workspace.document().notes(at, at).size(), std::size_t{1});
  }
  QTest::mouseMove(&ruler, ruler.word_box(ruler.sounds()[0], 4).center().toPoint());
  QTRY_COMPARE(ruler.toolTip(), "voice:\"square\"#2");
}

void TimelineTest::what_is_called_off_changes_nothing() {
  Shown s;
  drag(s.ruler, s.note(60), s.note(60) + QPoint(100, 0), Qt::NoModifier, true);
  QVERIFY(s.at.workspace.looks_ahead());
  QTest::keyClick(&s.ruler, Qt::Key_Escape);
  QVERIFY(!s.at.workspace.looks_ahead());
  QTest::mouseRelease(&s.ruler, Qt::LeftButton, Qt::NoModifier, s.note(60) + QPoint(100, 0));
  QVERIFY(s.at.said.empty());
  QCOMPARE(s.at.workspace.text(), film);
}

void TimelineTest::a_double_click_writes_a_note() {
  Shown s;
  QTest::mouseDClick(&s.ruler, Qt::LeftButton, Qt::NoModifier, s.note(80));
  auto* words = s.ruler.findChild<QLineEdit*>("note_words");
  QVERIFY(words);
  QTest::keyClicks(words, "turns \"round\"");
  QTest::keyClick(words, Qt::Key_Return);
  QCOMPARE(s.at.said, std::vector<std::string>{R"(at 80f note "turns \"round\"")"});
  QVERIFY(s.at.is(film + "at 80f note \"turns \\\"round\\\"\"\n"));
}

void TimelineTest::a_note_of_several_gets_other_words() {
  Shown s;
  QTest::mouseDClick(&s.ruler, Qt::LeftButton, Qt::NoModifier, s.note(30));
  auto* words = s.ruler.findChild<QLineEdit*>("note_words");
  QCOMPARE(words->text(), "up");
  QTest::keyClicks(words, "high");
  QTest::keyClick(words, Qt::Key_Return);
  QCOMPARE(s.at.said, std::vector<std::string>{"clear notes 30f\nat 30f note \"high\"\nat 30f note \"and on\""});
  s.at.workspace.undo();
  QCOMPARE(s.at.workspace.text(), film);
}

void TimelineTest::delete_takes_a_note_out() {
  Shown s;
  QTest::mouseClick(&s.ruler, Qt::LeftButton, Qt::NoModifier, s.note(60));
  QTest::keyClick(&s.ruler, Qt::Key_Delete);
  QCOMPARE(s.at.said, std::vector<std::string>{"clear notes 60f"});
  QCOMPARE(s.at.workspace.document().notes(earliest_time, latest_time).size(), std::size_t(2));
}

void TimelineTest::alt_chooses_the_part_that_is_played() {
  Shown s;
  drag(s.ruler, {s.x(20), 5}, {s.x(40), 5}, Qt::AltModifier);
  QCOMPARE(s.at.workspace.playhead().first(), s.at.frame(20));
  QCOMPARE(s.at.workspace.playhead().last(), s.at.frame(40));
  QVERIFY(s.at.said.empty());
}

void TimelineTest::the_wheel_zooms_where_the_hand_is() {
  Shown s;
  const int x = s.x(50), before = s.x(60) - x;
  QWheelEvent wheel(QPointF(x, 5), s.ruler.mapToGlobal(QPointF(x, 5)), {}, {0, 240}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&s.ruler, &wheel);
  QVERIFY(std::abs(s.x(50) - x) <= 1);
  QVERIFY(s.x(60) - s.x(50) > before * 1.3);
}

QTEST_MAIN(TimelineTest)
#include "timeline_test.moc"
