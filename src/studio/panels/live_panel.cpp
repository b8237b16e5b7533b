// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "studio/panels/live_panel.h"

#include <fmt/format.h>

#include <QCheckBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "betwixt/language.h"
#include "editor/placing.h"
#include "scene/document.h"
#include "studio/shell/scrolled.h"

namespace betwixt::studio {
namespace {

constexpr int polls_a_second = 60;

}  // namespace

LivePanel::LivePanel(Workspace& workspace, QWidget* parent) : QWidget(parent), workspace_(workspace) {
  setObjectName("live");
  setWindowTitle(tr("Controls"));
  where_ = new QLineEdit("9000");
  where_->setObjectName("where");
  where_->setToolTip(
      tr("the port for OSC, on this machine only; HOST:PORT uses another address. MIDI is received, too, if this "
         "machine has it"));
  listen_ = new QPushButton(tr("Listen"));
  listen_->setObjectName("listen"), listen_->setCheckable(true);
  target_ = new QLineEdit;
  target_->setObjectName("target");
  target_->setPlaceholderText(tr("ball.position.y"));
  learn_ = new QPushButton(tr("Learn"));
  learn_->setObjectName("learn"), learn_->setCheckable(true);
  learn_->setToolTip(tr("connects the next control that moves to the target: `dial ADDRESS to TARGET`"));
  record_ = new QCheckBox(tr("Record during playback"));
  record_->setObjectName("record");
  record_->setToolTip(tr("writes the input during playback as events, which replace those that were there"));
  state_ = new QLabel, last_ = new QLabel;
  for (QLabel* l : {state_, last_}) l->setTextFormat(Qt::PlainText);
  last_->setObjectName("last"), last_->setWordWrap(true);
  dials_ = new QListWidget;
  dials_->setObjectName("dials");
  auto* form = new QFormLayout;
  const auto row = [&](const QString& words, QWidget* field, QWidget* button) {
    auto* both = new QHBoxLayout;
    both->addWidget(field, 1), both->addWidget(button);
    form->addRow(words, both);
  };
  row(tr("Port"), where_, listen_);
  row(tr("Target"), target_, learn_);
  form->addRow(record_);
  auto* all = scrolled_column(*this);
  all->addLayout(form), all->addWidget(last_), all->addWidget(dials_, 1), all->addWidget(state_);
  poll_.setInterval(1000 / polls_a_second);
  connect(&poll_, &QTimer::timeout, this, &LivePanel::poll);
  connect(listen_, &QPushButton::toggled, this, &LivePanel::listen);
  connect(&workspace, &Workspace::playing_changed, this, [this] {
    if (!workspace_.playhead().playing()) end_take();
  });
  connect(&workspace, &Workspace::text_changed, this, &LivePanel::list_dials);
  connect(&workspace, &Workspace::selection_changed, this, [this] {
    if (!workspace_.selected().empty() && !learn_->isChecked())
      target_->setText(QString::fromStdString(workspace_.name(workspace_.selected().back()) + ".position"));
  });
  list_dials();
}

void LivePanel::listen(bool on) {
  poll_.stop(), input_.reset(), state_->clear();
  if (!on) return;
  auto opened = LiveInput::open(where_->text().toStdString());
  if (!opened) {
    state_->setText(QString::fromStdString(opened.error().message));
    listen_->setChecked(false);
    return;
  }
  input_ = *std::move(opened);
  state_->setText(tr("listening"));
  poll_.start();
}

void LivePanel::poll() {
  if (!workspace_.jobs().hears()) return;  // the messages wait until the work is done
  obey(input_->poll());
  if (const auto n = input_->ignored(); n > 0)
    state_->setText(n == 1 ? tr("listening; 1 packet was not OSC") : tr("listening; %1 packets were not OSC").arg(n));
}

// Shows the effect of all messages in one preview.
void LivePanel::obey(const std::vector<LiveMessage>& all) {
  std::optional<Document> ahead;
  for (const LiveMessage& m : all) take(m, ahead);
  if (ahead) workspace_.show_ahead(*ahead);
}

// `ahead`: the film with the earlier messages, if it is not shown yet.
void LivePanel::take(const LiveMessage& m, std::optional<Document>& ahead) {
  last_->setText(QString::fromStdString(in_words(m)).left(200));
  if (learn_->isChecked()) return ahead.reset(), learn(m);
  const std::string* text = m.text ? &*m.text : nullptr;
  const bool records = record_->isChecked() && workspace_.playhead().playing();
  const auto complain = [&](const Error& e) {
    last_->setText(last_->text() + "\n" + QString::fromStdString(e.message));
  };
  if (!records) {
    const Result<Document> next = turn(ahead ? *ahead : workspace_.document(), m.address, m.numbers, text);
    next ? void(ahead = *next) : complain(next.error());
    return;
  }
  // The message counts for the frame that was due when it arrived, however late it is read.
  const Time now = workspace_.playhead().now(m.arrived), frame = workspace_.document().rate().span(1);
  if (!take_) take_.emplace(workspace_.session().document()), taken_ = now, messages_ = 0;
  const bool back = workspace_.playhead().direction() > 0 ? now < taken_ : now > taken_;
  if (back) take_->end(taken_ + frame);
  if (const Status s = take_->turn(m.address, m.numbers, text, now, m.within); !s) return complain(s.error());
  taken_ = now, ++messages_;
  ahead = take_->document();
}

void LivePanel::learn(const LiveMessage& m) {
  learn_->setChecked(false);
  workspace_.say(fmt::format("dial {} to {}", m.address, target_->text().toStdString()));
}

// Writes the take into the script, as one undo step.
void LivePanel::end_take() {
  if (!take_) return;
  take_->end(taken_ + workspace_.document().rate().span(1));
  const std::string before = workspace_.session().text(), after = take_->text(before);
  take_.reset();
  if (after == before) return workspace_.look_back();
  const LineChange c = change_between(before, after);
  workspace_.say(Session::rewrite_line(c.lines.first, c.lines.last, c.others));
  state_->setText(messages_ == 1 ? tr("1 message recorded") : tr("%1 messages recorded").arg(messages_));
}

void LivePanel::list_dials() {
  dials_->clear();
  for (const Dial& d : *workspace_.document().scene().dials)
    dials_->addItem(QString::fromStdString(d.address + "  →  " + workspace_.document().name(d.target)));
}

}  // namespace betwixt::studio
