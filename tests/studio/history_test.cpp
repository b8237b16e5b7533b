// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the list of steps: a click on one leads to the film after it.
#include <QTest>

#include "studio/film.h"
#include "studio/panels/history_panel.h"

namespace betwixt::studio {

class HistoryTest : public QObject {
  Q_OBJECT

  struct Shown : Film {
    HistoryPanel panel{workspace};
    explicit Shown(const QByteArray& text) : Film(text) {
      panel.resize(300, 400);
      panel.show();
      if (!QTest::qWaitForWindowActive(&panel)) qFatal("no window");
    }
    QStringList rows() const {
      QStringList all;
      for (int i = 0; i < panel.count(); ++i) all.push_back(panel.item(i)->text());
      return all;
    }
    void click(int row) {
      QTest::mouseClick(panel.viewport(), Qt::LeftButton, {}, panel.visualItemRect(panel.item(row)).center());
    }
  };

 private Q_SLOTS:
  void a_click_goes_to_any_step() {
    Shown s("create ball sphere\n");
    QStringList texts{s.text()};
    const auto say = [&](const std::vector<std::string>& lines) {
      lines.size() == 1 ? s.workspace.say(lines[0]) : s.workspace.say(lines);
      texts.push_back(s.text());
    };
    say({"set ball.radius 2"});
    say({"create box1 box", "create box2 box"});
    say({"set ball.color red"});
    s.workspace.retype(s.workspace.text() + "set ball.radius 3\n");
    s.workspace.settle_typing();
    texts.push_back(s.text());
    QCOMPARE(s.rows(), (QStringList{"the film as it was opened", "set ball.radius 2", "create box1 box and 1 more",
                                    "set ball.color red", "typed: 6..5"}));
    QCOMPARE(s.panel.currentRow(), 4);
    for (const int row : {1, 3, 0, 4, 2, 4}) {
      s.click(row);
      QCOMPARE(s.text(), texts[row]);
      QCOMPARE(s.panel.currentRow(), row);
      QCOMPARE(s.panel.count(), 5);
    }
    s.click(2);
    s.workspace.say(std::string("set ball.color blue"));  // ends what was undone
    QCOMPARE(s.panel.count(), 4);
    QCOMPARE(s.panel.currentRow(), 3);
  }

  void a_hidden_list_costs_nothing_and_is_right_when_shown() {
    Shown s("create ball sphere\n");
    s.panel.hide();
    for (int k = 0; k < 1100; ++k) s.workspace.say("set ball.radius " + std::to_string(k + 1));
    QCOMPARE(s.panel.count(), 1);
    s.panel.show();
    QCOMPARE(s.panel.count(), 1001);
    QCOMPARE(s.rows().back(), "set ball.radius 1100");
    s.click(s.panel.count() - 3);
    QCOMPARE(s.radius("ball"), 1098.0);
  }
};

}  // namespace betwixt::studio

QTEST_MAIN(betwixt::studio::HistoryTest)
#include "history_test.moc"
