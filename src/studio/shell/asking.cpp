// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/shell/asking.h"

#include <QMessageBox>
#include <QPushButton>

#include "studio/shell/text_of.h"

namespace betwixt::studio {

std::optional<std::string> ask_in_window(QWidget* parent, const Session::Question& question) {
  QMessageBox box(parent);
  box.setWindowTitle(QObject::tr("Betwixt"));
  box.setIcon(QMessageBox::Question);
  box.setTextFormat(Qt::PlainText);
  box.setText(QString::fromStdString(question.text));
  box.setDetailedText(QString::fromStdString(question.above));
  std::vector<QAbstractButton*> buttons;
  for (const std::string& choice : question.choices) {
    QString text = QString::fromStdString(choice);
    text[0] = text[0].toUpper();
    buttons.push_back(box.addButton(word_of(text.toStdString()), QMessageBox::AcceptRole));
  }
  if (!buttons.empty() && question.choices.back() == "stay")
    box.setEscapeButton(buttons.back());
  else
    box.addButton(QMessageBox::Cancel);
  box.exec();
  for (std::size_t i = 0; i < buttons.size(); ++i)
    if (box.clickedButton() == buttons[i]) return question.choices[i];
  return std::nullopt;
}

}  // namespace betwixt::studio
