// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The C interface of the Animation Imaging Model. Each call sends a line of the language to the server's socket and
// reads an answer, a line of JSON. This file knows nothing of documents: any program that opens the socket could do the
// same.
#include "betwixt/aim.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>

#include "server/aim_connect.h"
#include "server/aim_host.h"
#include "syntax/texts.h"

namespace {

thread_local std::string connect_error;

// The model multiplies row vectors, the language column vectors: so the columns of `m` become rows.
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

// Runs a call on a handle and catches its exceptions, such as one for an answer that no imaging server gives.
template <class Call>
aim_status on(aim* h, Call call) {
  if (!h) return connect_error = "the handle is null: aim_connect failed", AIM_E_CALL;
  try {
    return call(*h);
  } catch (const std::exception& e) {
    return h->lost(e.what());
  }
}

}  // namespace

extern "C" {

aim* aim_connect(const char* where, const char* token) {
  std::string path = where ? where : "";
  if (path.empty())
    if (const char* folder = std::getenv("XDG_RUNTIME_DIR"); folder && *folder)
      path = std::string(folder) + "/betwixt.sock";
  connect_error.clear();
  if (path.empty()) {
    connect_error = "no socket is given, and XDG_RUNTIME_DIR is not set";
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
    status = on(h, [&](aim& it) { return it.ask(std::string("token ") + token); });
    connect_error = h->error;
  }
  // The program that listens there may be no imaging server.
  if (status == AIM_OK) {
    status = on(h, [](aim& it) { return it.ask("time"); });
    connect_error = h->error;
  }
  if (status != AIM_OK) {
    if (connect_error.empty()) connect_error = "the address must be a path or tcp:HOST:PORT";
    delete h;
    return nullptr;
  }
  return h;
}

void aim_disconnect(aim* h) { delete h; }

const char* aim_error(const aim* h) { return h ? h->error.c_str() : connect_error.c_str(); }
const char* aim_warnings(const aim* h) { return h ? h->warnings.c_str() : ""; }

aim_status aim_make_object(aim* h, int* object) {
  return on(h, [&](aim& it) {
    if (it.open != 0) return it.fail(AIM_E_CALL, "an object is already open");
    if (const aim_status status = it.name(object, it.objects); status != AIM_OK) return status;
    return it.opens("make", *object);
  });
}
aim_status aim_edit_object(aim* h, int object) {
  return on(h, [&](aim& it) { return it.opens("edit", object); });
}
aim_status aim_close_object(aim* h) {
  return on(h, [&](aim& it) {
    if (it.open == 0) return it.fail(AIM_E_CALL, "no object is open");
    it.open = 0;  // the next command that is not a row closes the display list
    it.error.clear();
    return AIM_OK;
  });
}
aim_status aim_delete_object(aim* h, int object) {
  return on(h, [&](aim& it) { return it.say(fmt::format("delete O{}", object), {object}); });
}
aim_status aim_call_object(aim* h, int object) {
  return on(h, [&](aim& it) { return it.row(fmt::format("call O{}", object), {object}); });
}
aim_status aim_tag(aim* h, int* tag) {
  return on(h, [&](aim& it) {
    if (const aim_status status = it.name(tag, it.tags); status != AIM_OK) return status;
    return it.row(fmt::format("tag T{}", *tag));
  });
}
aim_status aim_replace(aim* h, int tag, int offset) {
  return on(h, [&](aim& it) {
    it.replacing = false;
    const aim_status status = it.row(fmt::format("replace T{} {}", tag, offset), {tag});
    it.replacing = status == AIM_OK;
    return status;
  });
}

aim_status aim_push_matrix(aim* h) {
  return on(h, [&](aim& it) { return it.row("push"); });
}
aim_status aim_pop_matrix(aim* h) {
  return on(h, [&](aim& it) { return it.row("pop"); });
}
aim_status aim_multiply_matrix(aim* h, const double m[16]) {
  return on(h, [&](aim& it) {
    if (!m || !finite(m, 16)) return it.fail(AIM_E_CALL, "a matrix must have 16 numbers");
    return it.row("multiply " + matrix_text(m));
  });
}

aim_status aim_point(aim* h, double x, double y, double z) {
  return on(h, [&](aim& it) {
    const double p[] = {x, y, z};
    if (!finite(p, 3)) return it.fail(AIM_E_CALL, "a point must have three numbers");
    return it.row("point " + point_text(p));
  });
}
aim_status aim_vector(aim* h, const double from[3], const double to[3]) {
  return on(h, [&](aim& it) {
    if (!from || !to || !finite(from, 3) || !finite(to, 3))
      return it.fail(AIM_E_CALL, "a point must have three numbers");
    return it.row("vector " + point_text(from) + " " + point_text(to));
  });
}
aim_status aim_polygon(aim* h, int count, const double* xyz) {
  return on(h, [&](aim& it) {
    if (count < 3 || !xyz || !finite(xyz, 3 * count))
      return it.fail(AIM_E_CALL, "a polygon must have at least three points");
    std::string text = "polygon";
    for (int i = 0; i < count; ++i) text += " " + point_text(xyz + 3 * i);
    return it.row(text);
  });
}
aim_status aim_text(aim* h, const char* utf8) {
  return on(h, [&](aim& it) {
    return utf8 ? it.row("text " + betwixt::write_text(utf8)) : it.fail(AIM_E_CALL, "the text is missing");
  });
}
aim_status aim_color(aim* h, double r, double g, double b) {
  return on(h, [&](aim& it) {
    const double c[] = {r, g, b};
    if (!finite(c, 3)) return it.fail(AIM_E_CALL, "a colour must have three numbers");
    return it.row(fmt::format("color rgb({} {} {})", r, g, b));
  });
}
aim_status aim_texture(aim* h, const char* file) {
  return on(h, [&](aim& it) {
    return file ? it.row("texture " + betwixt::write_text(file)) : it.fail(AIM_E_CALL, "the file name is missing");
  });
}
aim_status aim_font(aim* h, const char* name) {
  return on(h, [&](aim& it) {
    return name ? it.row("font " + betwixt::write_text(name)) : it.fail(AIM_E_CALL, "the name is missing");
  });
}
aim_status aim_view(aim* h, const double eye[3], const double at[3]) {
  return on(h, [&](aim& it) {
    if (!eye || !at || !finite(eye, 3) || !finite(at, 3)) return it.fail(AIM_E_CALL, "a point must have three numbers");
    return it.row("view from " + point_text(eye) + " to " + point_text(at));
  });
}
aim_status aim_perspective(aim* h, double angle) {
  return on(h, [&](aim& it) {
    return std::isfinite(angle) ? it.row(fmt::format("perspective {}rad", angle))
                                : it.fail(AIM_E_CALL, "the angle is not finite");
  });
}
aim_status aim_orthographic(aim* h, double height) {
  return on(h, [&](aim& it) {
    return std::isfinite(height) ? it.row(fmt::format("orthographic {}", height))
                                 : it.fail(AIM_E_CALL, "the height is not finite");
  });
}

aim_status aim_make_environment(aim* h, int* environment) {
  return on(h, [&](aim& it) { return it.name(environment, it.environments); });
}
aim_status aim_begin_environment(aim* h, int environment) {
  return on(h, [&](aim& it) { return it.row(fmt::format("begin E{}", environment), {environment}); });
}
aim_status aim_end_environment(aim* h) {
  return on(h, [&](aim& it) { return it.row("end"); });
}
aim_status aim_start(aim* h, int main_object) {
  return on(h, [&](aim& it) { return it.say(fmt::format("start O{}", main_object), {main_object}); });
}

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
  return on(h, [&](aim& it) {
    if (!m) return it.fail(AIM_E_CALL, "a matrix must have 16 numbers");
    const aim_motion motion = aim_motion_of(interval, m);
    return aim_animate_motion(&it, environment, &motion);
  });
}

aim_status aim_animate_motion(aim* h, int environment, const aim_motion* a) {
  return on(h, [&](aim& it) {
    if (!a || !finite(a->matrix, 16)) return it.fail(AIM_E_CALL, "a matrix must have 16 numbers");
    std::string line = fmt::format("animate E{} every {}t by {}", environment, a->interval, matrix_text(a->matrix));
    if (a->change != 0)
      line += fmt::format(" {} {}t per {}t", a->change > 0 ? "slower" : "faster", std::labs(a->change), a->period);
    if (a->ceiling != 30) line += fmt::format(" limit {}t", a->ceiling);
    if (a->from >= 0) line += fmt::format(" from {}t", a->from);
    if (a->until >= 0) line += fmt::format(" until {}t", a->until);
    if (a->keep_phase) line += " keep-phase";
    return it.stamped(line, {environment});
  });
}

aim_status aim_halt(aim* h, int environment) {
  return on(h, [&](aim& it) { return it.stamped(fmt::format("halt E{}", environment), {environment}); });
}
aim_status aim_kill(aim* h, int environment) {
  return on(h, [&](aim& it) { return it.stamped(fmt::format("kill E{}", environment), {environment}); });
}
aim_status aim_cancel(aim* h, int environment) {
  return on(h, [&](aim& it) { return it.stamped(fmt::format("cancel E{}", environment), {environment}); });
}

aim_status aim_get_interval(aim* h, int environment, long* interval) {
  return on(h, [&](aim& it) {
    if (!interval) return it.fail(AIM_E_CALL, "the pointer for the interval is null");
    aim::Json out;
    const aim_status status = it.value(environment, "every", out);
    if (status == AIM_OK) *interval = out.is_number() ? out.get<long>() : 0;
    return status;
  });
}
aim_status aim_get_matrix(aim* h, int environment, double m[16]) {
  return on(h, [&](aim& it) { return it.matrix(environment, "by", m); });
}
aim_status aim_get_environment_matrix(aim* h, int environment, double a[16]) {
  return on(h, [&](aim& it) { return it.matrix(environment, "world", a); });
}
aim_status aim_get_slot_counter(aim* h, int* slot) {
  return on(h, [&](aim& it) {
    long n = 0;
    if (!slot) return it.fail(AIM_E_CALL, "the pointer for the counter is null");
    const aim_status status = it.whole("slot", n);
    if (status == AIM_OK) *slot = static_cast<int>(n);
    return status;
  });
}
aim_status aim_get_tick(aim* h, long* tick) {
  return on(h, [&](aim& it) {
    return tick ? it.whole("tick", *tick) : it.fail(AIM_E_CALL, "the pointer for the tick is null");
  });
}

aim_status aim_begin_bundle(aim* h) {
  return on(h, [&](aim& it) { return it.begin_bundle(); });
}
aim_status aim_end_bundle(aim* h) {
  return on(h, [&](aim& it) { return it.end_bundle(); });
}
aim_status aim_command(aim* h, const char* line, const char** said) {
  return on(h, [&](aim& it) {
    if (!line || std::strchr(line, '\n')) return it.fail(AIM_E_CALL, "a command must be one line");
    const aim_status status = it.command(line);
    it.said = status == AIM_OK && !it.bundling ? it.answer.value("said", std::string()) : std::string();
    if (said) *said = it.said.c_str();
    return status;
  });
}
aim_status aim_send(aim* h, const char* name, const void* bytes, size_t size) {
  return on(h, [&](aim& it) {
    if (!name || (!bytes && size > 0)) return it.fail(AIM_E_CALL, "the pointer for the name or the bytes is null");
    if (*name == '\0' || std::strpbrk(name, " \t\r\n")) return it.fail(AIM_E_CALL, "the name has no blanks");
    if (it.bundling) return it.fail(AIM_E_CALL, "bytes cannot be sent in a bundle");
    it.interrupted = true;
    return it.ask_with(fmt::format("send {} {}", name, size), {static_cast<const char*>(bytes), size});
  });
}

}  // extern "C"
