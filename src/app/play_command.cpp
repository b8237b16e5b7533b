// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>

#include "app/command.h"
#include "app/hearing.h"
#include "app/live_input.h"
#include "app/streams.h"
#include "app/studio.h"
#include "app/subcommand.h"
#include "app/terminal.h"
#include "base/counted.h"
#include "base/files.h"
#include "base/tell_user.h"
#include "base/utf8.h"
#include "betwixt/program.h"
#include "editor/controls.h"
#include "editor/describe.h"
#include "playback/film_player.h"
#include "playback/playhead.h"
#include "scene/document.h"

namespace betwixt {
namespace {

struct PlayCall {
  std::string file, frames, listen, record;
  PictureCall picture{{.width = 960, .height = 540, .samples = 1, .device = Device::automatic}};
  bool terminal = false, loop = false, mute = false, overwrite = false;
  std::string said = "--frames";  // the caller's name for the frames, in errors
};

class Player {
 public:
  // `live`: messages of controls, or null. `take`: records them, or null.
  Player(const Document& document, PlayCall& call, const FrameList& frames, Terminal& terminal, LiveInput* live,
         Take* take)
      : document_(document),
        program_(Program::compile(document)),
        call_(call),
        frames_(frames),
        terminal_(terminal),
        live_(live),
        take_(take),
        hearing_(Hearing::open(program_, frames, call.loop)) {
    head_.set(frames.rate, Time{}, frames.rate.span(last()));
    head_.loop(call.loop);
    head_.play(1);
  }

  Status run() {
    // The clock starts after the first picture, however long that takes.
    if (Status s = show(0); !s) return s;
    if (hearing_) hearing_->await_beginning();
    jump(0);
    bool closed = false;
    while (!stop_requested() && !closed && !quit_) {
      const int k = now();
      if (head_.ended()) head_.pause();
      obey(k);
      if (hearing_) hearing_->follow(program_, head_.place(), call_.mute);
      if (Status s = show(k); !s) return s;
      if (!terminal_.has_keys() && !head_.playing()) break;  // without keys, playback could not be resumed
      const double pause = head_.playing() ? std::min(head_.until_next(), 0.25) : live_ ? 0.02 : 0.1;
      for (const Key key : terminal_.wait(pause, closed)) press(key);
    }
    if (take_) take_->end(frames_.time(taken_ + 1));
    return Nothing{};
  }
  // Returns how many messages changed a target.
  std::size_t turned() const { return turned_; }

 private:
  int last() const { return frames_.count - 1; }
  // The playhead counts from the first frame of the list.
  int now() const { return static_cast<int>(frames_.rate.whole(head_.now())); }
  void jump(int k) { head_.go_to(frames_.rate.span(std::clamp(k, 0, last()))); }

  // Applies the messages received since the last picture to the next frame.
  void obey(int k) {
    if (!live_) return;
    bool turned = false;
    if (take_ && (k < taken_ || sought_)) take_->end(frames_.time(taken_ + 1)), turned = true;
    taken_ = k, sought_ = false;
    for (const LiveMessage& m : live_->poll()) {
      const Status done = obey(m, frames_.time(k));
      said_ = done ? in_words(m) : done.error().message;
      if (!done && !done.error().hint.empty()) said_ += ", " + done.error().hint;
      if (done) ++turned_, turned = true;
    }
    if (!turned) return;
    if (take_) document_ = take_->document();
    program_ = Program::compile(document_, program_);
    stale_ = true;
  }
  Status obey(const LiveMessage& m, Time now) {
    const std::string* text = m.text ? &*m.text : nullptr;
    if (take_) return take_->turn(m.address, m.numbers, text, now, m.within);
    Result<Document> next = turn(document_, m.address, m.numbers, text);
    if (!next) return next.error();
    document_ = *std::move(next);
    return Nothing{};
  }

  void press(Key key) {
    const int second = std::max(1, static_cast<int>(std::lround(frames_.rate.per_second())));
    const int k = now();
    const auto seek = [&](int to) { jump(to), sought_ = true; };
    const auto step = [&](int by) { head_.pause(), seek(k + by); };
    switch (key) {
      case Key::space:
        return head_.playing() ? head_.pause() : head_.play(1);
      case Key::left:
        return step(-1);
      case Key::right:
        return step(1);
      case Key::shift_left:
      case Key::down:
        return seek(k - second);
      case Key::shift_right:
      case Key::up:
        return seek(k + second);
      case Key::home:
        return seek(0);
      case Key::end:
        return step(frames_.count);
      case Key::style:
      case Key::samples:
      case Key::larger:
      case Key::smaller:
        return alter(key);
      case Key::mute:
        call_.mute = !call_.mute;
        return;
      case Key::quit:
        quit_ = true;
    }
  }

  // Changes the style, the samples or the size at once.
  void alter(Key key) {
    RenderOptions p = call_.picture.of(document_);
    const auto next = [](const auto& all, const auto& now) {
      const auto at = std::find(std::begin(all), std::end(all), now);
      return at == std::end(all) || at + 1 == std::end(all) ? *std::begin(all) : *(at + 1);
    };
    if (key == Key::style) {
      std::vector<std::string> names;
      for (const Style& s : styles()) names.emplace_back(s.name);
      p.style = next(names, p.style);
    }
    if (key == Key::samples) p.samples = next(std::array{1, 4, 9, 16}, p.samples);
    const bool grows = key == Key::larger && p.width <= 4096 && p.height <= 4096;
    const bool shrinks = key == Key::smaller && p.width >= 32 && p.height >= 32;
    if (grows) p.width *= 2, p.height *= 2;
    if (shrinks) p.width /= 2, p.height /= 2;
    call_.picture = {p, std::pair(p.width, p.height), p.samples, p.pixel_filter};
    size_ = {0, 0};
    altered_ = fmt::format("{} {}x{} {}", p.style, p.width, p.height, p.samples);
  }

  // Makes pictures as large as the characters can show, but not larger than the film's size.
  void fit(const TerminalSize& size) {
    if (size == size_) return;
    size_ = size;
    options_ = call_.picture.of(document_);
    // The last row is for the status line.
    cells_ = largest_cells(size, std::max(1, size.rows - 1), static_cast<double>(options_.width) / options_.height);
    const double shrink = std::min(1.0, 8.0 * cells_.columns / options_.width);  // 8 pixels distinguish all symbols
    options_.width = std::max(1, static_cast<int>(std::lround(options_.width * shrink)));
    options_.height = std::max(1, static_cast<int>(std::lround(options_.height * shrink)));
    shown_ = -1;
    terminal_.write("\x1b[2J");
  }

  Status show(int k) {
    fit(terminal_.size());
    listen(k);
    std::string out = "\x1b[?2026h";  // terminals that support it show the picture as a whole
    if (k != shown_ || stale_) {
      stale_ = false;
      film_.evaluate(program_, frames_.time(k));
      if (Status s = film_.draw(options_, picture_); !s) return s;
      if (head_.playing() && shown_ >= 0 && k > shown_ + 1) dropped_ += k - shown_ - 1;
      shown_ = k;
      out += characters(picture_, cells_);
    }
    out += status(k) + "\x1b[?2026l";
    if (out != last_drawn_) terminal_.write(out);
    last_drawn_ = out;
    return Nothing{};
  }

  // Shows notes that playback has passed, or that are exactly at the frame after a jump.
  void listen(int k) {
    if (k == heard_) return;
    const bool passed = (head_.playing() || k == last()) && k > heard_;
    std::optional<Time> after;
    if (passed) after = heard_ < 0 ? frames_.first - Time{1} : frames_.time(heard_);
    heard_ = k;
    if (!passed) note_.clear();
    const Time to = k == last() ? std::max(frames_.time(k), frames_.last) : frames_.time(k);
    if (std::string words = notes_shown(document_, after, to); !words.empty())
      note_ = std::move(words), noted_ = Playhead::Clock::now();
    if (Playhead::seconds_since(noted_) > 3 && head_.playing()) note_.clear();
  }

  std::string status(int k) const {
    const Time t = frames_.time(k);
    std::string left = fmt::format(" {} {}/{}  {:.2f} s", head_.playing() ? ">" : "=", frames_.number + k,
                                   frames_.number + last(), t.seconds());
    if (dropped_ > 0) left += fmt::format("  {} dropped", dropped_);
    if (hearing_ && !hearing_->has_device())
      left += "  no sound device";
    else if (hearing_ && call_.mute)
      left += "  muted";
    // The message comes after the counts, because it is what can be too long for the line.
    if (live_ && live_->ignored() > 0) left += fmt::format("  {} ignored", live_->ignored());
    if (live_) left += "  " + (said_.empty() ? "listening" : legible(said_));
    if (!altered_.empty()) left += "  " + altered_;
    if (!note_.empty()) left += "  " + note_;
    const std::string keys = terminal_.has_keys() ? "space pause  arrows step  s style  q quit " : "";
    const std::size_t columns = static_cast<std::size_t>(size_.columns);
    std::string line = visible(left);
    const std::size_t used = count_characters(line);
    if (used > columns)
      line = first_characters(line, columns);
    else if (used + keys.size() + 1 <= columns)
      line += std::string(columns - used - keys.size(), ' ') + keys;
    else
      line += std::string(columns - used, ' ');
    return fmt::format("\x1b[{};1H\x1b[7m{}\x1b[0m", size_.rows, line);
  }
  // Replaces control characters: messages come from the network, and a terminal would obey them.
  static std::string legible(std::string text) {
    for (char& c : text)
      if (c < 32 || c > 126) c = '?';
    return text.substr(0, 100);
  }

  Document document_;
  Program program_;
  PlayCall& call_;  // keys change its picture
  const FrameList& frames_;
  Terminal& terminal_;
  LiveInput* const live_;
  Take* const take_;
  int taken_ = 0;        // the frame of the last messages
  bool sought_ = false;  // a key has moved the playhead since then
  Playhead head_;
  const std::unique_ptr<Hearing> hearing_;  // null if the film has no sounds
  bool quit_ = false;
  TerminalSize size_{0, 0};  // 0: the options do not fit yet
  RenderOptions options_;    // of the pictures shown
  Cells cells_;
  FilmPlayer film_;
  Picture picture_;
  int shown_ = -1, heard_ = -1, dropped_ = 0;
  bool stale_ = false;  // the picture is older than the document
  std::size_t turned_ = 0;
  std::string note_, said_, last_drawn_, altered_;
  Playhead::Clock::time_point noted_ = Playhead::Clock::now();
};

// Returns the file for the recording, or "" if there is none. Checks before playback that the file can be written.
Result<std::string> record_place(const Document& document, const PlayCall& call) {
  if (call.listen.empty() && !call.record.empty())
    return fail(ErrorCode::range, "--record needs live input", "to receive live input: --listen PORT");
  if (call.listen.empty() || (call.record.empty() && !document.scene().recording)) return std::string();
  const std::filesystem::path script = call.file;
  const std::string place =
      call.record.empty() ? (script.parent_path() / script.stem()).string() + "-recorded.bx" : call.record;
  if (Status free = check_place(place, call.overwrite); !free) {
    Error e = free.error();
    if (e.hint.empty()) e.hint = "write --record OUT.bx; to replace a file, add --overwrite";
    return e;
  }
  return place;
}

// Writes the author's text, comments included, with the recording at its end. If the script was edited during playback,
// that would be another film; then it writes the recorded document without comments.
Status write_recording(const Take& take, const std::string& script, const std::string& place, bool overwrite) {
  std::string text;
  if (const auto read = script_text(script)) text = take.text(*read);
  if (!(load_text(text, script, load_options()).document == take.document())) {
    fmt::print(stderr, "the script changed while recording, so the recording has no comments\n");
    text = write(take.document());
  }
  return write_whole(place, text, overwrite);
}

Status play(const Document& document, PlayCall& call) {
  const Result<FrameList> frames = read_frames(call.frames, document, call.said);
  if (!frames) return frames.error();
  const Result<std::string> place = record_place(document, call);
  if (!place) return place.error();
  std::unique_ptr<LiveInput> live;
  if (!call.listen.empty()) {
    Result<std::unique_ptr<LiveInput>> opened = LiveInput::open(call.listen);
    if (!opened) return opened.error();
    live = *std::move(opened);
  }
  catch_stops();
  Result<std::unique_ptr<Terminal>> terminal = Terminal::open();
  if (!terminal) return terminal.error();
  const bool records = !place->empty();
  Take take(document);
  Player player(document, call, *frames, **terminal, live.get(), records ? &take : nullptr);
  const Status played = player.run();
  terminal->reset();
  if (!records) return played;
  if (player.turned() == 0) {
    fmt::print(stderr, "no input arrived, so nothing was recorded\n");
    return played;
  }
  if (Status s = write_recording(take, call.file, *place, call.overwrite); !s) return s;
  tell_user(fmt::format("{} recorded in '{}'\n", counted(player.turned(), "message"), *place));
  return played;
}

// Returns whether to play in a window: there is a display and a studio, and the call needs no terminal.
bool in_a_window(const PlayCall& call) {
  return !call.terminal && !is_stream(call.file) && call.listen.empty() && call.frames.empty() && has_display() &&
         has_studio();
}

int play(PlayCall& call) {
  if (in_a_window(call)) {
    std::vector<std::string> arguments{"--bare"};
    if (call.loop) arguments.emplace_back("--loop");
    if (call.mute) arguments.emplace_back("--mute");
    if (call.picture.size)
      arguments.insert(arguments.end(),
                       {"--size", fmt::format("{}x{}", call.picture.size->first, call.picture.size->second)});
    arguments.insert(arguments.end(), {"--style", call.picture.otherwise.style});
    return complain(become_studio(std::move(arguments), {call.file}).error(), machine_failed);
  }
  const std::optional<Document> document = open_script(call.file);
  if (!document) return wrong_input;
  if (Status played = play(*document, call); !played) return complain(played.error(), wrong_call);
  return stop_requested() ? interrupted : all_done;
}

}  // namespace

Status play_document(const Document& document, const std::string& frames, PictureCall& picture) {
  PlayCall call;
  call.frames = frames.empty() || frames.find("..") != std::string::npos ? frames : frames + "..";
  call.said = "play", call.picture = picture;
  const Status played = play(document, call);
  picture = call.picture;
  return played;
}

namespace {

// The options for live input.
std::vector<Parameter> live_parameters(PlayCall& call) {
  return {{.name = "--listen",
           .value = "[HOST:]PORT",
           .sentence = "controls the targets of the script's dials by OSC sent to this port, and by MIDI. Only this "
                       "machine can send, unless you name another address of it",
           .into = &call.listen},
          file_option("--record", "OUT.bx", "at the end, writes a script with the recorded input", &call.record),
          flag("--overwrite", "lets --record replace a file", call.overwrite)};
}

const Enlisted enlisted_play(play, [](PlayCall& call) -> Subcommand {
  return {
      .rank = 30,
      .name = "play",
      .sentence = "plays in real time: in a window, or in the terminal",
      .takes =
          joined({{script_parameter(call.file),
                   flag("--terminal", "plays in the terminal, even if there is a display", call.terminal),
                   frames_parameter(call.frames), section_parameter(call.frames)},
                  picture_parameters(call.picture),
                  {flag("--loop", "repeats the film", call.loop), flag("--mute", "plays without sound", call.mute)},
                  live_parameters(call)}),
      .note =
          "Keys: space pauses and continues; left and right go a frame back and forward, up and down a second; home "
          "and end go to the first and the last frame; s changes the style, a the samples (anti-aliasing), + and - "
          "the size; m mutes; q quits.",
      .example = "betwixt play examples/bounce.bx --terminal --loop",
      .manual =
          "The window is the studio's, without its panels. It opens if there is a display and the studio is built, "
          "unless you use an option of the terminal (--terminal, --listen, --frames). If frames come too late, some "
          "are left out, so the film keeps its speed."};
});

}  // namespace
}  // namespace betwixt
