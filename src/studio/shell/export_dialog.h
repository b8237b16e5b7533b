// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The dialog that renders the film to a file. It sets the options of `betwixt render`, and shows the command line and
// the progress.
#pragma once

#include <QDialog>
#include <QProcess>
#include <QTemporaryFile>
#include <memory>

#include "studio/shell/workspace.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace betwixt::studio {

class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  explicit ExportDialog(Workspace&, QWidget* parent = nullptr);
  // Returns the arguments of `betwixt`; `script` is the file with the film.
  QStringList arguments(const QString& script) const;
  // Returns the command line as a user would type it.
  QString command() const;
  void start();
  bool running() const { return process_.state() != QProcess::NotRunning; }

 Q_SIGNALS:
  void ended(bool made);

 protected:
  void closeEvent(QCloseEvent*) override;

 private:
  void show_command();
  void keep();
  void recall();
  void read();
  void take(const QByteArray& line);
  void finish(int code);
  QString script_name() const;

  Workspace& workspace_;
  QLineEdit *out_, *frames_;
  QComboBox *size_, *style_, *filter_;
  QSpinBox *samples_, *subframes_;
  QCheckBox* open_;
  QLabel *command_, *state_;
  QProgressBar* progress_;
  QPushButton *start_, *cancel_;
  QProcess process_;
  std::unique_ptr<QTemporaryFile> text_;
  QByteArray come_;  // the beginning of a line of the program
  QString said_;     // its messages
};

}  // namespace betwixt::studio
