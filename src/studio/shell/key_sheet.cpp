// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/key_sheet.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPageSize>
#include <QPdfWriter>
#include <QPushButton>
#include <QSaveFile>
#include <QTextBrowser>
#include <QTextDocument>

#include "studio/shell/keys.h"
#include "studio/shell/keys_page.h"
#include "studio/shell/text_of.h"
#include "studio/shell/window.h"

namespace betwixt::studio {

QString key_sheet_html(const QString& letters) {
  const Keys& keys = Keys::of_user();
  QString html = "<html><head><meta charset='utf-8'><title>Betwixt</title></head><body><table cellpadding='4'>";
  const auto fits = [&](std::initializer_list<QString> words) {
    for (const QString& w : words)
      if (w.contains(letters.trimmed(), Qt::CaseInsensitive)) return true;
    return false;
  };
  const auto part = [&](const QString& title, auto belongs) {
    QString rows;
    for (const KeyRow& row : keys.rows()) {
      const QString shown = words_of_keys(keys.keys(row), QKeySequence::NativeText).replace("; ", "  ");
      if (!belongs(row) || !fits({title, shown, word_of(row.name), word_of(row.sentence)})) continue;
      const QString name = word_of(row.name).toHtmlEscaped();
      rows += "<tr><td><code>" + shown.toHtmlEscaped() + "</code></td><td>" +
              (keys.is_changed(row) ? name + " *" : name) + "</td><td>" + word_of(row.sentence).toHtmlEscaped() +
              "</td></tr>\n";
    }
    if (!rows.isEmpty()) html += "<tr><td colspan='3'><b>" + title.toHtmlEscaped() + "</b></td></tr>\n" + rows;
  };
  std::vector<std::string_view> menus;
  for (const KeyRow& row : keys.rows())
    if (!row.menu.empty() && std::ranges::find(menus, row.menu) == menus.end()) menus.push_back(row.menu);
  for (const std::string_view menu : menus) part(word_of(menu), [&](const KeyRow& row) { return row.menu == menu; });
  for (const KeyPlace& place : key_places())
    part(word_of(place.title), [&](const KeyRow& row) { return row.menu.empty() && row.place == place.name; });
  return html + "</table></body></html>";
}

KeySheet::KeySheet(Window& window) : QDialog(&window), search_(new QLineEdit(this)), page_(new QTextBrowser(this)) {
  setObjectName("key_sheet");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Keyboard"));
  search_->setObjectName("key_search");
  search_->setPlaceholderText(tr("part of an action, or a key"));
  page_->setAccessibleName(tr("Keyboard"));
  auto* save = new QPushButton(tr("Save to print…"), this);
  save->setToolTip(tr("Writes the list as a page (.html) or to print (.pdf)"));
  auto* change = new QPushButton(tr("Change keys…"), this);
  for (QPushButton* b : {save, change}) b->setAutoDefault(false);
  auto* head = new QHBoxLayout;
  head->addWidget(search_, 1), head->addWidget(new QLabel(tr("Preset"), this));
  head->addWidget(make_preset_box(this)), head->addWidget(save), head->addWidget(change);
  auto* all = new QVBoxLayout(this);
  all->addLayout(head), all->addWidget(page_, 1);
  const auto show = [this] { page_->setHtml(key_sheet_html(search_->text())); };
  connect(search_, &QLineEdit::textChanged, this, show);
  connect(&Keys::of_user(), &Keys::changed, this, show);
  connect(change, &QPushButton::clicked, this, [&window] { window.show_preferences("Keyboard"); });
  connect(save, &QPushButton::clicked, this, [this, &window] {
    const QString file =
        QFileDialog::getSaveFileName(this, tr("Save to print"), "betwixt-keys.pdf", tr("Pages (*.pdf *.html)"));
    if (file.isEmpty()) return;
    if (const QString why = write(file); !why.isEmpty()) emit window.workspace().said({}, why, true);
  });
  show();
  resize(60 * fontMetrics().height(), 40 * fontMetrics().height());
}

QString KeySheet::write(const QString& file) {
  const QString why = tr("'%1' cannot be written").arg(file);
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly)) return why;
  if (file.endsWith(".pdf", Qt::CaseInsensitive)) {
    QPdfWriter paper(&out);
    paper.setPageSize(QPageSize(QPageSize::A4));
    paper.setTitle(tr("Keyboard"));
    QTextDocument page;
    page.setHtml(key_sheet_html());
    page.print(&paper);
  } else {
    out.write(key_sheet_html().toUtf8());
  }
  return out.commit() ? QString() : why;
}

}  // namespace betwixt::studio
