// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/recovery.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTextBrowser>
#include <QVBoxLayout>

#include "base/files.h"
#include "betwixt/session.h"
#include "editor/journal.h"
#include "studio/shell/text_diff.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/shell/theme.h"

namespace betwixt::studio {

std::optional<std::string> recovered_text(const std::string& script, const std::string& nameless_journal) {
  const bool has_own = script.empty() && !nameless_journal.empty();
  const QString journal = QString::fromStdString(has_own ? nameless_journal : journal_path(script));
  // Beside the script, because it names other files by their place. The name is always the same, so that a step that
  // crashes the program is found at the next start.
  const QFileInfo info(QString::fromStdString(script));
  const QString copy = script.empty() ? QFileInfo(journal).absolutePath() + "/.recovery.bx"
                                      : info.absolutePath() + "/." + info.completeBaseName() + ".recovery.bx";
  const QString copied_journal = QString::fromStdString(journal_path(copy.toStdString()));
  const auto clear = [&] { QFile::remove(copy), QFile::remove(copied_journal); };
  clear();
  const bool there = script.empty() ? QFile(copy).open(QIODevice::WriteOnly) : QFile::copy(info.filePath(), copy);
  if (!there || !QFile::copy(journal, copied_journal)) return clear(), std::nullopt;
  std::optional<std::string> text;
  {
    Session session({}, {});
    session.edit_in_place();
    const Session::Answer a = session.open(copy.toStdString(), Session::Earlier::recover);
    if (a.done && session.unsaved() > 0) text = session.text();
  }
  clear();
  return text;
}

Recovery::Recovery(const std::string& script, const std::string& question, QWidget* parent,
                   const std::string& nameless_journal)
    : QDialog(parent),
      script_(script),
      nameless_journal_(nameless_journal),
      counts_(new QLabel(this)),
      lines_(new QTextBrowser(this)) {
  setObjectName("recovery");
  setWindowTitle(tr("Recover unsaved work"));
  auto* says =
      new QLabel(tr("Some steps of an earlier session were not saved. Lines with − are only in the saved file, "
                    "lines with + come back."),
                 this);
  says->setWordWrap(true);
  says->setToolTip(QString::fromStdString(question));
  counts_->setObjectName("counts");
  counts_->setText(QString::fromStdString(question));
  lines_->setObjectName("lines"), lines_->setAccessibleName(tr("Recover unsaved work"));
  lines_->setFont(script_font());
  lines_->setLineWrapMode(QTextEdit::NoWrap);
  auto* buttons = new QHBoxLayout;
  const auto button = [&](const char* name, const QString& text) {
    auto* b = new QPushButton(text, this);
    b->setObjectName(name), b->setAutoDefault(false);
    buttons->addWidget(b);
    return b;
  };
  save_ = button("save_other", tr("Save as another file…"));
  save_->setEnabled(false);
  buttons->addStretch(1);
  auto* later = button("later", tr("Later"));
  auto* discard = button("discard", tr("Discard"));
  auto* recover = button("recover", tr("Recover"));
  recover->setDefault(true);
  connect(save_, &QPushButton::clicked, this, &Recovery::save_as);
  connect(later, &QPushButton::clicked, this, &QDialog::reject);
  connect(discard, &QPushButton::clicked, this, [this] { chosen_ = "discard", accept(); });
  connect(recover, &QPushButton::clicked, this, [this] { chosen_ = "recover", accept(); });
  auto* all = new QVBoxLayout(this);
  all->addWidget(says), all->addWidget(lines_, 1), all->addWidget(counts_), all->addLayout(buttons);
  resize(46 * fontMetrics().height(), 30 * fontMetrics().height());
  connect(this, &Recovery::came, this, &Recovery::show_difference, Qt::QueuedConnection);
  if (const auto there = read_whole(script_)) saved_ = *there;
  reader_ = std::thread([this] {
    recovered_ = recovered_text(script_, nameless_journal_);
    emit came();
  });
}

Recovery::~Recovery() { reader_.join(); }

void Recovery::show_difference() {
  read_ = true;
  if (!recovered_) return;
  save_->setEnabled(true);
  int added = 0, removed = 0;
  const Colors& c = colors();
  QString html = "<pre>";
  for (const DiffLine& l : text_diff(QString::fromStdString(saved_), QString::fromStdString(*recovered_))) {
    const bool more = l.sign == DiffLine::Sign::added, less = l.sign == DiffLine::Sign::removed;
    added += more, removed += less;
    const QString sign = more ? "+ " : less ? "− " : l.sign == DiffLine::Sign::gap ? "⋮" : "  ";
    const QColor color = more ? c.note : less ? c.error : c.dim;
    html += "<span style='color:" + color.name() + "'>" + (sign + l.text).toHtmlEscaped() + "</span>\n";
  }
  lines_->setHtml(html + "</pre>");
  counts_->setText(added + removed > 0 ? tr("lines added: %1, lines removed: %2").arg(added).arg(removed)
                                       : tr("The saved file and the recovered text are the same."));
}

void Recovery::save_as() {
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Save the recovered text"), "recovered.bx", tr("Films (*.bx)"));
  if (file.isEmpty()) return;
  const Status s = write_whole(file.toStdString(), *recovered_, true);
  counts_->setText(s ? file : QString::fromStdString(s.error().message));
}

}  // namespace betwixt::studio
