// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/export_dialog.h"

#include <QCheckBox>
#include <QCloseEvent>
#include <QComboBox>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QUrl>
#include <QVBoxLayout>
#include <csignal>

#include "betwixt/render.h"
#include "studio/text_of.h"

namespace betwixt::studio {
namespace {

// Quotes a word for a shell.
QString quoted(const QString& s) {
  static const QRegularExpression plain("^[A-Za-z0-9_./:%=+@,-]+$");
  return plain.match(s).hasMatch() ? s : "'" + QString(s).replace("'", "'\\''") + "'";
}

}  // namespace

ExportDialog::ExportDialog(Desk& desk, QWidget* parent) : QDialog(parent), desk_(desk) {
  setObjectName("export");
  setWindowTitle(tr("Make a film"));
  auto* form = new QFormLayout;
  const QFileInfo script(QString::fromStdString(desk.session().file()));
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
                                  .arg(QString::fromStdString(desk.when(desk.document().range().first)),
                                       QString::fromStdString(desk.when(desk.document().range().second))));
  const Transport& t = desk.transport();
  if (std::pair(t.first(), t.last()) != desk.document().range())
    frames_->setText(QString::fromStdString(desk.when(t.first()) + ".." + desk.when(t.last())));
  form->addRow(tr("Frames"), frames_);
  size_ = new QComboBox;
  size_->setEditable(true);
  const auto pixels = desk.document().size();
  size_->addItem(pixels ? tr("as the script says: %1x%2").arg(pixels->first).arg(pixels->second) : tr("1280x720"));
  for (const char* s : {"640x360", "1920x1080", "2560x1440", "3840x2160", "1080x1080", "1080x1920"}) size_->addItem(s);
  form->addRow(tr("Size"), size_);
  style_ = new QComboBox;
  for (const Style& s : styles()) style_->addItem(text_of(s.name));
  form->addRow(tr("Style"), style_);
  samples_ = new QSpinBox;
  samples_->setRange(0, 4096), samples_->setSpecialValueText(tr("as usual"));
  form->addRow(tr("Samples a pixel"), samples_);
  subframes_ = new QSpinBox;
  subframes_->setRange(0, 4096), subframes_->setSpecialValueText(tr("as the script says"));
  subframes_->setToolTip(tr("of how many pictures one that is blurred by its shutter or lens is added up"));
  form->addRow(tr("Subframes"), subframes_);
  open_ = new QCheckBox(tr("show it when it is made"));
  form->addRow({}, open_);
  command_ = new QLabel;
  command_->setObjectName("command");
  command_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  command_->setWordWrap(true);
  QFont fixed("monospace");
  fixed.setStyleHint(QFont::Monospace);
  command_->setFont(fixed);
  form->addRow(tr("The same, typed"), command_);
  progress_ = new QProgressBar;
  progress_->setVisible(false);
  state_ = new QLabel;
  for (QLabel* l : {command_, state_}) l->setTextFormat(Qt::PlainText);
  state_->setObjectName("state");
  state_->setWordWrap(true);
  start_ = new QPushButton(tr("Make it"));
  start_->setObjectName("start"), start_->setDefault(true);
  cancel_ = new QPushButton(tr("Close"));
  cancel_->setObjectName("cancel");
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(state_, 1), buttons->addWidget(start_), buttons->addWidget(cancel_);
  auto* all = new QVBoxLayout(this);
  all->addLayout(form), all->addWidget(progress_), all->addLayout(buttons);
  setMinimumWidth(40 * fontMetrics().height());

  connect(choose, &QPushButton::clicked, this, [this] {
    const QString to = QFileDialog::getSaveFileName(this, tr("Make a film"), out_->text());
    if (!to.isEmpty()) out_->setText(to);
  });
  for (QLineEdit* e : {out_, frames_}) connect(e, &QLineEdit::textChanged, this, &ExportDialog::show_command);
  for (QComboBox* c : {size_, style_}) connect(c, &QComboBox::currentTextChanged, this, &ExportDialog::show_command);
  for (QSpinBox* s : {samples_, subframes_}) connect(s, &QSpinBox::valueChanged, this, &ExportDialog::show_command);
  connect(start_, &QPushButton::clicked, this, &ExportDialog::start);
  connect(cancel_, &QPushButton::clicked, this,
          [this] { running() ? (void)::kill(static_cast<pid_t>(process_.processId()), SIGINT) : (void)close(); });
  process_.setProcessChannelMode(QProcess::MergedChannels);
  connect(&process_, &QProcess::readyRead, this, &ExportDialog::read);
  connect(&process_, &QProcess::finished, this, [this](int code) { finish(code); });
  connect(&process_, &QProcess::errorOccurred, this, [this](QProcess::ProcessError e) {
    if (e == QProcess::FailedToStart) state_->setText(tr("The program betwixt cannot be started.")), finish(3);
  });
  show_command();
}

QStringList ExportDialog::arguments(const QString& script) const {
  QStringList all{"render", script, "-o", out_->text()};
  if (!frames_->text().isEmpty()) all << "--frames" << frames_->text();
  static const QRegularExpression pixels("^\\d+x\\d+$");
  if (pixels.match(size_->currentText()).hasMatch())
    if (size_->currentText() != "1280x720" || desk_.document().size()) all << "--size" << size_->currentText();
  if (style_->currentIndex() != 0) all << "--style" << style_->currentText();
  if (samples_->value() > 0) all << "--samples" << QString::number(samples_->value());
  if (subframes_->value() > 0) all << "--subframes" << QString::number(subframes_->value());
  return all;
}

QString ExportDialog::script_name() const {
  const QString file = QString::fromStdString(desk_.session().file());
  return file.isEmpty() ? "film.bx" : file;
}

QString ExportDialog::command() const {
  QStringList words{"betwixt"};
  for (const QString& a : arguments(script_name())) words << quoted(a);
  return words.join(' ');
}

void ExportDialog::show_command() { command_->setText(command()); }

// Unsaved changes are rendered, too: the text goes to a temporary file beside the script.
void ExportDialog::start() {
  if (running()) return;
  const QDir folder = QFileInfo(script_name()).absoluteDir();
  text_ = std::make_unique<QTemporaryFile>(folder.filePath(".betwixt-film-XXXXXX.bx"));
  const std::string& text = desk_.text();
  const auto size = static_cast<qint64>(text.size());
  if (!text_->open() || text_->write(text.data(), size) != size || !text_->flush()) {
    state_->setText(tr("The film's text cannot be written beside its file: %1").arg(text_->errorString()));
    return;
  }
  static const QRegularExpression sizes("^\\d+x\\d+$");
  if (size_->currentText() != size_->itemText(0) && !sizes.match(size_->currentText()).hasMatch()) {
    state_->setText(tr("'%1' is no size such as 1280x720.").arg(size_->currentText()));
    text_.reset();
    return;
  }
  said_.clear(), state_->clear();
  for (QWidget* w : std::initializer_list<QWidget*>{out_, frames_, size_, style_, samples_, subframes_})
    w->setEnabled(false);
  progress_->setVisible(true), progress_->setRange(0, 0);
  start_->setEnabled(false), cancel_->setText(tr("Stop"));
  process_.start(QCoreApplication::applicationDirPath() + "/betwixt", arguments(text_->fileName()) << "--progress");
}

void ExportDialog::read() {
  said_ += QString::fromUtf8(process_.readAll());
  static const QRegularExpression far("(\\d+)/(\\d+) frames[^\n]*\n");
  for (QRegularExpressionMatch m; (m = far.match(said_)).hasMatch();
       said_.remove(m.capturedStart(), m.capturedLength())) {
    progress_->setRange(0, m.captured(2).toInt());
    progress_->setValue(m.captured(1).toInt());
    state_->setText(m.captured(0).trimmed());
  }
}

void ExportDialog::finish(int code) {
  read();
  progress_->setVisible(false);
  start_->setEnabled(true), cancel_->setText(tr("Close"));
  for (QWidget* w : std::initializer_list<QWidget*>{out_, frames_, size_, style_, samples_, subframes_})
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
