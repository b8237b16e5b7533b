// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs the imaging server: threads of which one at a time reads hosts' lines and answers them, and the clock's threads.
#pragma once

#include <functional>
#include <vector>

#include "server/frame_clock.h"
#include "server/listener.h"

namespace betwixt {

struct ServeOptions {
  std::size_t hosts = 1000;  // at once; the next one is refused with a reason
  std::string token;         // for TCP connections
  int stop = -1;             // a file that becomes readable when the server must end
  // Receives the statistics once a second. May block without delaying hosts.
  std::function<void(const std::string&)> report = {};
  // Ends the process if unfinished work takes too long at the end. All answered commands are on the disk then.
  std::function<void()> give_up = {};
};

// Serves until stopped. Call Imaging::begin() before. Errors: machine (the history cannot be written any more).
Status serve(Imaging& imaging, FrameClock& clock, const std::vector<Listener>&, const ServeOptions&);

}  // namespace betwixt
