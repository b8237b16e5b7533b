// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/assets/asset_panel.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPainter>
#include <QTabWidget>
#include <QTimer>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>
#include <tuple>

#include "betwixt/language.h"
#include "scene/colors.h"
#include "studio/assets/look_lines.h"
#include "studio/shell/scrolled.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/shell/theme.h"
#include "studio/viewport/kind_icons.h"

namespace betwixt::studio {
namespace {

constexpr QSize thumbnail_size(128, 96);
constexpr qsizetype most_watched = 100;  // folders

QPixmap framed(const QImage& image, QSize size) {
  QPixmap out(size);
  out.fill(Qt::transparent);
  QPainter p(&out);
  const QSize fits = image.size().scaled(size, Qt::KeepAspectRatio);
  p.setRenderHint(QPainter::SmoothPixmapTransform);
  p.drawImage(QRect(QPoint((size.width() - fits.width()) / 2, (size.height() - fits.height()) / 2), fits), image);
  return out;
}

QIcon icon_of(AssetSort sort) {
  const Kind kind = sort == AssetSort::sound     ? Kind::sound
                    : sort == AssetSort::picture ? Kind::plane
                    : sort == AssetSort::video   ? Kind::video
                    : sort == AssetSort::film    ? Kind::camera
                    : sort == AssetSort::pose    ? Kind::group
                                                 : Kind::mesh;
  return kind_icon(kind);
}

// Returns the words of the function `material`, and a film that shows one of them.
std::vector<std::string> materials() {
  const Document d = load_text("create s sphere\n", "looks").document;
  std::vector<std::string> all;
  for (const FunctionView& f : functions(d, d.find("s")))
    if (f.name == "material")
      for (const QString& word : text_of(f.words).split('|')) all.push_back(word.toStdString());
  return all;
}
std::string film_of_material(const std::string& material) {
  const bool plain = material == "plastic" || material == "matte" || material == "metal" || material == "glow";
  return "background transparent\ncreate s sphere " + std::string(plain ? "color=#d8a13a " : "") +
         "material=" + material +
         "\ncreate sun light shines=sun position=(-3 5 6)\ncreate eye camera position=(0 0 3.1) look-at=(0 0 0)\n";
}

// Greys first, then the colours by hue.
std::vector<std::string_view> colors_by_hue() {
  std::vector<std::string_view> all = color_names();
  const auto place = [](std::string_view name) {
    const QColor c = QColor::fromRgb(*named_color(name));
    const bool grey = c.hslSaturation() < 20;
    return std::tuple(!grey, grey ? 0 : c.hslHue() / 15, c.lightness());
  };
  std::ranges::stable_sort(all, {}, place);
  return all;
}

}  // namespace

AssetList::AssetList(QWidget* parent) : QListWidget(parent) {
  setViewMode(QListView::IconMode);
  setMovement(QListView::Static);
  setResizeMode(QListView::Adjust);
  setDragEnabled(true), setDragDropMode(QAbstractItemView::DragOnly);
  setFrameShape(QFrame::NoFrame);
  setTextElideMode(Qt::ElideMiddle);
  setUniformItemSizes(true);
  const int em = fontMetrics().height();
  setIconSize(QSize(4, 3) * em);
  setGridSize(iconSize() + QSize(em, 2 * em));
}

QMimeData* AssetList::mimeData(const QList<QListWidgetItem*>& items) const {
  auto* data = new QMimeData;
  QList<QUrl> urls;
  for (const QListWidgetItem* item : items) {
    if (const QString name = item->data(file).toString(); !name.isEmpty()) urls << QUrl::fromLocalFile(name);
    if (const QString words = item->data(look).toString(); !words.isEmpty()) data->setData(look_data, words.toUtf8());
  }
  if (!urls.isEmpty()) data->setUrls(urls);
  return data;
}

void AssetList::show_only(const QString& part) {
  for (int i = 0; i < count(); ++i) item(i)->setHidden(!item(i)->toolTip().contains(part, Qt::CaseInsensitive));
  emit view_changed();
}

void AssetList::scrollContentsBy(int dx, int dy) {
  QListWidget::scrollContentsBy(dx, dy);
  emit view_changed();
}
void AssetList::resizeEvent(QResizeEvent* e) {
  QListWidget::resizeEvent(e);
  emit view_changed();
}

AssetPanel::AssetPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      search_(new QLineEdit(this)),
      tabs_(new QTabWidget(this)),
      files_(new AssetList(this)),
      looks_(new AssetList(this)),
      state_(new QLabel(this)) {
  setObjectName("assets");
  setWindowTitle(tr("Assets"));
  files_->setObjectName("asset_files"), files_->setAccessibleName(tr("Files"));
  looks_->setObjectName("asset_looks"), looks_->setAccessibleName(tr("Materials"));
  search_->setObjectName("asset_search");
  search_->setPlaceholderText(tr("part of a name"));
  search_->setClearButtonEnabled(true);
  auto* again = new QToolButton(this);
  again->setObjectName("asset_again"), again->setText("↻"), again->setAutoRaise(true);
  again->setFocusPolicy(Qt::TabFocus);
  again->setToolTip(tr("Looks for files in the film's folder again"));
  auto* head = new QHBoxLayout;
  head->setContentsMargins(4, 2, 4, 2);
  head->addWidget(search_, 1), head->addWidget(again);
  auto* page = new QWidget(this);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0), column->setSpacing(0);
  says_ = new Scrolled(state_, Qt::Vertical, this);
  says_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  column->addWidget(files_, 1), column->addWidget(says_);
  state_->setWordWrap(true), state_->setMargin(4), state_->setTextFormat(Qt::PlainText);
  tabs_->setDocumentMode(true), tabs_->addTab(page, tr("Files")), tabs_->addTab(looks_, tr("Materials"));
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0), all->setSpacing(0);
  all->addLayout(head), all->addWidget(tabs_, 1);
  add_looks();
  connect(search_, &QLineEdit::textChanged, this,
          [this](const QString& part) { files_->show_only(part), looks_->show_only(part); });
  connect(again, &QToolButton::clicked, this, &AssetPanel::scan);
  settles_.setSingleShot(true), settles_.setInterval(200);
  connect(&settles_, &QTimer::timeout, this, &AssetPanel::scan);
  connect(&watcher_, &QFileSystemWatcher::directoryChanged, &settles_, QOverload<>::of(&QTimer::start));
  connect(&scan_, &FolderScan::over, this, &AssetPanel::list);
  connect(&pictures_, &SmallPictures::made, this, &AssetPanel::show_pictures);
  for (AssetList* l : {files_, looks_})
    measure_by_text(*l, [l] { l->setMinimumHeight(2 * l->fontMetrics().height()); });
  for (AssetList* l : {files_, looks_})
    connect(l, &AssetList::view_changed, this, &AssetPanel::show_pictures, Qt::QueuedConnection);
  connect(tabs_, &QTabWidget::currentChanged, this, &AssetPanel::show_pictures);
  connect(files_, &QListWidget::itemActivated, this,
          [this](QListWidgetItem* item) { emit chosen(item->data(AssetList::file).toString()); });
  connect(looks_, &QListWidget::itemActivated, this,
          [this](QListWidgetItem* item) { give_look(item->data(AssetList::look).toString()); });
  connect(&workspace, &Workspace::opened, this, &AssetPanel::scan);
  connect(&workspace, &Workspace::named, this, &AssetPanel::scan);
}

void AssetPanel::showEvent(QShowEvent* e) {
  QWidget::showEvent(e);
  scan();
}

void AssetPanel::scan() {
  if (!isVisible()) return;
  const std::string& script = workspace_.session().file();
  folder_ = script.empty() ? QDir::currentPath() : QFileInfo(text_of(script)).absolutePath();
  if (listed_.isEmpty()) state_->setText(tr("looking in %1 …").arg(folder_));
  if (!watcher_.directories().contains(folder_)) watcher_.addPath(folder_);  // also while it is read
  scan_.begin(folder_);
}

// Watches the folder, those in it, and those in which files were found: the panel follows what other programs do there.
void AssetPanel::watch(const QStringList& files) {
  QStringList folders{folder_};
  for (const QString& name : QDir(folder_).entryList(QDir::Dirs | QDir::NoDotAndDotDot))
    folders << folder_ + "/" + name;
  for (const QString& file : files)
    if (const QString in = QFileInfo(file).absolutePath(); !folders.contains(in)) folders << in;
  folders = folders.mid(0, most_watched);
  QStringList gone = watcher_.directories();
  QStringList more = folders;
  for (const QString& folder : folders) gone.removeAll(folder);
  for (const QString& folder : watcher_.directories()) more.removeAll(folder);
  if (!gone.isEmpty()) watcher_.removePaths(gone);
  if (!more.isEmpty()) watcher_.addPaths(more);
}

void AssetPanel::list(const QStringList& files) {
  watch(files);
  const QString now = workspace_.session().file().empty() ? QString() : text_of(workspace_.session().file());
  if (files_->count() > 0 && listed_ == files + QStringList{now}) return show_pictures();
  listed_ = files + QStringList{now};
  files_->clear();
  const QString script = QFileInfo(text_of(workspace_.session().file())).absoluteFilePath();
  for (const QString& name : files) {
    if (name == script) continue;
    const QFileInfo info(name);
    const bool pose = asset_sort(name) == AssetSort::pose;
    auto* item =
        new QListWidgetItem(icon_of(asset_sort(name)), pose ? info.completeBaseName() : info.fileName(), files_);
    item->setData(AssetList::file, name);
    item->setToolTip(pose ? tr("pose %1: a double click gives it to the selection").arg(info.completeBaseName())
                          : QDir(folder_).relativeFilePath(name));
  }
  files_->show_only(search_->text());
  state_->setText(files_->count() == 0
                      ? tr("There are no pictures, meshes, scenes, sounds or scripts in %1.").arg(folder_)
                  : scan_.is_full() ? tr("There are more files in %1.").arg(folder_)
                                    : QString());
  says_->setVisible(!state_->text().isEmpty());
}

void AssetPanel::add_looks() {
  for (const std::string& word : materials()) {
    auto* item = new QListWidgetItem(text_of(word), looks_);
    item->setData(AssetList::look, text_of("material " + word));
    item->setToolTip(tr("material %1: drag it onto an object").arg(text_of(word)));
  }
  for (const std::string_view name : colors_by_hue()) {
    QPixmap pix(looks_->iconSize());
    pix.fill(QColor::fromRgb(*named_color(name)));
    auto* item = new QListWidgetItem(QIcon(pix), text_of(name), looks_);
    item->setData(AssetList::look, "color " + text_of(name));
    item->setToolTip(tr("color %1: drag it onto an object").arg(text_of(name)));
  }
}

// Asks for the pictures that are in view, and shows those that are made.
void AssetPanel::show_pictures() {
  if (!isVisible()) return;
  pictures_.want_none();
  AssetList* const list = tabs_->currentIndex() == 0 ? files_ : looks_;
  for (int i = 0; i < list->count(); ++i) {
    QListWidgetItem* item = list->item(i);
    if (item->isHidden() || !list->viewport()->rect().intersects(list->visualItemRect(item))) continue;
    std::optional<QImage> image;
    if (const QString file = item->data(AssetList::file).toString(); !file.isEmpty()) {
      const QFileInfo info(file);
      const QString key = QString("%1 %2 %3").arg(file).arg(info.size()).arg(info.lastModified().toMSecsSinceEpoch());
      image = pictures_.picture(key, [file] { return asset_picture(file, thumbnail_size); });
    } else if (const QString look = item->data(AssetList::look).toString(); look.startsWith("material ")) {
      const std::string text = film_of_material(look.section(' ', 1).toStdString());
      image = pictures_.picture(text_of(text),
                                [text] { return film_picture(load_text(text, "looks").document, 1, thumbnail_size); });
    }
    if (image && !image->isNull()) item->setIcon(framed(*image, list->iconSize()));
  }
}

void AssetPanel::give_look(const QString& look) {
  workspace_.say(look_lines(workspace_.document(), workspace_.selected(), look.toStdString(), workspace_.time(),
                            workspace_.makes_events()));
}

}  // namespace betwixt::studio
