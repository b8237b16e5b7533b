// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Pictures for windows: drafts while something moves, and whole pictures afterwards.
#include <QTest>

#include "betwixt/language.h"
#include "studio/viewport/picture_maker.h"

namespace betwixt::studio {

class PicturesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:

  void a_slow_picture_is_first_a_draft_and_then_whole() {
    const Document film = load_text("create ball sphere\nball.position.x\n  1f 0\n  24f 3\n", "a film").document;
    const Program program = Program::compile(film);
    RenderOptions options;
    options.width = 640, options.height = 360, options.style = "traced", options.samples = 16;
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
    QVERIFY(made[0].image.width() < 640);
    QVERIFY(whole_at(9));
    QCOMPARE(made.back().image, PictureMaker::make({program, at(9), options, {}}).image);
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::PicturesTest)
#include "pictures_test.moc"
