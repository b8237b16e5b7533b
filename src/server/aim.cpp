// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The C interface of the Animation Imaging Model: calls become lines of the language on the server's socket, answers
// are lines of JSON. It knows nothing of documents; whoever can open a socket could do the same.
#include "betwixt/aim.h"

#include <fmt/format.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "server/aim_connect.h"

namespace {

using Json = nlohmann::json;

constexpr int names_of_a_host = 1'000'000;

thread_local std::string connect_error;

// A text of the language: in quotes, on one line.
std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n')
      out += "\\n";
    else
      out += c;
  }
  return out + "\"";
}

// Row vectors turn into column vectors: the language writes the columns of `m` as rows.
std::string matrix_text(const double m[16]) {
  std::string out = "matrix(";
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) out += fmt::format("{}{}", row + column ? " " : "", m[4 * column + row]);
  return out + ")";
}

std::string point_text(const double p[3]) { return fmt::format("({} {} {})", p[0], p[1], p[2]); }

bool finite(const double* numbers, int count) {
  for (int i = 0; i < count; ++i)
    if (!std::isfinite(numbers[i])) return false;
  return true;
}

}  // namespace

struct aim {
  int fd = -1;
  std::string in;     // bytes that came behind the last answer
  std::string error;  // of the last call
  std::string said;
  Json answer;
  int first = 0, objects = 0, tags = 0, environments = 0;
  int open = 0, open_before_bundle = 0;  // the object; 0: none
  bool interrupted = false;  // another command came between its rows; it must be opened again for the next one
  bool replacing = false;
  bool bundling = false;
  long stamp = LONG_MIN, now = LONG_MIN;  // when what was said last takes effect; the last tick that is known of

  ~aim() {
    if (fd >= 0) ::close(fd);
  }

  aim_status fail(aim_status status, std::string why) {
    error = std::move(why);
    return status;
  }
  aim_status lost(const char* what) {
    if (fd >= 0) ::close(fd);
    fd = -1;
    return fail(AIM_E_CONNECTION, what);
  }

  bool send(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t n = ::send(fd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
  }
  bool receive(std::string& line) {
    std::size_t searched = 0;
    for (;;) {
      if (const auto end = in.find('\n', searched); end != std::string::npos) {
        line = in.substr(0, end);
        in.erase(0, end + 1);
        return true;
      }
      searched = in.size();
      char buffer[4096];
      const ssize_t n = ::recv(fd, buffer, sizeof buffer, 0);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      in.append(buffer, static_cast<std::size_t>(n));
    }
  }

  // Sends a line and waits for its answer; what the server tells of its own accord in between is passed over.
  aim_status ask(const std::string& line) {
    error.clear();
    if (fd < 0) return fail(AIM_E_CONNECTION, "the connection is closed");
    if (!send(line + "\n")) return lost("the server has gone");
    return bundling ? AIM_OK : hear();  // a bundle is answered as a whole
  }
  aim_status hear() {
    std::string text;
    do {
      if (!receive(text)) return lost("the server has gone");
      answer = Json::parse(text, nullptr, false);
      if (!answer.is_object()) return lost("this is not an imaging server");
    } while (!answer.contains("ok"));
    if (answer.value("ok", false)) return AIM_OK;
    std::string why = answer.value("error", std::string("refused"));
    if (const std::string hint = answer.value("hint", std::string()); !hint.empty()) why += " (" + hint + ")";
    return fail(AIM_E_REFUSED, why);
  }

  // A command of the language that is no row: it ends the rows of an open object.
  aim_status say(const std::string& line) {
    interrupted = true;
    return ask(line);
  }
  aim_status opens(const char* verb, int name) {
    if (open != 0) return fail(AIM_E_CALL, "an object is open already");
    const aim_status status = say(fmt::format("{} O{}", verb, name));
    open = status == AIM_OK ? name : 0;
    interrupted = replacing = false;
    return status;
  }
  aim_status row(const std::string& text) {
    if (open == 0) return fail(AIM_E_CALL, "no object is open");
    if (interrupted && replacing)
      return fail(AIM_E_CALL, "another command came after 'replace': it must be said again");
    if (interrupted)
      if (const aim_status status = ask(fmt::format("edit O{}", open)); status != AIM_OK) return status;
    interrupted = false;
    return ask("  " + text);
  }
  // About environments: it takes effect a little later than it is said.
  aim_status stamped(const std::string& line) {
    const aim_status status = say(line);
    if (status == AIM_OK && !bundling) stamp = answer.value("tick", stamp);
    return status;
  }
  // One value of an environment; of what was just said, as it will be.
  aim_status value(int environment, const char* what, Json& out) {
    if (bundling) return fail(AIM_E_CALL, "nothing can be asked in a bundle");
    const std::string target = fmt::format("E{}.{}", environment, what);
    if (stamp > now) {
      if (const aim_status status = ask("time"); status != AIM_OK) return status;
      now = answer.value("tick", now);
    }
    const std::string when = stamp > now ? fmt::format(" at {}t", stamp) : std::string();
    if (const aim_status status = ask("eval " + target + when); status != AIM_OK) return status;
    const auto values = answer.find("values");
    if (values == answer.end() || !values->contains(target)) return fail(AIM_E_REFUSED, "the server gave no value");
    out = (*values)[target];
    return AIM_OK;
  }
  aim_status matrix(int environment, const char* what, double m[16]) {
    if (!m) return fail(AIM_E_CALL, "no place for the matrix");
    Json out;
    if (const aim_status status = value(environment, what, out); status != AIM_OK) return status;
    if (!out.is_array() || out.size() != 16) return fail(AIM_E_REFUSED, "the server gave no matrix");
    for (int i = 0; i < 16; ++i) m[4 * (i % 4) + i / 4] = out[static_cast<std::size_t>(i)].get<double>();
    return AIM_OK;
  }
  aim_status whole(const char* member, long& out) {
    if (bundling) return fail(AIM_E_CALL, "nothing can be asked in a bundle");
    if (const aim_status status = ask("time"); status != AIM_OK) return status;
    out = answer.value(member, 0L);
    return AIM_OK;
  }
  aim_status name(int* out, int& count) {
    if (!out) return fail(AIM_E_CALL, "no place for the name");
    if (count >= names_of_a_host - 1) return fail(AIM_E_CALL, "this host has used up its names");
    *out = first + ++count;
    error.clear();
    return AIM_OK;
  }
};

extern "C" {

aim* aim_connect(const char* where, const char* token) {
  std::string path = where ? where : "";
  if (path.empty())
    if (const char* folder = std::getenv("XDG_RUNTIME_DIR"); folder && *folder)
      path = std::string(folder) + "/betwixt.sock";
  connect_error.clear();
  if (path.empty()) {
    connect_error = "no socket is named, and XDG_RUNTIME_DIR is not set";
    return nullptr;
  }
  auto* h = new aim;
  if (path.starts_with("tcp:")) {
    const auto colon = path.rfind(':');
    if (colon > 3) h->fd = betwixt::connect_tcp(path.substr(4, colon - 4), path.substr(colon + 1), connect_error);
  } else {
    h->fd = betwixt::connect_unix(path, connect_error);
  }
  aim_status status = h->fd < 0 ? AIM_E_CONNECTION : AIM_OK;
  if (status == AIM_OK && token) {
    status = h->ask(std::string("token ") + token);
    connect_error = h->error;
  }
  // Names are unique by the number that the server gives its hosts.
  if (status == AIM_OK) {
    status = h->ask("time");
    connect_error = h->error;
  }
  if (status != AIM_OK) {
    if (connect_error.empty()) connect_error = "where is to be a path or tcp:HOST:PORT";
    delete h;
    return nullptr;
  }
  h->first = static_cast<int>(h->answer.value("host", 0L) % 2000) * names_of_a_host;
  return h;
}

void aim_disconnect(aim* h) { delete h; }

const char* aim_error(const aim* h) { return h ? h->error.c_str() : connect_error.c_str(); }

aim_status aim_make_object(aim* h, int* object) {
  if (h->open != 0) return h->fail(AIM_E_CALL, "an object is open already");
  if (const aim_status status = h->name(object, h->objects); status != AIM_OK) return status;
  return h->opens("make", *object);
}
aim_status aim_edit_object(aim* h, int object) { return h->opens("edit", object); }
aim_status aim_close_object(aim* h) {
  if (h->open == 0) return h->fail(AIM_E_CALL, "no object is open");
  h->open = 0;  // the next command that is not a row ends the rows
  h->error.clear();
  return AIM_OK;
}
aim_status aim_delete_object(aim* h, int object) { return h->say(fmt::format("delete O{}", object)); }
aim_status aim_call_object(aim* h, int object) { return h->row(fmt::format("call O{}", object)); }
aim_status aim_tag(aim* h, int* tag) {
  if (const aim_status status = h->name(tag, h->tags); status != AIM_OK) return status;
  return h->row(fmt::format("tag T{}", *tag));
}
aim_status aim_replace(aim* h, int tag, int offset) {
  h->replacing = false;
  const aim_status status = h->row(fmt::format("replace T{} {}", tag, offset));
  h->replacing = status == AIM_OK;
  return status;
}

aim_status aim_push_matrix(aim* h) { return h->row("push"); }
aim_status aim_pop_matrix(aim* h) { return h->row("pop"); }
aim_status aim_multiply_matrix(aim* h, const double m[16]) {
  if (!m || !finite(m, 16)) return h->fail(AIM_E_CALL, "a matrix is 16 numbers");
  return h->row("multiply " + matrix_text(m));
}

aim_status aim_point(aim* h, double x, double y, double z) {
  const double p[] = {x, y, z};
  if (!finite(p, 3)) return h->fail(AIM_E_CALL, "a point is three numbers");
  return h->row("point " + point_text(p));
}
aim_status aim_vector(aim* h, const double from[3], const double to[3]) {
  if (!from || !to || !finite(from, 3) || !finite(to, 3)) return h->fail(AIM_E_CALL, "a point is three numbers");
  return h->row("vector " + point_text(from) + " " + point_text(to));
}
aim_status aim_polygon(aim* h, int count, const double* xyz) {
  if (count < 3 || !xyz || !finite(xyz, 3 * count)) return h->fail(AIM_E_CALL, "a polygon has at least three points");
  std::string text = "polygon";
  for (int i = 0; i < count; ++i) text += " " + point_text(xyz + 3 * i);
  return h->row(text);
}
aim_status aim_text(aim* h, const char* utf8) {
  return utf8 ? h->row("text " + quoted(utf8)) : h->fail(AIM_E_CALL, "no text");
}
aim_status aim_color(aim* h, double r, double g, double b) {
  const double c[] = {r, g, b};
  if (!finite(c, 3)) return h->fail(AIM_E_CALL, "a colour is three numbers");
  return h->row(fmt::format("color rgb({} {} {})", r, g, b));
}
aim_status aim_texture(aim* h, const char* file) {
  return file ? h->row("texture " + quoted(file)) : h->fail(AIM_E_CALL, "no file");
}
aim_status aim_font(aim* h, const char* name) {
  return name ? h->row("font " + quoted(name)) : h->fail(AIM_E_CALL, "no name");
}
aim_status aim_view(aim* h, const double eye[3], const double at[3]) {
  if (!eye || !at || !finite(eye, 3) || !finite(at, 3)) return h->fail(AIM_E_CALL, "a point is three numbers");
  return h->row("view from " + point_text(eye) + " to " + point_text(at));
}
aim_status aim_perspective(aim* h, double angle) {
  return std::isfinite(angle) ? h->row(fmt::format("perspective {}rad", angle)) : h->fail(AIM_E_CALL, "no angle");
}
aim_status aim_orthographic(aim* h, double height) {
  return std::isfinite(height) ? h->row(fmt::format("orthographic {}", height)) : h->fail(AIM_E_CALL, "no height");
}

aim_status aim_make_environment(aim* h, int* environment) { return h->name(environment, h->environments); }
aim_status aim_begin_environment(aim* h, int environment) { return h->row(fmt::format("begin E{}", environment)); }
aim_status aim_end_environment(aim* h) { return h->row("end"); }
aim_status aim_start(aim* h, int main_object) { return h->say(fmt::format("start O{}", main_object)); }

aim_motion aim_motion_of(long interval, const double m[16]) {
  aim_motion motion{};
  if (m) std::memcpy(motion.matrix, m, sizeof motion.matrix);
  motion.interval = interval;
  motion.period = 1;
  motion.ceiling = 30;
  motion.from = motion.until = -1;
  return motion;
}

aim_status aim_animate(aim* h, int environment, long interval, const double m[16]) {
  if (!m) return h->fail(AIM_E_CALL, "a matrix is 16 numbers");
  const aim_motion motion = aim_motion_of(interval, m);
  return aim_animate_motion(h, environment, &motion);
}

aim_status aim_animate_motion(aim* h, int environment, const aim_motion* a) {
  if (!a || !finite(a->matrix, 16)) return h->fail(AIM_E_CALL, "a matrix is 16 numbers");
  std::string line = fmt::format("animate E{} every {}t by {}", environment, a->interval, matrix_text(a->matrix));
  if (a->change != 0)
    line += fmt::format(" {} {}t per {}t", a->change > 0 ? "slower" : "faster", std::labs(a->change), a->period);
  if (a->ceiling != 30) line += fmt::format(" limit {}t", a->ceiling);
  if (a->from >= 0) line += fmt::format(" from {}t", a->from);
  if (a->until >= 0) line += fmt::format(" until {}t", a->until);
  if (a->keep_phase) line += " keep-phase";
  return h->stamped(line);
}

aim_status aim_halt(aim* h, int environment) { return h->stamped(fmt::format("halt E{}", environment)); }
aim_status aim_kill(aim* h, int environment) { return h->stamped(fmt::format("kill E{}", environment)); }
aim_status aim_cancel(aim* h, int environment) { return h->stamped(fmt::format("cancel E{}", environment)); }

aim_status aim_get_interval(aim* h, int environment, long* interval) {
  if (!interval) return h->fail(AIM_E_CALL, "no place for the interval");
  Json out;
  const aim_status status = h->value(environment, "every", out);
  if (status == AIM_OK) *interval = out.is_number() ? out.get<long>() : 0;
  return status;
}
aim_status aim_get_matrix(aim* h, int environment, double m[16]) { return h->matrix(environment, "by", m); }
aim_status aim_get_environment_matrix(aim* h, int environment, double a[16]) {
  return h->matrix(environment, "world", a);
}
aim_status aim_get_slot_counter(aim* h, int* slot) {
  long n = 0;
  if (!slot) return h->fail(AIM_E_CALL, "no place for the counter");
  const aim_status status = h->whole("slot", n);
  if (status == AIM_OK) *slot = static_cast<int>(n);
  return status;
}
aim_status aim_get_tick(aim* h, long* tick) {
  return tick ? h->whole("tick", *tick) : h->fail(AIM_E_CALL, "no place for the tick");
}

aim_status aim_begin_bundle(aim* h) {
  if (h->bundling) return h->fail(AIM_E_CALL, "a bundle is open already");
  h->bundling = true, h->open_before_bundle = h->open;
  const aim_status status = h->say("bundle");
  h->bundling = status == AIM_OK;
  return status;
}
aim_status aim_end_bundle(aim* h) {
  if (!h->bundling) return h->fail(AIM_E_CALL, "no bundle is open");
  h->bundling = false, h->open = h->open_before_bundle;
  return h->stamped("end");
}
aim_status aim_command(aim* h, const char* line, const char** said) {
  if (!line || std::strchr(line, '\n')) return h->fail(AIM_E_CALL, "a command is one line");
  const aim_status status = h->say(line);
  h->said = status == AIM_OK && !h->bundling ? h->answer.value("said", std::string()) : std::string();
  if (said) *said = h->said.c_str();
  return status;
}

}  // extern "C"
