// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures for windows: drafts while something moves, and whole pictures afterwards.
#include <QTest>

#include "betwixt/language.h"
#include "studio/hands.h"
#include "studio/viewport/viewport.h"

namespace betwixt::studio {

class PicturesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:

  void a_slow_picture_is_first_a_draft_and_then_whole() {
    const Document film = load_text("create ball sphere\nball.position.x\n  1f 0\n  24f 3\n", "a film").document;
    const Program program = Program::compile(film);
    RenderOptions options;
    options.width = 480, options.height = 270, options.style = "traced", options.samples = 16;
    std::vector<PictureMade> made;
    PictureMaker maker;
    connect(
        &maker, &PictureMaker::made, this, [&](const PictureMade& m) { made.push_back(m); }, Qt::QueuedConnection);
    const auto at = [&](int frame) { return film.rate().frame(frame); };
    const auto whole_at = [&](int frame) {
      return QTest::qWaitFor([&] { return !made.empty() && !made.back().draft && made.back().time == at(frame); },
                             30'000);
    };
    maker.want({program, at(1), options, {}, {}, false});  // shows how long a picture takes
    QVERIFY(whole_at(1));
    made.clear();
    maker.want({program, at(9), options, {}, {}, true});
    QVERIFY(QTest::qWaitFor([&] { return !made.empty(); }, 30'000));
    QVERIFY(made[0].draft);
    QVERIFY(made[0].image.width() < 480);
    QVERIFY(whole_at(9));
    QCOMPARE(made.back().image, PictureMaker::make({program, at(9), options, {}}).image);
  }

  void pictures_that_were_made_are_kept() {
    Film f("range 1f 8f\nsize 320x180\ncreate ball sphere\nball.position.x\n  1f 0\n  8f 3\n");
    const std::string before = f.workspace.text();
    Viewport view(f.workspace);
    show(view, 320, 180);
    int synchronous = 0;
    bool inside = false;
    connect(&view, &Viewport::picture_came, this, [&](const PictureMade& m) {
      if (inside && m.time == f.workspace.time()) ++synchronous;
    });
    view.fill_memory();
    QVERIFY(QTest::qWaitFor([&] { return f.workspace.playhead().playing(); }, 30'000));
    QCOMPARE(f.workspace.kept().size(), std::size_t{8});
    QVERIFY(f.workspace.kept().front().time == f.frame(1) && f.workspace.kept().back().time == f.frame(8));
    f.workspace.pause();
    for (int n = 1; n <= 8; ++n) {  // each is there at once
      f.workspace.go_to(f.frame(n == 8 ? 1 : n + 1));
      synchronous = 0, inside = true;
      f.workspace.go_to(f.frame(n));
      inside = false;
      QCOMPARE(synchronous, 1);
    }
    // It is the picture that would be made.
    QImage last;
    connect(&view, &Viewport::picture_came, this, [&](const PictureMade& m) { last = m.image; });
    f.workspace.go_to(f.frame(5));
    const QImage kept = last;
    view.await_picture();
    QCOMPARE(kept, last);
    f.workspace.say(std::string("note \"an edit\""));
    f.workspace.say(std::string("set ball.radius 0.4"));
    QVERIFY(QTest::qWaitFor([&] { return f.workspace.kept().size() < 8; }));
    f.workspace.undo();
    view.resize(300, 170);
    QVERIFY(QTest::qWaitFor([&] { return f.workspace.kept().size() <= 1; }));
    view.fill_memory();
    f.workspace.go_to(f.frame(3));  // somebody moves the playhead
    QVERIFY(!view.fills_memory());
    QCOMPARE(f.workspace.text(), before);
  }

  void memory_for_pictures_is_bounded() {
    const Program program = Program::compile(Document());
    KeptPictures kept;
    kept.use({program, {}, {}, {}, {}});
    PictureMade big;
    big.image = QImage(8192, 4096, QImage::Format_RGB32);  // 128 MiB
    for (int i = 0; i < 4; ++i) {
      big.time = from_seconds(i);
      QVERIFY(kept.keep(big));
    }
    big.time = from_seconds(4);
    QVERIFY(!kept.keep(big));
    QCOMPARE(kept.list().size(), std::size_t{4});
    big.time = from_seconds(2), big.draft = true;
    QVERIFY(kept.keep(big));
    QVERIFY(!kept.at(from_seconds(2))->draft);
    QVERIFY(!kept.use({program, {}, {}, {}, {}}));
    RenderOptions other;
    other.width = 100;
    QVERIFY(kept.use({program, other, {}, {}, {}}));
    QVERIFY(kept.empty());
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::PicturesTest)
#include "pictures_test.moc"
