// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/manual.h"

#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QHBoxLayout>
#include <QImage>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBlock>
#include <QVBoxLayout>

#include "studio/shell/text_size.h"

namespace betwixt::studio {
namespace {

constexpr const char* first_page = "studio.md";

// Returns the name by which links call a heading: "Text size and keyboard" is text-size-and-keyboard.
QString link_name(const QString& heading) {
  QString name;
  for (const QChar c : heading.toLower())
    if (c.isLetterOrNumber() || c == '-' || c == '_')
      name += c;
    else if (c == ' ')
      name += '-';
  return name;
}

}  // namespace

// As it is built, or as it is installed.
QString manual_folder() {
  const QDir here(QCoreApplication::applicationDirPath());
  for (const char* place : {"../../../docs", "../../share/doc/betwixt", "../share/doc/betwixt"})
    if (QFile::exists(here.filePath(QString(place) + "/" + first_page))) return QDir::cleanPath(here.filePath(place));
  return {};
}

ManualPage::ManualPage(QWidget* parent) : QTextBrowser(parent) {
  setObjectName("manual_page");
  setAccessibleName(tr("Manual"));
  setOpenLinks(false);
  connect(this, &QTextBrowser::anchorClicked, this, &ManualPage::go);
}

// Pages are shown here; all else is opened by the desktop.
void ManualPage::go(const QUrl& link) {
  const QUrl to = source().resolved(link);
  QUrl page = to;
  page.setFragment({});
  if (!page.path().endsWith(".md")) return (void)QDesktopServices::openUrl(to);
  if (page != source()) setSource(page, QTextDocument::MarkdownResource);
  if (to.hasFragment()) go_to_heading(to.fragment());
}

void ManualPage::go_to_heading(const QString& name) {
  for (QTextBlock b = document()->begin(); b.isValid(); b = b.next()) {
    if (b.blockFormat().headingLevel() == 0 || link_name(b.text()) != name) continue;
    setTextCursor(QTextCursor(b));
    verticalScrollBar()->setValue(verticalScrollBar()->value() + cursorRect().top());
    return;
  }
}

// Wide pictures fit the page.
QVariant ManualPage::loadResource(int type, const QUrl& name) {
  const QVariant loaded = QTextBrowser::loadResource(type, name);
  if (type != QTextDocument::ImageResource) return loaded;
  const QImage image = QImage::fromData(loaded.toByteArray());
  const int room = std::max(200, viewport()->width() - 4 * fontMetrics().height());
  return image.width() <= room ? image
                               : image.convertedTo(QImage::Format_ARGB32).scaledToWidth(room, Qt::SmoothTransformation);
}

Manual::Manual(const QString& folder, QWidget* parent)
    : QDialog(parent), page_(new ManualPage(this)), search_(new QLineEdit(this)) {
  setObjectName("manual");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Manual"));
  search_->setObjectName("manual_search");
  search_->setPlaceholderText(tr("words on this page"));
  const auto button = [&](const QString& words, const QString& tip, auto does) {
    auto* b = new QPushButton(words, this);
    b->setToolTip(tip), b->setAutoDefault(false);
    connect(b, &QPushButton::clicked, page_, does);
    return b;
  };
  const QUrl start = QUrl::fromLocalFile(QDir(folder).filePath(first_page));
  auto* back = button(tr("Back"), tr("goes to the page before"), [this] { page_->backward(); });
  auto* studio = button(tr("Studio"), tr("the page about the studio"), [this, start] { page_->go(start); });
  auto* language = button(tr("Language"), tr("the page about the language of scripts"),
                          [this, start] { page_->go(start.resolved(QUrl("language.md"))); });
  back->setEnabled(false);
  connect(page_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(search_, &QLineEdit::returnPressed, this, [this] { find(search_->text()); });
  auto* head = new QHBoxLayout;
  head->addWidget(back), head->addWidget(studio), head->addWidget(language), head->addWidget(search_, 1);
  auto* all = new QVBoxLayout(this);
  all->addLayout(head), all->addWidget(page_, 1);
  resize_on_screen(*this, QSize(56, 44) * fontMetrics().height());
  page_->go(start);
  page_->setFocus();
}

// From the cursor on, and from the beginning again.
void Manual::find(const QString& words) {
  if (words.isEmpty() || page_->find(words)) return;
  page_->moveCursor(QTextCursor::Start);
  page_->find(words);
}

}  // namespace betwixt::studio
