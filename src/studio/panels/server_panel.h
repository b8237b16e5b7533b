// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Shows and controls a running imaging server: its film at its time, the lines of its hosts, and an input for your own.
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "betwixt/language.h"
#include "betwixt/program.h"
#include "studio/viewport/picture_maker.h"

class QIODevice;
class QLabel;
class QLineEdit;
class QListWidget;
class QPlainTextEdit;
class QPushButton;

namespace betwixt::studio {

class ServerPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ServerPanel(QWidget* parent = nullptr);
  ~ServerPanel() override;

  // Connects to a socket "PATH" or to "HOST:PORT".
  void join(const QString& where);
  void leave();
  bool joined() const { return joined_; }
  void say(const QString& line);
  const Document& document() const { return program_.document(); }

 Q_SIGNALS:
  void answered(const QString& line, const QString& answer);

 private:
  void read();
  void take(const QByteArray& line);
  void begin();
  void ended(const QString& why);
  void ask(const QByteArray& line);
  void draw();
  void list_environments();
  Time now() const;

  std::unique_ptr<QIODevice> socket_;
  bool joined_ = false, stale_ = false, asked_ = false;
  QByteArray come_;
  std::vector<QString> waiting_;  // lines without an answer yet
  Program program_;
  Time at_;
  bool runs_ = false;
  QElapsedTimer since_;
  QTimer draws_, asks_;
  PictureMaker maker_;
  QLineEdit *where_, *line_;
  QPushButton *join_, *pause_;
  QLabel *picture_, *state_;
  QListWidget* environments_;
  QPlainTextEdit* log_;
};

}  // namespace betwixt::studio
