// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/course/film_chooser.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/templates.h"
#include "betwixt/language.h"
#include "studio/shell/example.h"
#include "studio/shell/text_of.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {
namespace {

constexpr int most_opened_last = 5;
constexpr QSize picture_size(320, 180);  // the size of the pictures, which are shown at the size of the text

std::vector<FilmTemplate> all_films() {
  const auto& rows = film_templates();
  std::vector<FilmTemplate> all(rows.begin(), rows.end());
  all.push_back(
      {"example", "Example", "a ball bounces into a hand, which carries it away and lets it go", example_film, 50});
  return all;
}

}  // namespace

FilmChooser::FilmChooser(const QStringList& opened_last, QWidget* parent)
    : QDialog(parent), films_(new QListWidget(this)), sentence_(new QLabel(this)) {
  setObjectName("film_chooser");
  setWindowTitle(tr("New film"));
  setAttribute(Qt::WA_DeleteOnClose);
  const int em = fontMetrics().height();
  films_->setObjectName("films");
  films_->setAccessibleName(tr("Films to begin with"));
  films_->setViewMode(QListView::IconMode);
  films_->setMovement(QListView::Static);
  films_->setResizeMode(QListView::Adjust);
  films_->setIconSize(QSize(16, 9) * (em * 2 / 3));
  films_->setGridSize(films_->iconSize() + QSize(em, 2 * em));
  films_->setSpacing(em / 2);
  for (const FilmTemplate& f : all_films()) {
    auto* item = new QListWidgetItem(text_of(f.title), films_);
    item->setToolTip(text_of(f.sentence));
  }
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(tr("Begin"), QDialogButtonBox::AcceptRole)->setToolTip(tr("begins with the marked film"));
  buttons->addButton(QDialogButtonBox::Cancel)->setToolTip(tr("leaves the film that is there (Escape)"));
  const auto other = [&](const char* name, const QString& words, const QString& tip, auto does) {
    QPushButton* button = buttons->addButton(words, QDialogButtonBox::ActionRole);
    button->setObjectName(name), button->setToolTip(tip), button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, [this, does] { close(), does(); });
  };
  other("nothing", tr("Empty script"), tr("begins with nothing at all"), [this] { emit chosen({}); });
  other("open", tr("Open…"), tr("opens a script that you have"), [this] { emit wants_file({}); });
  other("course", tr("Course"), tr("five exercises that show you how to animate"), [this] { emit wants_course(); });
  auto* column = new QVBoxLayout(this);
  column->addWidget(films_, 1), column->addWidget(sentence_);
  if (!opened_last.isEmpty()) column->addWidget(new QLabel(tr("Opened last:"), this));
  if (!opened_last.isEmpty()) column->addWidget(list_of(opened_last));
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(films_, &QListWidget::itemActivated, this, &QDialog::accept);
  connect(films_, &QListWidget::currentRowChanged, this, [this] {
    const QString words = films_->currentItem()->toolTip();
    sentence_->setText(words.left(1).toUpper() + words.mid(1) + ".");
  });
  connect(this, &QDialog::accepted, this, &FilmChooser::choose);
  connect(&pictures_, &SmallPictures::made, this, &FilmChooser::show_pictures);
  films_->setCurrentRow(0), films_->setFocus();
  const int below = opened_last.isEmpty() ? 0 : 2 * em + findChild<QListWidget*>("opened_last")->height();
  resize(5 * films_->gridSize().width() + 4 * em, 2 * films_->gridSize().height() + 6 * em + below);
  show_pictures();
}

// Returns a list of the first of these films; Enter or a click opens one.
QWidget* FilmChooser::list_of(const QStringList& files) {
  auto* list = new QListWidget(this);
  list->setObjectName("opened_last");
  list->setAccessibleName(tr("Films that were opened last"));
  for (const QString& file : files.mid(0, most_opened_last))
    (new QListWidgetItem(QFileInfo(file).fileName(), list))->setToolTip(file);
  const int row = fontMetrics().height() * 3 / 2;
  list->setFixedHeight(row * list->count() + 2 * list->frameWidth());
  for (int i = 0; i < list->count(); ++i) list->item(i)->setSizeHint({0, row});
  const auto open = [this](const QListWidgetItem* item) {
    const QString file = item->toolTip();
    close();
    emit wants_file(file);
  };
  connect(list, &QListWidget::itemActivated, this, open);
  connect(list, &QListWidget::itemClicked, this, open);
  return list;
}

bool FilmChooser::show_pictures() {
  int row = 0;
  bool all = true;
  for (const FilmTemplate& f : all_films()) {
    const std::string text(f.text);
    const std::optional<QImage> image = pictures_.picture(text_of(f.text), [text, frame = f.shown_frame] {
      return film_picture(load_text(text, "template").document, frame, picture_size);
    });
    QPixmap pixmap(films_->iconSize());
    pixmap.fill(colors().line);
    all = all && image;
    if (image && !image->isNull()) pixmap = QPixmap::fromImage(*image);
    films_->item(row++)->setIcon(pixmap);
  }
  return all;
}

void FilmChooser::await_pictures() {
  while (!show_pictures()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  QCoreApplication::processEvents();
}

void FilmChooser::choose() {
  emit chosen(std::string(all_films()[static_cast<std::size_t>(films_->currentRow())].text));
}

}  // namespace betwixt::studio
