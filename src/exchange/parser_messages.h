// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// What a program and its parsers' process say to each other, over sockets that keep messages apart.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"

namespace betwixt {

// The program's to the process that waits for work: this, then the path; with a socket to talk over, memory for what is
// read, and the file.
enum class ParserTask : std::uint32_t { mesh, picture, scene, drawing };
struct ParserCeilings {
  std::uint64_t memory = 0;             // bytes
  std::uint64_t seconds = 0, wall = 0;  // of work and in all
};
struct ParserRequest {
  ParserTask task = ParserTask::mesh;
  std::uint32_t any_size = 0;  // whatever it unpacks to (unpacking.h)
  ParserCeilings most;
};
constexpr char parser_version[] = "5";  // of all this; its first argument
constexpr char parser_runs[] = "run";   // its second one: it becomes another program, in a jail (parser_program.cpp)
constexpr int parser_of_another_version = 3, parser_started_nothing = 126;  // its exit codes
constexpr int parser_control = 3;                                           // the socket that requests come by

// The first letter of what is said over a job's socket. A path is said behind `has` and `read`.
constexpr char says_begun = 'b', says_done = 'd', asks_has = 'h', asks_read = 'r';
constexpr char answers_yes = 'y', answers_no = 'n';  // behind it of a read the code and the words of an error
constexpr std::size_t longest_message = 1 << 15;

struct ParserMessage {
  std::string text;
  std::vector<OpenFile> files;
};
// Of all that is sent at once. False where nobody listens.
bool say(int socket, std::string_view text, std::span<const int> files = {});
// None where nobody will say anything any more; with `wait` (milliseconds) also where nothing came in time.
std::optional<ParserMessage> hear(int socket, int wait = -1);

}  // namespace betwixt
