// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/asking.h"

#include <QMessageBox>
#include <QPushButton>

namespace betwixt::studio {

namespace {

// Drops the lines above the question, such as a list of changes.
std::string question_in(const std::string& whole) {
  const std::size_t above = whole.rfind('\n');
  return whole.substr(above == std::string::npos ? 0 : above + 1);
}

}  // namespace

std::vector<std::string> answers_of(const std::string& whole) {
  const std::string question = question_in(whole);
  std::vector<std::string> all;
  const auto split = [&](std::string_view text, std::string_view between) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find(between), text.size());
      all.emplace_back(text.substr(0, end));
      text.remove_prefix(std::min(end + between.size(), text.size()));
    }
  };
  if (const std::size_t open = question.rfind('('); open != std::string::npos) {
    split(std::string_view(question).substr(open + 1, question.find(')', open) - open - 1), "/");
    return all;
  }
  const std::size_t mark = question.rfind('?');
  if (mark == std::string::npos) return {};
  const std::size_t colon = question.rfind(": ", mark), from = colon == std::string::npos ? 0 : colon + 2;
  std::string words = question.substr(from, mark - from);
  if (const std::size_t last = words.rfind(" or "); last != std::string::npos) words.replace(last, 4, ", ");
  split(words, ", ");
  return all;
}

std::string words_of(const std::string& whole) {
  const std::string question = question_in(whole);
  const std::size_t mark = question.rfind('?'), colon = question.rfind(": ", mark);
  const bool asks = question.find('(', std::min(mark, question.size())) != std::string::npos;
  return asks || colon == std::string::npos ? question.substr(0, mark) + "?" : question.substr(0, colon) + ".";
}

std::optional<std::string> ask_in_window(QWidget* parent, const std::string& question) {
  QMessageBox box(parent);
  box.setWindowTitle(QObject::tr("Betwixt"));
  box.setIcon(QMessageBox::Question);
  box.setTextFormat(Qt::PlainText);
  box.setText(QString::fromStdString(words_of(question)));
  if (const std::size_t above = question.rfind('\n'); above != std::string::npos)
    box.setDetailedText(QString::fromStdString(question.substr(0, above)));
  std::vector<QAbstractButton*> buttons;
  const std::vector<std::string> answers = answers_of(question);
  for (const std::string& a : answers) {
    QString text = QString::fromStdString(a);
    text[0] = text[0].toUpper();
    buttons.push_back(box.addButton(text, QMessageBox::AcceptRole));
  }
  if (!answers.empty() && answers.back() == "stay")
    box.setEscapeButton(buttons.back());
  else
    box.addButton(QMessageBox::Cancel);
  box.exec();
  for (std::size_t i = 0; i < buttons.size(); ++i)
    if (box.clickedButton() == buttons[i]) return answers[i];
  return std::nullopt;
}

}  // namespace betwixt::studio
