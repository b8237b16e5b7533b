// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/terminal.h"

#include <chafa.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>

namespace betwixt {
namespace {

constexpr std::string_view enter =
    "\x1b[?1049h\x1b[?25l\x1b[?7l\x1b[2J";  // alternate screen, no cursor, no wrapping, clear
constexpr std::string_view leave = "\x1b[0m\x1b[?7h\x1b[?25h\x1b[?1049l";

termios saved{};
volatile sig_atomic_t raw = 0, on_stage = 0;

// Signal handlers call this too, so it uses only functions that are safe there.
void restore() {
  if (on_stage != 0) {
    on_stage = 0;
    [[maybe_unused]] const ssize_t n = ::write(STDOUT_FILENO, leave.data(), leave.size());
  }
  if (raw != 0) {
    raw = 0;
    ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &saved);
  }
}

void die(int signal) {
  restore();
  ::raise(signal);  // SA_RESETHAND: this time it ends the program
}

void catch_deaths() {
  struct sigaction action {};
  action.sa_handler = die;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_NODEFER);
  for (const int s : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGQUIT}) ::sigaction(s, &action, nullptr);
}

// Single keys without echo; Ctrl-C remains a signal.
bool make_raw() {
  if (::isatty(STDIN_FILENO) != 1 || ::tcgetattr(STDIN_FILENO, &saved) != 0) return false;
  termios t = saved;
  t.c_lflag &= static_cast<tcflag_t>(~(ECHO | ICANON | IEXTEN));
  t.c_cc[VMIN] = 0, t.c_cc[VTIME] = 0;
  t.c_cc[VSUSP] = _POSIX_VDISABLE;
  raw = 1;
  return ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &t) == 0;
}

ChafaCanvasMode colors_of(ChafaTermInfo* info) {
  const char* says = std::getenv("COLORTERM");
  const std::string_view color = says ? says : "";
  if (color == "truecolor" || color == "24bit" || chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_SET_COLOR_FGBG_DIRECT))
    return CHAFA_CANVAS_MODE_TRUECOLOR;
  if (chafa_term_info_have_seq(info, CHAFA_TERM_SEQ_SET_COLOR_FGBG_256)) return CHAFA_CANVAS_MODE_INDEXED_240;
  return CHAFA_CANVAS_MODE_INDEXED_16;
}

// The libchafa objects for a grid of characters; created again if its size changes.
class Canvas {
 public:
  Canvas(int columns, int rows) : columns_(columns), rows_(rows) {
    gchar** environment = g_get_environ();
    info_ = chafa_term_db_detect(chafa_term_db_get_default(), environment);
    g_strfreev(environment);
    ChafaSymbolMap* symbols = chafa_symbol_map_new();
    chafa_symbol_map_add_by_tags(
        symbols,
        static_cast<ChafaSymbolTags>(CHAFA_SYMBOL_TAG_BLOCK | CHAFA_SYMBOL_TAG_BORDER | CHAFA_SYMBOL_TAG_SPACE));
    ChafaCanvasConfig* config = chafa_canvas_config_new();
    chafa_canvas_config_set_geometry(config, columns, rows);
    chafa_canvas_config_set_canvas_mode(config, colors_of(info_));
    chafa_canvas_config_set_symbol_map(config, symbols);
    chafa_canvas_config_set_work_factor(config, 0.4f);
    canvas_ = chafa_canvas_new(config);
    chafa_canvas_config_unref(config);
    chafa_symbol_map_unref(symbols);
  }
  ~Canvas() {
    chafa_canvas_unref(canvas_);
    chafa_term_info_unref(info_);
  }
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  bool fits(int columns, int rows) const { return columns == columns_ && rows == rows_; }
  std::string draw(const Picture& p) {
    chafa_canvas_draw_all_pixels(canvas_, CHAFA_PIXEL_RGBA8_UNASSOCIATED, p.rgba.data(), p.width, p.height,
                                 p.width * 4);
    GString* text = chafa_canvas_print(canvas_, info_);
    std::string out(text->str, text->len);
    g_string_free(text, TRUE);
    return out;
  }

 private:
  const int columns_, rows_;
  ChafaTermInfo* info_ = nullptr;
  ChafaCanvas* canvas_ = nullptr;
};

struct Sequence {
  std::string_view typed;
  Key key;
};
constexpr std::array sequences{Sequence{"\x1b[1;2D", Key::shift_left},
                               Sequence{"\x1b[1;2C", Key::shift_right},
                               Sequence{"\x1b[D", Key::left},
                               Sequence{"\x1bOD", Key::left},
                               Sequence{"\x1b[C", Key::right},
                               Sequence{"\x1bOC", Key::right},
                               Sequence{"\x1b[A", Key::up},
                               Sequence{"\x1bOA", Key::up},
                               Sequence{"\x1b[B", Key::down},
                               Sequence{"\x1bOB", Key::down},
                               Sequence{"\x1b[H", Key::home},
                               Sequence{"\x1bOH", Key::home},
                               Sequence{"\x1b[1~", Key::home},
                               Sequence{"\x1b[7~", Key::home},
                               Sequence{"\x1b[F", Key::end},
                               Sequence{"\x1bOF", Key::end},
                               Sequence{"\x1b[4~", Key::end},
                               Sequence{"\x1b[8~", Key::end},
                               Sequence{" ", Key::space},
                               Sequence{"s", Key::style},
                               Sequence{"a", Key::samples},
                               Sequence{"+", Key::larger},
                               Sequence{"-", Key::smaller},
                               Sequence{"m", Key::mute},
                               Sequence{"q", Key::quit},
                               Sequence{"Q", Key::quit},
                               Sequence{"\x03", Key::quit}};

}  // namespace

std::vector<Key> read_keys(std::string_view typed) {
  std::vector<Key> keys;
  while (!typed.empty()) {
    const auto known =
        std::find_if(sequences.begin(), sequences.end(), [&](const Sequence& s) { return typed.starts_with(s.typed); });
    if (known != sequences.end()) {
      keys.push_back(known->key);
      typed.remove_prefix(known->typed.size());
      continue;
    }
    std::size_t length = 1;  // an unknown control sequence ends with a letter or ~
    if (typed.starts_with("\x1b[")) {
      length = 2;
      while (length < typed.size() && (typed[length] < '@' || typed[length] > '~')) ++length;
      length = std::min(length + 1, typed.size());
    }
    typed.remove_prefix(length);
  }
  return keys;
}

Result<std::unique_ptr<Terminal>> Terminal::open() {
  if (::isatty(STDOUT_FILENO) != 1)
    return fail(ErrorCode::type, "play needs a terminal, but standard output is not one",
                "to make a film: betwixt render FILE -o film.mp4");
  catch_deaths();
  const bool keys = make_raw();
  on_stage = 1;
  std::unique_ptr<Terminal> terminal(new Terminal(keys));
  terminal->write(enter);
  return terminal;
}

Terminal::~Terminal() { restore(); }

TerminalSize Terminal::size() const {
  TerminalSize s;
  winsize w{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &w) != 0 || w.ws_col == 0 || w.ws_row == 0) return s;
  s.columns = w.ws_col, s.rows = w.ws_row;
  if (w.ws_xpixel > 0 && w.ws_ypixel > 0)
    s.cell_aspect = std::clamp((1.0 * w.ws_xpixel / w.ws_col) / (1.0 * w.ws_ypixel / w.ws_row), 0.25, 1.5);
  return s;
}

bool Terminal::write(std::string_view text) const {
  while (!text.empty()) {
    const ssize_t n = ::write(STDOUT_FILENO, text.data(), text.size());
    if (n < 0 && errno == EAGAIN) {
      pollfd out{STDOUT_FILENO, POLLOUT, 0};
      ::poll(&out, 1, 100);
    } else if (n < 0 && errno != EINTR) {
      return false;
    }
    if (n > 0) text.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

std::vector<Key> Terminal::wait(double seconds, bool& closed) const {
  pollfd in{keys_ ? STDIN_FILENO : -1, POLLIN, 0};
  if (::poll(&in, 1, static_cast<int>(std::ceil(1000 * std::max(0.0, seconds)))) <= 0) return {};
  std::array<char, 256> typed;
  const ssize_t n = ::read(STDIN_FILENO, typed.data(), typed.size());
  closed = n == 0 || (n < 0 && errno != EINTR && errno != EAGAIN);
  return n > 0 ? read_keys({typed.data(), static_cast<std::size_t>(n)}) : std::vector<Key>{};
}

Cells largest_cells(const TerminalSize& size, int rows, double aspect) {
  const double shape = aspect / size.cell_aspect;  // in cells
  Cells c;
  c.columns = std::clamp(static_cast<int>(std::lround(rows * shape)), 1, size.columns);
  c.rows = std::clamp(static_cast<int>(std::lround(c.columns / shape)), 1, rows);
  c.column = 1 + (size.columns - c.columns) / 2, c.row = 1 + (rows - c.rows) / 2;
  return c;
}

std::string characters(const Picture& picture, const Cells& cells) {
  static std::unique_ptr<Canvas> canvas;
  if (!canvas || !canvas->fits(cells.columns, cells.rows)) canvas = std::make_unique<Canvas>(cells.columns, cells.rows);
  const std::string lines = canvas->draw(picture);
  std::string out;
  int row = cells.row;
  for (std::size_t from = 0; from < lines.size(); ++row) {
    const std::size_t to = std::min(lines.find('\n', from), lines.size());
    out += fmt::format("\x1b[{};{}H", row, cells.column) + lines.substr(from, to - from);
    from = to + 1;
  }
  return out + "\x1b[0m";
}

}  // namespace betwixt
