// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <QComboBox>
#include <QLabel>
#include <QTableView>

#include "hands.h"
#include "studio/panels/data_panel.h"

using namespace betwixt;
using namespace betwixt::studio;

namespace {

const std::string film = R"(rate 24
data pop of """city,day,people
Tokyo,2026-11-01,28.5
London,2026-11-02,
Tokyo,2026-11-03,37.25""" key=city
data areas of """name,area
Bern,52
"""
)";

}  // namespace

class DataTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void the_tables_of_the_film_are_shown();
  void the_panel_follows_the_script();
  void a_long_table_shows_its_first_rows();
};

namespace {

struct Panel {
  Film at;
  DataPanel panel{at.workspace};
  QComboBox& names{*panel.findChild<QComboBox*>("data_names")};
  QTableView& rows{*panel.findChild<QTableView*>("data_rows")};
  explicit Panel(const std::string& text) : at(text) { show(panel, 400, 400); }
  QString cell(int row, int column) const { return rows.model()->index(row, column).data().toString(); }
  QString header(int column) const { return rows.model()->headerData(column, Qt::Horizontal).toString(); }
  QString about() const { return panel.findChild<QLabel*>("data_about")->text(); }
  QStringList all_names() const {
    QStringList all;
    for (int i = 0; i < names.count(); ++i) all += names.itemText(i);
    return all;
  }
};

}  // namespace

void DataTest::the_tables_of_the_film_are_shown() {
  Panel p(film);
  QCOMPARE(p.all_names(), QStringList({"areas", "pop"}));
  QCOMPARE(p.header(1), "area");
  QCOMPARE(p.cell(0, 1), "52");
  p.names.setCurrentText("pop");
  QCOMPARE(p.rows.model()->rowCount(), 3);
  QCOMPARE(p.rows.model()->columnCount(), 3);
  QCOMPARE(p.cell(0, 0), "Tokyo");
  QCOMPARE(p.cell(2, 1), "2026-11-03");
  QCOMPARE(p.cell(2, 2), "37.25");
  QCOMPARE(p.cell(1, 2), "");  // no value
  QVERIFY2(p.about().contains("3 rows, 3 columns") && p.about().contains("2 keys in city: Tokyo, London"),
           p.about().toUtf8());
  QVERIFY(!(p.rows.model()->flags(p.rows.model()->index(0, 0)) & Qt::ItemIsEditable));
  QCOMPARE(p.rows.model()->headerData(2, Qt::Horizontal, Qt::ToolTipRole).toString(), "pop.people: numbers");
  QVERIFY(!p.names.accessibleName().isEmpty() && !p.rows.accessibleName().isEmpty());
}

void DataTest::the_panel_follows_the_script() {
  Panel p(film);
  p.names.setCurrentText("pop");
  QVERIFY(p.at.workspace.say(Session::rewrite_line(3, 3, "Oslo,2026-11-01,0.7")));
  QCOMPARE(p.names.currentText(), "pop");
  QCOMPARE(p.cell(0, 0), "Oslo");
  QVERIFY(p.at.workspace.say(Session::rewrite_line(1, 8, "rate 24")));
  QVERIFY(p.rows.model()->rowCount() == 0 && !p.names.isVisible());
  QVERIFY(p.about().contains("no tables"));
  p.at.workspace.undo();
  QVERIFY(p.names.isVisible() && p.rows.model()->rowCount() > 0);
}

void DataTest::a_long_table_shows_its_first_rows() {
  std::string text = "data many of \"\"\"n\n";
  for (int i = 1; i <= 10'500; ++i) text += std::to_string(i) + "\n";
  Panel p(text + "\"\"\"\n");
  QCOMPARE(p.rows.model()->rowCount(), 10'000);
  QCOMPARE(p.cell(9'999, 0), "10000");
  QVERIFY(p.about().contains("10500 rows") && p.about().contains("first 10000"));
}

QTEST_MAIN(DataTest)
#include "data_test.moc"
