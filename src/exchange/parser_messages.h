// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Messages between a program and its parser process, over sockets that preserve message boundaries.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"

namespace betwixt {

// A request to the process that waits for work: the task, then the path; for letters then a zero byte and the line, for
// a table what is inside, for colors the query. With it come a socket for the conversation, memory for the result, and
// the file.
enum class ParserTask : std::uint32_t { mesh, picture, scene, drawing, linear_picture, letters, table, colors };
struct ParserCeilings {
  std::uint64_t memory = 0;             // bytes
  std::uint64_t seconds = 0, wall = 0;  // of work and in all
};
struct ParserRequest {
  ParserTask task = ParserTask::mesh;
  std::uint32_t any_size = 0;  // no limit on the unpacked size (unpacking.h)
  ParserCeilings most;
};
constexpr char parser_version[] = "13";  // of this protocol; the program's first argument
// Its second argument: become another program in a jail, for a file or in a folder (parser_program.cpp).
constexpr char parser_runs[] = "run", parser_works_in[] = "work";
constexpr char parser_says[] = "say";                                       // or: say the text of a folder
constexpr int parser_of_another_version = 3, parser_started_nothing = 126;  // its exit codes
constexpr int parser_control = 3;                                           // the socket for requests

// The first letter of each message over a job's socket. `has` and `read` are followed by a path.
constexpr char says_begun = 'b', says_done = 'd', asks_has = 'h', asks_read = 'r';
constexpr char answers_yes = 'y', answers_no = 'n';  // after a failed read the code and the words of an error follow
constexpr std::size_t longest_message = 1 << 15;

struct ParserMessage {
  std::string text;
  std::vector<OpenFile> files;
};
// Sends everything in one message. Returns false if the other end is closed.
bool say(int socket, std::string_view text, std::span<const int> files = {});
// Returns the next message, or nullopt if the other end is closed. With `wait` (milliseconds), also nullopt if no
// message comes in time.
std::optional<ParserMessage> hear(int socket, int wait = -1);

}  // namespace betwixt
