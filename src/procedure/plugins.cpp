// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "procedure/plugins.h"

#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <filesystem>

#include "betwixt/plugin.h"
#include "betwixt/program.h"
#include "procedure/nested.h"
#include "procedure/query_error.h"
#include "track/types.h"

namespace betwixt {
namespace {

// --- values to and from C ---

// By betwixt_kind.
const Value& example_of_kind(int kind) {
  static const Value examples[] = {{}, 0.0, Vec3{}, Color{}, false, Angles{}, Quat{}, Text(), Matrix()};
  return examples[kind];
}

bool write(const Value& v, betwixt_value& out) {
  out = {};
  for (int kind = BETWIXT_NUMBER; kind <= BETWIXT_MATRIX; ++kind)
    if (v.index() == example_of_kind(kind).index()) out.kind = kind;
  const std::vector<double> all = numbers(v);
  std::copy(all.begin(), all.end(), out.numbers);
  if (const auto* t = std::get_if<Text>(&v)) out.text = (*t)->c_str();
  return out.kind != 0;
}

Result<Value> read(const betwixt_value& v) {
  if (v.kind < BETWIXT_NUMBER || v.kind > BETWIXT_TEXT) return fail(ErrorCode::type, "it returned no value");
  if (v.kind == BETWIXT_TEXT) return Value(Text(std::string(v.text ? v.text : "")));
  const std::size_t count = numbers(example_of_kind(v.kind)).size();
  if (!finite({v.numbers, count})) return fail(ErrorCode::range, "it returned a number that is not finite");
  Value made = with_numbers(example_of_kind(v.kind), v.numbers);
  if (auto* q = std::get_if<Quat>(&made)) *q = normalize(*q);
  return made;
}

Error refused(const char* why) { return fail(ErrorCode::type, why ? why : "it failed without an error message"); }

// --- queries by plug-ins; the texts of answers live as long as this object ---

struct Asking {
  Questions& questions;
  std::uint64_t& cost;
  Result<Value> last = Value(0.0);
  std::string why = {};
};
int ask(void* state, const char* target, double seconds, betwixt_value* out) {
  Asking& a = *static_cast<Asking*>(state);
  if (!target || !std::isfinite(seconds))
    a.last = fail(ErrorCode::range, "a name and a finite time are needed");
  else
    a.last = a.questions.value(target, seconds, a.cost);
  if (a.last && !write(*a.last, *out)) a.last = fail(ErrorCode::type, "it has a value that plug-ins cannot represent");
  if (a.last) return 0;
  a.why = query_error("value", target ? target : "", a.last.error());
  return out->text = a.why.c_str(), 1;
}

struct Listening {
  Input& input;
  Value last;
};
int listen(void* state, double seconds, betwixt_value* out) {
  Listening& a = *static_cast<Listening*>(state);
  if (std::isfinite(seconds) && write(a.last = a.input.at(seconds), *out)) return 0;
  out->text = "the input has no value there that plug-ins can represent";
  return 1;
}

struct Running {
  Host& host;
  std::string last;
};
const char* run(void* state, const char* line) {
  Running& r = *static_cast<Running*>(state);
  const Status done = r.host.run(line ? line : "");
  if (done) return nullptr;
  r.last = done.error().message;
  return r.last.c_str();
}

// --- the routines; a plug-in in C++ may throw ---

constexpr std::uint64_t steps_of_a_call = 100;

template <class R>
Result<R> caught(auto&& call) {
  const Nested nested;
  if (Nested::too_deep()) return Nested::error();
  try {
    return call();
  } catch (...) {
    return fail(ErrorCode::type, "the plug-in threw an exception");
  }
}

template <class Function>
struct Native : Routine {
  Function function = nullptr;
  void* user = nullptr;
};

struct NativeTwerper final : Native<betwixt_twerper> {
  Result<double> blend(double u) const override {
    return caught<double>([&]() -> Result<double> {
      const double d = function(u, user);
      if (!std::isfinite(d)) return fail(ErrorCode::range, "it returned a number that is not finite");
      return d;
    });
  }
};

struct NativeFilter final : Native<betwixt_filter> {
  Result<Value> filter(Input& input, double seconds, const Parameters& parameters) const override {
    return caught<Value>([&]() -> Result<Value> {
      std::vector<betwixt_parameter> given(parameters.size());
      for (std::size_t i = 0; i < given.size(); ++i) {
        given[i].name = parameters[i].first.c_str();
        write(parameters[i].second, given[i].value);
      }
      Listening state{input, {}};
      const betwixt_input in{&state, seconds, listen};
      betwixt_value out{};
      if (function(&in, given.data(), given.size(), &out, user)) return refused(out.text);
      return read(out);
    });
  }
};

struct NativeValue final : Native<betwixt_procedure> {
  Result<Value> value(Questions& q, const std::vector<Value>& arguments, std::uint64_t& cost) const override {
    cost += steps_of_a_call;
    return caught<Value>([&]() -> Result<Value> {
      std::vector<betwixt_value> given(arguments.size());
      for (std::size_t i = 0; i < given.size(); ++i) write(arguments[i], given[i]);
      const std::string self(q.self());
      Asking state{q, cost};
      const betwixt_questions questions{&state, q.seconds(), self.c_str(), ask};
      betwixt_value out{};
      if (function(&questions, given.data(), given.size(), &out, user)) return refused(out.text);
      return read(out);
    });
  }
};

struct NativeCommand final : Native<betwixt_command> {
  Status command(Host& host, const std::vector<std::string>& words) const override {
    return caught<Nothing>([&]() -> Status {
      std::vector<const char*> given;
      for (const auto& w : words) given.push_back(w.c_str());
      Running state{host, {}};
      const betwixt_commands commands{&state, run};
      const char* why = nullptr;
      if (function(&commands, given.data(), given.size(), &why, user)) return refused(why);
      return Nothing{};
    });
  }
};

// --- registering ---

struct Registering {
  Plugin plugin;
  std::string path, wrong;
};

bool is_name(const char* name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  if (!name || !letter(*name)) return false;
  return std::all_of(name, name + std::string_view(name).size(),
                     [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; });
}

// Returns whether the name is free among routines of one role, or among functions; otherwise sets the error.
bool accept(Registering& r, const char* name, bool there, bool taken) {
  if (!r.wrong.empty()) return false;
  if (!is_name(name))
    r.wrong = "it registers something whose name is not made of letters, digits, - and _";
  else if (taken)
    r.wrong = std::string("it registers '") + name + "' twice";
  else if (!there)
    r.wrong = std::string("it registers '") + name + "' without a function, a type or lines";
  return r.wrong.empty();
}

template <class Routine, Role role, class Function>
int add(const betwixt_host* host, const char* name, const char* help, Function function, void* user) {
  Registering& r = *static_cast<Registering*>(host->state);
  const bool taken = name && std::any_of(r.plugin.items.begin(), r.plugin.items.end(),
                                         [&](const PluginItem& i) { return i.role == role && i.name == name; });
  if (!accept(r, name, function, taken)) return 1;
  auto routine = std::make_shared<Routine>();
  routine->language = "plug-in";
  routine->source = r.path;
  routine->function = function;
  routine->user = user;
  r.plugin.items.push_back({name, help ? help : "", role, std::move(routine)});
  return 0;
}

int add_function(const betwixt_host* host, const char* name, const char* type, const double* numbers,
                 std::size_t count) {
  Registering& r = *static_cast<Registering*>(host->state);
  const auto& all = r.plugin.functions;
  const bool taken = name && std::any_of(all.begin(), all.end(), [&](const auto& f) { return f.name == name; });
  if (!accept(r, name, type, taken)) return 1;
  r.plugin.functions.push_back(
      {name, type, numbers ? std::vector<double>(numbers, numbers + count) : std::vector<double>{}});
  return 0;
}

int add_kind(const betwixt_host* host, const char* name, const char* help, const char* lines) {
  Registering& r = *static_cast<Registering*>(host->state);
  const auto& all = r.plugin.kinds;
  const bool taken = name && std::any_of(all.begin(), all.end(), [&](const auto& k) { return k.name == name; });
  if (!accept(r, name, lines, taken)) return 1;
  r.plugin.kinds.push_back({name, help ? help : "", lines});
  return 0;
}

int add_renderer(const betwixt_host* host, const char* name, const char* help, betwixt_renderer function, void* user) {
  Registering& r = *static_cast<Registering*>(host->state);
  const auto& all = r.plugin.renderers;
  const bool taken = name && std::any_of(all.begin(), all.end(), [&](const auto& k) { return k.name == name; });
  if (!accept(r, name, function, taken)) return 1;
  r.plugin.renderers.push_back({name, help ? help : "", r.path, function, user});
  return 0;
}

// Loads a plug-in and lets it register. Errors begin with the reason, such as "not a plug-in".
Result<Plugin> open(const std::string& path) {
  const auto wrong = [](std::string what) { return fail(ErrorCode::file, std::move(what)); };
  // An absolute path has a slash; without one the system would search its own folders.
  const auto full = std::filesystem::absolute(path).string();
  void* library = dlopen(full.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library)
    return wrong("not a plug-in: it is not a shared library for this machine, or a library that it needs is missing");
  const auto version = reinterpret_cast<int (*)()>(dlsym(library, "betwixt_plugin_version"));
  const auto entry = reinterpret_cast<int (*)(const betwixt_host*)>(dlsym(library, "betwixt_plugin"));
  if (!version || !entry) return wrong("not a plug-in: it has no BETWIXT_PLUGIN");
  if (const int v = version(); v < 1 || v > BETWIXT_PLUGIN_VERSION)
    return wrong("it is made for version " + std::to_string(v) +
                 " of the plug-in interface; this program supports versions up to " +
                 std::to_string(BETWIXT_PLUGIN_VERSION));
  Registering r;
  r.path = path;
  const betwixt_host host{BETWIXT_PLUGIN_VERSION,
                          &r,
                          add<NativeTwerper, Role::twerper, betwixt_twerper>,
                          add<NativeFilter, Role::filter, betwixt_filter>,
                          add<NativeValue, Role::value, betwixt_procedure>,
                          add<NativeCommand, Role::command, betwixt_command>,
                          add_function,
                          add_kind,
                          add_renderer};
  try {
    const int refusal = entry(&host);
    if (!r.wrong.empty()) return wrong(r.wrong);
    if (refusal) return wrong("it refuses to be loaded (its code is " + std::to_string(refusal) + ")");
  } catch (...) {
    return wrong("it throws an exception when loaded");
  }
  return std::move(r.plugin);
}

// Returns whether a child process survives loading it. The parent checks the registered words when it loads the plug-in
// itself.
Status survives(const std::string& path) {
  const pid_t child = fork();
  if (child < 0) return fail(ErrorCode::machine, "cannot start a process to test it");
  if (child == 0) {
    for (int s : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGALRM}) std::signal(s, SIG_DFL);
    alarm(5);
    (void)open(path);
    _exit(0);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return fail(ErrorCode::machine, "the process that tests it was lost");
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return Nothing{};
  const bool slow = WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM;
  return fail(ErrorCode::file, slow ? "loading it takes more than 5 seconds" : "it crashes when loaded");
}

}  // namespace

Result<Plugin> load_plugin(const std::string& path) {
  const auto named = [&](const Error& e) { return fail(e.code, path + ": " + e.message, e.hint); };
  std::error_code none;
  if (!std::filesystem::exists(path, none)) return named(fail(ErrorCode::file, "no such file"));
  if (!std::filesystem::is_regular_file(path, none))
    return named(fail(ErrorCode::file, "not a plug-in: it is not a regular file"));
  if (const auto s = survives(path); !s) return named(s.error());
  auto plugin = open(path);
  if (!plugin) return named(plugin.error());
  return plugin;
}

}  // namespace betwixt
