// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/export_dialog.h"

#include <QCheckBox>
#include <QCloseEvent>
#include <QComboBox>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QUrl>
#include <QVBoxLayout>
#include <csignal>
#include <utility>

#include "betwixt/render.h"
#include "scene/pixel_filter.h"
#include "studio/shell/scrolled.h"
#include "studio/shell/text_of.h"

namespace betwixt::studio {
namespace {

constexpr const char* kept_settings = "render_settings";

// Quotes a word for a shell.
QString quoted(const QString& s) {
  static const QRegularExpression plain("^[A-Za-z0-9_./:%=+@,-]+$");
  return plain.match(s).hasMatch() ? s : "'" + QString(s).replace("'", "'\\''") + "'";
}

// Returns the program that makes films: beside the studio, as it is built, or in ../../bin, as it is installed.
QString program_beside() {
  const QDir here(QCoreApplication::applicationDirPath());
  for (const char* place : {"betwixt", "../../bin/betwixt", "../bin/betwixt"})
    if (QFileInfo(here.filePath(place)).isExecutable()) return here.filePath(place);
  return "betwixt";  // that of PATH
}

}  // namespace

ExportDialog::ExportDialog(Workspace& workspace, QWidget* parent) : QDialog(parent), workspace_(workspace) {
  setObjectName("export");
  setWindowTitle(tr("Render film"));
  auto* form = new QFormLayout;
  const QFileInfo script(QString::fromStdString(workspace.session().file()));
  const QString base = script.completeBaseName().isEmpty() ? "film" : script.completeBaseName();
  out_ = new QLineEdit(QDir::cleanPath(QDir(script.path()).filePath(base + ".mp4")));
  out_->setObjectName("out");
  out_->setToolTip(tr(".mp4 .webm .mov .gif .apng, or numbered pictures: frame-%04d.png, .exr"));
  auto* choose = new QPushButton(tr("…"));
  auto* place = new QHBoxLayout;
  place->addWidget(out_), place->addWidget(choose);
  form->addRow(tr("Film"), place);
  frames_ = new QLineEdit;
  frames_->setPlaceholderText(tr("all: %1..%2")
                                  .arg(QString::fromStdString(workspace.when(workspace.document().range().first)),
                                       QString::fromStdString(workspace.when(workspace.document().range().second))));
  const Playhead& t = workspace.playhead();
  if (std::pair(t.first(), t.last()) != workspace.document().range())
    frames_->setText(QString::fromStdString(workspace.when(t.first()) + ".." + workspace.when(t.last())));
  form->addRow(tr("Frames"), frames_);
  size_ = new QComboBox;
  size_->setEditable(true);
  const auto pixels = workspace.document().size();
  size_->addItem(pixels ? tr("as in the script: %1x%2").arg(pixels->first).arg(pixels->second) : tr("1280x720"));
  for (const char* s : {"640x360", "1920x1080", "2560x1440", "3840x2160", "1080x1080", "1080x1920"}) size_->addItem(s);
  form->addRow(tr("Size"), size_);
  style_ = new QComboBox;
  for (const Style& s : styles()) style_->addItem(text_of(s.name));
  form->addRow(tr("Style"), style_);
  filter_ = new QComboBox;
  filter_->addItem(tr("default"));
  for (const PixelFilter& f : pixel_filters()) filter_->addItem(text_of(f.name));
  samples_ = new QSpinBox;
  samples_->setRange(0, 4096), samples_->setSpecialValueText(tr("default"));
  form->addRow(tr("Samples per pixel"), samples_);
  form->addRow(tr("Pixel filter"), filter_);
  subframes_ = new QSpinBox;
  subframes_->setRange(0, 4096), subframes_->setSpecialValueText(tr("as in the script"));
  subframes_->setToolTip(tr("the number of subframes that are averaged for motion blur and depth of field"));
  form->addRow(tr("Subframes"), subframes_);
  open_ = new QCheckBox(tr("open the film when it is finished"));
  form->addRow({}, open_);
  command_ = new QLabel;
  command_->setObjectName("command");
  command_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  command_->setWordWrap(true);
  QFont fixed("monospace");
  fixed.setStyleHint(QFont::Monospace);
  command_->setFont(fixed);
  auto* command = new Scrolled(command_, Qt::Vertical);
  command->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  form->addRow(tr("Command"), command);
  progress_ = new QProgressBar;
  progress_->setVisible(false);
  state_ = new QLabel;
  for (QLabel* l : {command_, state_}) l->setTextFormat(Qt::PlainText);
  state_->setObjectName("state");
  state_->setWordWrap(true);
  start_ = new QPushButton(tr("Render"));
  start_->setObjectName("start"), start_->setDefault(true);
  cancel_ = new QPushButton(tr("Close"));
  cancel_->setObjectName("cancel");
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(state_, 1), buttons->addWidget(start_), buttons->addWidget(cancel_);
  auto* all = new QVBoxLayout(this);
  all->addLayout(form), all->addWidget(progress_), all->addLayout(buttons);
  setMinimumWidth(40 * fontMetrics().height());
  recall();

  connect(choose, &QPushButton::clicked, this, [this] {
    const QString to = QFileDialog::getSaveFileName(this, tr("Render film"), out_->text());
    if (!to.isEmpty()) out_->setText(to);
  });
  for (QLineEdit* e : {out_, frames_}) connect(e, &QLineEdit::textChanged, this, &ExportDialog::show_command);
  for (QComboBox* c : {size_, style_, filter_})
    connect(c, &QComboBox::currentTextChanged, this, &ExportDialog::show_command);
  for (QSpinBox* s : {samples_, subframes_}) connect(s, &QSpinBox::valueChanged, this, &ExportDialog::show_command);
  connect(open_, &QCheckBox::toggled, this, &ExportDialog::keep);
  connect(start_, &QPushButton::clicked, this, &ExportDialog::start);
  connect(cancel_, &QPushButton::clicked, this,
          [this] { running() ? (void)::kill(static_cast<pid_t>(process_.processId()), SIGINT) : (void)close(); });
  process_.setProcessChannelMode(QProcess::MergedChannels);
  connect(&process_, &QProcess::readyRead, this, &ExportDialog::read);
  connect(&process_, &QProcess::finished, this, [this](int code) { finish(code); });
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError e) {
    if (e == QProcess::FailedToStart) state_->setText(tr("Cannot start the program betwixt.")), finish(3);
  });
  show_command();
}

QStringList ExportDialog::arguments(const QString& script) const {
  QStringList all{"render", script, "-o", out_->text()};
  if (!frames_->text().isEmpty()) all << "--frames" << frames_->text();
  static const QRegularExpression pixels("^\\d+x\\d+$");
  if (pixels.match(size_->currentText()).hasMatch())
    if (size_->currentText() != "1280x720" || workspace_.document().size()) all << "--size" << size_->currentText();
  if (style_->currentIndex() != 0) all << "--style" << style_->currentText();
  if (filter_->currentIndex() > 0) all << "--pixel-filter" << filter_->currentText();
  if (samples_->value() > 0) all << "--samples" << QString::number(samples_->value());
  if (subframes_->value() > 0) all << "--subframes" << QString::number(subframes_->value());
  return all;
}

QString ExportDialog::script_name() const {
  const QString file = QString::fromStdString(workspace_.session().file());
  return file.isEmpty() ? "film.bx" : file;
}

QString ExportDialog::command() const {
  QStringList words{"betwixt"};
  for (const QString& a : arguments(script_name())) words << quoted(a);
  return words.join(' ');
}

void ExportDialog::show_command() {
  command_->setText(command());
  keep();
}

// The workspace is that of the film, and lasts as long as its tab.
void ExportDialog::keep() {
  QVariantMap kept{{"film", workspace_.session().file().c_str()},
                   {"out", out_->text()},
                   {"frames", frames_->text()},
                   {"size", size_->currentText() == size_->itemText(0) ? QString() : size_->currentText()},
                   {"style", style_->currentIndex()},
                   {"filter", filter_->currentIndex()},
                   {"samples", samples_->value()},
                   {"subframes", subframes_->value()},
                   {"open", open_->isChecked()}};
  workspace_.setProperty(kept_settings, kept);
}

// Shows the settings of the last time. A play range that is set now comes before the frames of then.
void ExportDialog::recall() {
  const QVariantMap kept = workspace_.property(kept_settings).toMap();
  if (kept.isEmpty() || kept["film"].toString() != text_of(workspace_.session().file())) return;
  out_->setText(kept["out"].toString());
  if (frames_->text().isEmpty()) frames_->setText(kept["frames"].toString());
  if (const QString size = kept["size"].toString(); !size.isEmpty()) size_->setCurrentText(size);
  style_->setCurrentIndex(kept["style"].toInt()), filter_->setCurrentIndex(kept["filter"].toInt());
  samples_->setValue(kept["samples"].toInt()), subframes_->setValue(kept["subframes"].toInt());
  open_->setChecked(kept["open"].toBool());
}

// Unsaved changes are rendered, too: the text goes to a temporary file beside the script.
void ExportDialog::start() {
  if (running()) return;
  const QDir folder = QFileInfo(script_name()).absoluteDir();
  text_ = std::make_unique<QTemporaryFile>(folder.filePath(".betwixt-film-XXXXXX.bx"));
  const std::string& text = workspace_.text();
  const auto size = static_cast<qint64>(text.size());
  if (!text_->open() || text_->write(text.data(), size) != size || !text_->flush()) {
    state_->setText(tr("Cannot write the film's text beside its file: %1").arg(text_->errorString()));
    return;
  }
  static const QRegularExpression sizes("^\\d+x\\d+$");
  if (size_->currentText() != size_->itemText(0) && !sizes.match(size_->currentText()).hasMatch()) {
    state_->setText(tr("'%1' is not a size such as 1280x720.").arg(size_->currentText()));
    text_.reset();
    return;
  }
  come_.clear(), said_.clear(), state_->clear();
  for (QWidget* w : std::initializer_list<QWidget*>{out_, frames_, size_, style_, filter_, samples_, subframes_})
    w->setEnabled(false);
  progress_->setVisible(true), progress_->setRange(0, 0);
  start_->setEnabled(false), cancel_->setText(tr("Stop"));
  process_.start(program_beside(), arguments(text_->fileName()) << "--progress");
}

void ExportDialog::read() {
  come_ += process_.readAll();
  for (qsizetype end; (end = come_.indexOf('\n')) >= 0; come_.remove(0, end + 1)) take(come_.left(end + 1));
}

// Takes a line of the program: its progress as JSON, or a message.
void ExportDialog::take(const QByteArray& line) {
  const QJsonObject progress = QJsonDocument::fromJson(line).object();
  if (progress.isEmpty()) return (void)(said_ += QString::fromUtf8(line));
  const int done = progress["done"].toInt(), frames = progress["frames"].toInt();
  progress_->setRange(0, frames), progress_->setValue(done);
  state_->setText(
      tr("frame %1 of %2, %3 a second").arg(done).arg(frames).arg(progress["per_second"].toDouble(), 0, 'f', 1));
}

void ExportDialog::finish(int code) {
  read();
  take(std::exchange(come_, {}));
  progress_->setVisible(false);
  start_->setEnabled(true), cancel_->setText(tr("Close"));
  for (QWidget* w : std::initializer_list<QWidget*>{out_, frames_, size_, style_, filter_, samples_, subframes_})
    w->setEnabled(true);
  if (!said_.trimmed().isEmpty()) state_->setText(said_.replace(text_->fileName(), script_name()).trimmed());
  text_.reset();
  if (code == 0 && open_->isChecked()) QDesktopServices::openUrl(QUrl::fromLocalFile(out_->text()));
  emit ended(code == 0);
}

void ExportDialog::closeEvent(QCloseEvent* e) {
  if (running()) ::kill(static_cast<pid_t>(process_.processId()), SIGINT), process_.waitForFinished(5000);
  e->accept();
}

}  // namespace betwixt::studio
