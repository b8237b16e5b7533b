// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/console.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QTextBlock>
#include <QVBoxLayout>

#include "commands/line_head.h"
#include "editor/help.h"
#include "studio/shell/text_of.h"
#include "studio/shell/text_size.h"
#include "studio/shell/theme.h"
#include "syntax/tokens.h"

namespace betwixt::studio {
namespace {

constexpr int most_lines = 5000;     // in the log
constexpr int longest = 300;         // letters shown of one line, because a rewritten text may be a whole film
constexpr int most_at_once = 50000;  // letters shown of one answer
constexpr int most_input = 10;       // visible lines of the input

// Returns the help for the first word of the input line, without `at TIME` and `on LAYER`; for `create` that of the
// kind. Returns nullptr if the word has no help.
const HelpEntry* help_of(const std::string& line) {
  const LineHead head = line_head(line);
  const auto known = [&](std::string_view word, std::initializer_list<HelpGroup> groups) -> const HelpEntry* {
    for (const HelpGroup g : groups)
      for (const HelpEntry& e : help_entries())
        if (e.group == g && e.word == word) return &e;
    return nullptr;
  };
  if (const HelpEntry* kind = known(kind_word(head), {HelpGroup::kind})) return kind;
  return known(head.word, {HelpGroup::verb, HelpGroup::shell});
}

// Returns the colour of a line of an answer. Indented lines keep the colour of the line before.
QColor color_of(const QString& line, const QColor& before) {
  const Colors& c = colors();
  const auto says = [&](const char* what) {
    const qsizetype at = line.indexOf(what);
    return at == 0 || (at > 0 && !line.startsWith(' ') && line[at - 1] == ' ');
  };
  if (says("error: ")) return c.error;
  if (says("warning: ")) return c.warning;
  if (says("notice: ")) return c.dim;
  return line.startsWith(' ') ? before : c.text;
}

}  // namespace

ConsoleLine::ConsoleLine(Workspace& workspace, QWidget* parent) : WordEdit(workspace, parent) {
  setObjectName("console_line");
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setLineWrapMode(QPlainTextEdit::NoWrap);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setTabChangesFocus(false);
  setPlaceholderText(tr("create ball sphere"));
  connect(this, &QPlainTextEdit::blockCountChanged, this, [this] { updateGeometry(); });
}

QSize ConsoleLine::sizeHint() const {
  const int lines = std::clamp(blockCount(), 1, most_input);
  return {30 * fontMetrics().averageCharWidth(),
          lines * fontMetrics().lineSpacing() + 2 * static_cast<int>(document()->documentMargin()) + 2};
}

std::string ConsoleLine::said_so_far() const {
  return toPlainText().left(textCursor().position()).replace('\n', ' ').toStdString();
}

// Shows an earlier or later line of the history. Returns false if there is none.
bool ConsoleLine::remember(int step) {
  const qsizetype to = at_ + step;
  if (to < 0 || to > earlier_.size()) return false;
  if (at_ == earlier_.size()) begun_ = toPlainText();
  at_ = to;
  setPlainText(at_ == earlier_.size() ? begun_ : earlier_[at_]);
  moveCursor(QTextCursor::End);
  return true;
}

void ConsoleLine::keyPressEvent(QKeyEvent* e) {
  const bool listed = findChild<QTreeWidget*>("words")->isVisible();
  const QTextBlock here = textCursor().block();
  if (!listed && e->modifiers() == Qt::NoModifier) {
    if (e->key() == Qt::Key_Tab) return offer_words();
    if (e->key() == Qt::Key_Up && here == document()->firstBlock() && remember(-1)) return;
    if (e->key() == Qt::Key_Down && here == document()->lastBlock() && remember(1)) return;
    if (e->key() == Qt::Key_Escape) return clear();
    if (e->key() == Qt::Key_Return || e->key() == Qt::Key_Enter) {
      const QString all = toPlainText();
      if (Session::needs_more(all.toStdString())) return WordEdit::keyPressEvent(e);
      if (all.trimmed().isEmpty()) return clear();
      if (earlier_.isEmpty() || earlier_.back() != all) earlier_.push_back(all);
      at_ = earlier_.size();
      clear();
      emit entered(all);
      return;
    }
  }
  WordEdit::keyPressEvent(e);
}

Console::Console(Workspace& workspace, QWidget* parent) : QWidget(parent), workspace_(workspace) {
  setObjectName("console");
  setWindowTitle(tr("Console"));
  log_ = new QPlainTextEdit(this);
  log_->setObjectName("console_log");
  log_->setReadOnly(true);
  log_->setUndoRedoEnabled(false);
  log_->setMaximumBlockCount(most_lines);
  log_->setFont(script_font());
  log_->setFrameShape(QFrame::NoFrame);
  help_ = new QLabel(this);
  help_->setObjectName("console_help");
  help_->setTextFormat(Qt::RichText);
  help_->setWordWrap(true);
  help_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  prompt_ = new QLabel(this);
  prompt_->setTextFormat(Qt::PlainText);
  prompt_->setFont(log_->font());
  line_ = new ConsoleLine(workspace, this);
  auto* below = new QHBoxLayout;
  below->setContentsMargins(6, 0, 0, 2);
  below->addWidget(prompt_, 0, Qt::AlignTop);
  below->addWidget(line_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->setSpacing(2);
  all->addWidget(log_, 1);
  all->addWidget(help_);
  all->addLayout(below);
  help_->setContentsMargins(6, 0, 6, 0);
  prompt_->setContentsMargins(0, static_cast<int>(line_->document()->documentMargin()), 0, 0);
  setFocusProxy(line_);
  connect(&workspace, &Workspace::said, this, &Console::write_down);
  connect(&workspace, &Workspace::text_changed, this, &Console::show_help);
  connect(line_, &QPlainTextEdit::textChanged, this, &Console::show_help);
  connect(line_, &ConsoleLine::entered, this, &Console::carry_out);
  show_help();
}

// Pasted text may have several lines; each one is carried out by itself, as if typed.
void Console::carry_out(const QString& lines) {
  const std::string all = lines.toStdString();
  for (std::string_view rest = all; !rest.empty();) {
    const LogicalLine one = logical_line(rest);
    const auto length = static_cast<std::size_t>(one.end - rest.data());
    const std::string line(rest.substr(0, length));
    rest.remove_prefix(std::min(rest.size(), length + 1));
    if (!without_indent(line).empty() && !workspace_.say(line)) break;
  }
}

void Console::write_down(const QString& line, const QString& answer, bool refused) {
  const Colors& c = colors();
  QTextCursor end(log_->document());
  end.movePosition(QTextCursor::End);
  end.beginEditBlock();
  const auto put = [&](const QString& text, const QColor& color) {
    QTextCharFormat f;
    f.setForeground(color);
    if (!log_->document()->isEmpty()) end.insertBlock();
    end.insertText(text, f);
  };
  if (!line.isEmpty())
    for (const QString& l : beginning_of(line, most_at_once).split('\n'))
      put("› " + (l.size() > longest ? l.left(longest) + " …" : l), c.accent);
  QColor now = refused ? c.error : c.text;
  QString said = beginning_of(answer, most_at_once);
  while (said.endsWith('\n')) said.chop(1);
  if (!said.isEmpty())
    for (const QString& l : said.split('\n')) put(l, now = color_of(l, now));
  end.endEditBlock();
  log_->moveCursor(QTextCursor::End);
  log_->moveCursor(QTextCursor::StartOfLine);
}

void Console::show_help() {
  const std::string sheet = workspace_.session().sheet();
  prompt_->setText(sheet.empty() ? "›" : text_of(sheet) + " ›");
  const std::string line = line_->toPlainText().toStdString();
  const QString dim = colors().dim.name();
  const auto html = [&](const QString& usage, const QString& sentence, const QString& example) {
    const QString shown = example.section('\n', 0, 0).toHtmlEscaped();
    return QString("<b>%1</b><br><span style='color:%4'>%2%3</span>")
        .arg(usage.toHtmlEscaped(), sentence.toHtmlEscaped(),
             shown.isEmpty() ? QString() : tr("<br>as in <code>%1</code>").arg(shown), dim);
  };
  if (!sheet.empty() && !line.empty() && (indented(line) || starts_like_time(line[0]))) {
    help_->setText(
        html("TIME VALUE [TWERPER] [ease-in=LENGTH] [ease-out=LENGTH]", tr("A row of %1.").arg(text_of(sheet)), {}));
  } else if (const HelpEntry* e = help_of(line)) {
    const std::string_view usage = e->group == HelpGroup::kind || e->usage.empty() ? e->word : e->usage;
    QString written = text_of(usage);
    if (e->group == HelpGroup::kind && !e->usage.empty()) written += " " + text_of(e->usage);
    help_->setText(html(written, text_of(e->sentence), text_of(e->example)));
  }
  help_->setVisible(!help_->text().isEmpty() && !line.empty());
}

}  // namespace betwixt::studio
