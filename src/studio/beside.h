// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Work that may take long is done beside the window's thread, which goes on: the window is drawn, and shows how far the
// work is. Hands wait until it is done, and are heard then, in order.
#pragma once

#include <QObject>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#undef slots

#include "base/how_far.h"

namespace betwixt::studio {

class Beside : public QObject {
  Q_OBJECT
 public:
  explicit Beside(QObject* parent = nullptr);
  ~Beside() override;

  // Returns when the work is done. Where `hears` is false nothing may be carried out.
  void carry_out(const std::function<void()>& work);
  // Nothing is under way, or what is waits for an answer: then what is carried out is done here and now.
  bool hears() const { return !at_work_ || answers_; }
  // Done in the window's thread, whichever thread asks for it; returns when it is done.
  void in_window(const std::function<void()>& work);
  void set_patience(int milliseconds) { patience_ = milliseconds; }  // until it is told that work takes long

 Q_SIGNALS:
  void takes_long(float share);  // how far it is, 0 to 1; again and again, until it is over
  void over();
  void done();  // of the worker; so is this:
  void asks();

 private:
  void run();
  void wait();
  void answer(std::unique_lock<std::mutex>&);

  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<void()>*wanted_ = nullptr, *question_ = nullptr;
  const HowFar* how_far_ = nullptr;
  bool done_ = false, ends_ = false;
  float share_ = 0;
  bool at_work_ = false, answers_ = false;  // of the window's thread
  int patience_ = 100;
  std::thread worker_;
};

}  // namespace betwixt::studio
