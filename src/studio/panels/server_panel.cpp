// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/server_panel.h"

#include <QHBoxLayout>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocalSocket>
#include <QMenu>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTcpSocket>
#include <QVBoxLayout>

#include "betwixt/environment.h"
#include "betwixt/object.h"
#include "studio/shell/scrolled.h"

namespace betwixt::studio {
namespace {

constexpr int pictures_a_second = 30, longest_log = 2000;  // lines

}  // namespace

ServerPanel::ServerPanel(QWidget* parent) : QWidget(parent), program_(Program::compile(Document())) {
  setObjectName("server");
  setWindowTitle(tr("Server"));
  where_ = new QLineEdit;
  where_->setObjectName("where");
  where_->setPlaceholderText(tr("a socket's path, or HOST:PORT"));
  where_->setToolTip(tr("the address of the server: `betwixt serve --socket PATH` or `--tcp HOST:PORT`"));
  join_ = new QPushButton(tr("Connect"));
  join_->setObjectName("join");
  pause_ = new QPushButton(tr("Pause"));
  pause_->setObjectName("pause"), pause_->setToolTip(tr("`pause`, `go`"));
  picture_ = new QLabel;
  picture_->setObjectName("picture"), picture_->setAlignment(Qt::AlignCenter), picture_->setMinimumSize(160, 90);
  picture_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  environments_ = new QListWidget;
  environments_->setObjectName("environments");
  environments_->setContextMenuPolicy(Qt::CustomContextMenu);
  environments_->setToolTip(tr("environments; right-click one to halt or kill it"));
  log_ = new QPlainTextEdit;
  log_->setReadOnly(true), log_->setMaximumBlockCount(longest_log);
  line_ = new QLineEdit;
  line_->setObjectName("line"),
      line_->setPlaceholderText(tr("a line for the server, such as: animate slide every 1t by translate(0.02 0 0)"));
  state_ = new QLabel(tr("not connected"));
  state_->setTextFormat(Qt::PlainText);
  auto* top = new QHBoxLayout;
  top->addWidget(where_, 1), top->addWidget(join_), top->addWidget(pause_);
  auto* all = scrolled_column(*this);
  all->addLayout(top), all->addWidget(picture_, 3), all->addWidget(environments_, 1), all->addWidget(log_, 2);
  all->addWidget(line_), all->addWidget(state_);
  draws_.setInterval(1000 / pictures_a_second), asks_.setInterval(1000);
  connect(join_, &QPushButton::clicked, this, [this] { joined_ ? leave() : join(where_->text()); });
  connect(where_, &QLineEdit::returnPressed, this, [this] { join(where_->text()); });
  connect(pause_, &QPushButton::clicked, this, [this] { say(runs_ ? "pause" : "go"); });
  connect(line_, &QLineEdit::returnPressed, this, [this] { say(line_->text()), line_->clear(); });
  connect(&draws_, &QTimer::timeout, this, &ServerPanel::draw);
  connect(&asks_, &QTimer::timeout, this, [this] { ask("time"); });
  connect(&maker_, &PictureMaker::made, this, [this](const PictureMade& m) {
    if (!m.image.isNull()) picture_->setPixmap(QPixmap::fromImage(m.image));
  });
  connect(environments_, &QListWidget::customContextMenuRequested, this, [this](const QPoint& p) {
    const QListWidgetItem* item = environments_->itemAt(p);
    if (!item || !joined_) return;
    QMenu menu;
    for (const char* verb : {"halt", "kill", "cancel"}) menu.addAction(QString("%1 %2").arg(verb, item->text()));
    if (const QAction* chosen = menu.exec(environments_->mapToGlobal(p))) say(chosen->text());
  });
}

ServerPanel::~ServerPanel() {
  if (socket_) socket_->disconnect(this);
}

void ServerPanel::join(const QString& where) {
  leave();
  where_->setText(where);
  const int colon = static_cast<int>(where.lastIndexOf(':'));
  bool port = false;
  const auto number = where.mid(colon + 1).toUShort(&port);
  if (colon > 0 && port && !where.contains('/')) {
    auto socket = std::make_unique<QTcpSocket>();
    connect(socket.get(), &QTcpSocket::connected, this, &ServerPanel::begin);
    connect(socket.get(), &QTcpSocket::errorOccurred, this, [this, s = socket.get()] { ended(s->errorString()); });
    connect(socket.get(), &QTcpSocket::readyRead, this, &ServerPanel::read);
    socket->connectToHost(where.left(colon), number);
    socket_ = std::move(socket);
  } else {
    auto socket = std::make_unique<QLocalSocket>();
    connect(socket.get(), &QLocalSocket::connected, this, &ServerPanel::begin);
    connect(socket.get(), &QLocalSocket::errorOccurred, this, [this, s = socket.get()] { ended(s->errorString()); });
    connect(socket.get(), &QLocalSocket::readyRead, this, &ServerPanel::read);
    auto* raw = socket.get();
    socket_ = std::move(socket);
    raw->connectToServer(where);
  }
}

void ServerPanel::leave() {
  if (!socket_) return;
  socket_->disconnect(this);
  socket_.release()->deleteLater();
  ended(tr("not connected"));
}

void ServerPanel::begin() {
  joined_ = true;
  waiting_.clear(), come_.clear();
  join_->setText(tr("Disconnect")), state_->setText(tr("connected"));
  ask("subscribe changes");
  ask("time");
  stale_ = true;
  draws_.start(), asks_.start();
}

void ServerPanel::ended(const QString& why) {
  joined_ = asked_ = false;
  draws_.stop(), asks_.stop();
  join_->setText(tr("Connect")), state_->setText(why);
}

void ServerPanel::ask(const QByteArray& line) {
  if (!joined_) return;
  waiting_.push_back(QString::fromUtf8(line));
  socket_->write(line + "\n");
}

void ServerPanel::say(const QString& line) {
  if (line.trimmed().isEmpty()) return;
  if (!joined_) return state_->setText(tr("not connected"));
  log_->appendPlainText("> " + line);
  ask(line.toUtf8());
}

void ServerPanel::read() {
  come_ += socket_->readAll();
  for (qsizetype end; (end = come_.indexOf('\n')) >= 0; come_.remove(0, end + 1)) take(come_.left(end));
}

void ServerPanel::take(const QByteArray& bytes) {
  const QJsonObject answer = QJsonDocument::fromJson(bytes).object();
  if (answer.contains("event")) {
    if (answer["event"] == "change") {
      stale_ = true;
      log_->appendPlainText(QString::fromUtf8(bytes));
    }
    return;
  }
  if (waiting_.empty() || !answer.contains("ok")) return;
  const QString line = waiting_.front();
  waiting_.erase(waiting_.begin());
  if (line == "history") {
    asked_ = false;
    LoadOptions none;
    none.read_nothing = true;  // a text from a server must open no files here
    program_ = Program::compile(load_text(answer["said"].toString().toStdString(), "", none).document, program_);
    list_environments();
    return;
  }
  if (line == "time" || line == "pause" || line == "go" || line.startsWith("seek")) {
    if (answer.contains("seconds")) at_ = from_seconds(answer["seconds"].toDouble()), since_.start();
    if (answer.contains("running")) runs_ = answer["running"].toBool();
    pause_->setText(runs_ ? tr("Pause") : tr("Go"));
    if (line != "time") ask("time");
  }
  if (line == "time" || line == "subscribe changes") return;
  const bool ok = answer["ok"].toBool();
  const QString said = ok ? answer["said"].toString() : answer["error"].toString() + "  " + answer["hint"].toString();
  log_->appendPlainText(said.isEmpty() ? QString::fromUtf8(bytes) : said.trimmed());
  emit answered(line, QString::fromUtf8(bytes));
}

void ServerPanel::list_environments() {
  environments_->clear();
  for (const ObjectId id : objects(document()))
    if (kind(document(), id) == Kind::environment) environments_->addItem(QString::fromStdString(document().name(id)));
}

Time ServerPanel::now() const { return runs_ ? at_ + from_seconds(1e-3 * static_cast<double>(since_.elapsed())) : at_; }

void ServerPanel::draw() {
  if (stale_ && !asked_) stale_ = false, asked_ = true, ask("history");
  if (!isVisible()) return;
  const Time t = now();
  state_->setText(tr("%1 s%2").arg(t.seconds(), 0, 'f', 2).arg(runs_ ? "" : tr(", paused")));
  RenderOptions o;
  o.width = std::max(16, picture_->width()), o.height = std::max(9, std::min(picture_->height(), o.width * 9 / 16));
  o.width = std::min(o.width, o.height * 16 / 9);
  maker_.want({program_, t, o, std::nullopt});
}

}  // namespace betwixt::studio
