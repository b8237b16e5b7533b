// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The imaging server: threads of which one reads hosts' lines and answers them, and the clock's.
#pragma once

#include <functional>
#include <vector>

#include "server/frame_clock.h"
#include "server/listener.h"

namespace betwixt {

struct ServeOptions {
  std::size_t hosts = 1000;  // at once; the next one is told why not
  std::string token;         // for those who come by TCP
  int stop = -1;             // a file that becomes readable when the server shall end
  // What was answered is safe, but something that was not takes too long to be waited for: ends the process.
  std::function<void()> give_up = {};
};

// Serves until it is stopped. `imaging` has begun. Errors: machine (the history cannot be kept any more).
Status serve(Imaging& imaging, FrameClock& clock, const std::vector<Listener>&, const ServeOptions&);

}  // namespace betwixt
