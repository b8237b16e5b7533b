// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// The server's history: the start from a script or from an earlier server's history, the words about it, and the
// checkpoints that keep log and memory small.
#include <fmt/format.h>

#include <cctype>
#include <charconv>
#include <filesystem>
#include <numeric>

#include "base/files.h"
#include "base/free_beside.h"
#include "exchange/sent.h"
#include "language/json.h"
#include "scene/memory.h"
#include "server/answers.h"
#include "server/imaging.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

// Hosts build names such as O3000 from numbers that the server gives them, a thousand at once (betwixt/aim.h).
constexpr std::int64_t names_at_once = 1000, last_name = 2'147'483'647;
constexpr Time time_ahead{2 * flicks_per_second};  // the most that the clock jumps ahead after the server was killed
constexpr std::string_view name_letters = "EOT";

// Returns one path for each file, also if the file does not exist.
fs::path real(const std::string& file) {
  std::error_code ignored;
  return fs::weakly_canonical(fs::absolute(file, ignored), ignored);
}

bool is_there(const std::string& file) {
  std::error_code ignored;
  return fs::exists(file, ignored);
}

// Collects the thousands of the numbers that a text already uses in names, so that hosts never get them.
void find_names(std::string_view text, std::set<std::int64_t>& thousands) {
  const auto part_of_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (std::size_t i = text.find_first_of(name_letters); i < text.size(); i = text.find_first_of(name_letters, i + 1)) {
    if (i > 0 && part_of_name(text[i - 1])) continue;
    std::int64_t number = 0;
    std::from_chars(text.data() + i + 1, text.data() + text.size(), number);  // stays 0 if it is too large
    if (number >= names_at_once && number <= last_name) thousands.insert(number / names_at_once);
  }
}

Diagnostic remark(const std::string& text) { return {Severity::warning, fail(ErrorCode::file, text), {}, 0}; }

}  // namespace

// Reads the script to start with, and the history that an earlier server left.
Result<StoredHistory> Imaging::gather(const std::string& from, bool goes_on, bool overwrite) {
  std::optional<std::string> text = "";
  if (!from.empty()) {
    const auto there = read_script(from);
    if (!there) return there.error();
    if (!*there && !goes_on) return no_file(from);
    text = *there;
  }
  StoredHistory kept;
  kept.base = text.value_or("");
  if (save_.empty()) return kept;
  if (!goes_on && !overwrite) {
    const auto there = read_script(save_);
    if (!there) return there.error();
    if (*there && !(*there)->empty())
      return fail(ErrorCode::file, fmt::format("--save: '{}' already exists", save_),
                  fmt::format("to replace it: --overwrite; to continue it: betwixt serve {} --save {}", save_, save_));
  }
  if (Status s = history_.hold(save_); !s) return s.error();
  if (!goes_on && overwrite) return kept;
  auto found = history_.found(goes_on ? text : std::nullopt);
  if (!found || goes_on) return found;
  kept.remarks = found->remarks;  // a journal whose script no longer exists
  return kept;
}

Result<Diagnostics> Imaging::begin(const std::string& file, const std::string& save, bool overwrite, Nanos now) {
  const bool goes_on = !save.empty() && (file.empty() ? !overwrite && (is_there(save) || is_there(journal_path(save)))
                                                      : real(file) == real(save));
  const std::string from = goes_on ? save : file;
  if (!save.empty() && !from.empty() && real(from).parent_path() != real(save).parent_path())
    return fail(ErrorCode::file, fmt::format("--save: '{}' is not in the same folder as '{}'", save, from),
                "a script's file names are relative to its folder, so its history must be in the same folder");
  name_ = save.empty() ? from : save, save_ = save;
  const auto kept = gather(from, goes_on, overwrite);
  if (!kept) return kept.error();
  author_ = options_.load;
  if (!save.empty()) sent::find_again(std::filesystem::path(save).parent_path() / sent::folder_name);
  // From here on, hosts write to the document, and they have fewer rights than the script's author.
  options_.load.read_anywhere = options_.load.tex = false;
  options_.load.read_nothing = name_.empty();
  std::vector<SetAside> aside;
  auto all = begin_script(*kept, goes_on, aside);
  if (!all || has_errors(*all)) return all;
  const bool mended = !aside.empty();
  if (!kept->remarks.empty()) all->push_back(remark(kept->remarks.substr(0, kept->remarks.size() - 1)));
  editor_.allow(options_.load);
  if (Status s = begin_steps(kept->steps, aside); !s) return s.error();
  if (!aside.empty()) {
    if (Status s = set_aside(save, aside); !s) return s.error();
    all->push_back(remark(set_aside_message(save, aside)));
  }
  find_names(history(), names_given_);
  event_count_ = count_events({}, 0, document().scene().objects);
  values_ = bytes_of_values(document().scene());
  editor_.count({event_count_, values_});
  if (Status s = begin_history(*kept, mended, !aside.empty()); !s) return s.error();
  checkpoint_at_ = history_.length() + checkpoint_every();
  begun_ = latest_ = now;
  if (Status s = begin_time(*kept, goes_on, now); !s) return s.error();
  return all;
}

// An earlier server's text had no errors then. Lines that have one now are set aside.
Result<Diagnostics> Imaging::begin_script(const StoredHistory& kept, bool goes_on, std::vector<SetAside>& aside) {
  std::string text = kept.base;
  Diagnostics all = editor_.begin(text, name_);
  if (!has_errors(all) || !goes_on) return all;
  if (Status s = open_time(); !s) return s.error();
  for (std::size_t left = time_file_->is_of(kept.script) ? time_file_->text_size() : 0; has_errors(all);) {
    auto mended = without_errors(text, name_, left, all);
    if (!mended) break;
    left -= std::min(left, text.size() - mended->text.size());
    text = std::move(mended->text);
    aside.insert(aside.end(), mended->lines.begin(), mended->lines.end());
    all = editor_.begin(text, name_);
  }
  return all;
}

// Carries out an earlier server's steps. A step that fails, or that ends the process, is set aside.
Status Imaging::begin_steps(StepList steps, std::vector<SetAside>& aside) {
  if (steps.all.empty()) return Nothing{};
  if (Status s = open_time(); !s) return s;
  const auto where = [](std::size_t number) { return fmt::format("command {} of the journal", number + 1); };
  std::vector<std::size_t> numbers(steps.all.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  const auto carry_out = [&](std::size_t n) {
    auto left_out = editor_.restore(std::span(steps.all).first(n), std::min(n, steps.standing));
    program_ = Program::compile(document());
    (void)program_.frame(options_.from_start ? Time{} : time_file_->found().value_or(KeptTime{}).at);
    return left_out;
  };
  const StartMark mark(save_);
  while (const auto culprit = mark.found() ? find_culprit(steps.all.size(), carry_out) : std::nullopt) {
    const auto n = static_cast<std::ptrdiff_t>(culprit->number);
    aside.push_back({where(numbers[culprit->number]), steps.all[culprit->number],
                     fmt::format("it crashes the program ({})", culprit->how)});
    numbers.erase(numbers.begin() + n), steps.all.erase(steps.all.begin() + n);
    if (culprit->number < steps.standing) --steps.standing;
  }
  for (FailedStep& l : carry_out(steps.all.size()))
    aside.push_back({where(numbers[l.number]), std::move(l.step), why_refused(l.why)});
  compiled_ = version_;
  return Nothing{};
}

// Brings the files in line with the document. `mended`: the script has lost lines. `less`: the journal has lost steps.
Status Imaging::begin_history(const StoredHistory& kept, bool mended, bool less) {
  if (save_.empty()) return Nothing{};
  if (!kept.goes_on) {
    if (Status s = history_.keep(kept.base); !s) return s;
  } else if (less) {
    if (Status s = history_.go_on_with(kept.base, editor_.steps(), editor_.undone(), kept.script); !s) return s;
  } else {
    history_.go_on(editor_.steps(), editor_.undone(), kept.script);
  }
  if (!mended) return Nothing{};
  const auto beside = write_beside(save_, editor_.base());
  return beside ? history_.replace(*beside, editor_.steps(), editor_.undone()) : Status(beside.error());
}

Status Imaging::open_time() {
  if (save_.empty() || time_file_) return Nothing{};
  auto file = TimeFile::open(save_);
  if (!file) return file.error();
  time_file_.emplace(*std::move(file));
  return Nothing{};
}

// The clock starts from the history: at its time, running or paused as the last server left it.
Status Imaging::begin_time(const StoredHistory& kept, bool goes_on, Nanos now) {
  transport_ = {!options_.wait, now, Time{}};
  if (Status s = open_time(); !s || !time_file_) return s;
  const auto& was = time_file_->found();
  if (was && goes_on && !options_.from_start && (kept.goes_on || time_file_->is_of(kept.base)))
    transport_ = {was->running, now, was->at}, told_ = was->at;
  return keep_time();
}

// While the clock runs, the time in the file is ahead of it. So one write covers all answers up to that time.
Status Imaging::keep_time() {
  if (!time_file_) return Nothing{};
  const Time time = transport_.time(latest_);
  const bool same = kept_transport_ == transport_ && kept_time_.running == transport_.running;
  if (same && (!transport_.running || time < kept_time_.at)) return Nothing{};
  kept_transport_ = transport_;
  kept_time_ = {transport_.running, transport_.running ? time + time_ahead : time};
  return time_file_->write(kept_time_, history_.known());
}

std::optional<Nanos> Imaging::sync_again() const {
  if (!time_file_ || !transport_.running) return std::nullopt;
  return transport_.when(kept_time_.at);
}

// Half of the limit on the history, if that is smaller.
std::size_t Imaging::checkpoint_every() const { return std::min(options_.checkpoint, options_.ceilings.history / 2); }

Status Imaging::sync(Nanos now) {
  latest_ = std::max(latest_, now);
  go_on_with_checkpoint();
  if (Status s = keep_time(); !s) return s;
  return history_.sync();
}

// Takes the next step of a checkpoint. All that takes long happens on other threads.
void Imaging::go_on_with_checkpoint() {
  if (!checkpoint_) {
    if (history_.length() > checkpoint_at_ && editor_.settled() > 0)
      checkpoint_.emplace(editor_.settled_document(), editor_.settled(), name_, save_, author_,
                          options_.checkpoint_step);
  } else if (history_.goes_over()) {
    if (const auto done = history_.gone_over()) end_checkpoint(*done);
  } else if (checkpoint_->done()) {
    if (const Status s = go_over_to_checkpoint(); !s || save_.empty()) end_checkpoint(s);
  }
}

// The checkpoint is written. Steps accepted since it began follow it.
Status Imaging::go_over_to_checkpoint() {
  if (!checkpoint_->script()) return checkpoint_->script().error();
  if (auto next = checkpoint_->take_next()) return history_.go_over_to(*std::move(next));
  history_.measure(editor_.steps().subspan(checkpoint_->steps()), editor_.undone());
  return Nothing{};
}

void Imaging::end_checkpoint(const Status& done) {
  if (done)
    free_beside(editor_.settle(checkpoint_->take_script(), checkpoint_->steps()));
  else if (options_.warn)
    options_.warn(fmt::format("the journal cannot be shortened: {}", done.error().message));
  checkpoint_.reset();
  checkpoint_at_ = history_.length() + checkpoint_every();
}

// Waits until the files of a checkpoint are in place, if that has begun.
void Imaging::end_change() {
  history_.wait();
  if (const auto done = history_.gone_over()) end_checkpoint(*done);
}

Status Imaging::finish(Nanos now) {
  if (save_.empty()) return Nothing{};
  latest_ = std::max(latest_, now);
  end_change();
  checkpoint_.reset();
  if (Status s = history_.save(editor_.base(), editor_.steps(), editor_.undone()); !s) return s;
  if (Status s = time_file_->write({transport_.running, transport_.time(latest_)}, history_.known()); !s) return s;
  history_.finish();
  return Nothing{};
}

// ---- words

Result<std::string> Imaging::history_word(HostState&, const std::vector<std::string>&, Nanos) {
  return asked([text = history()](const Film&) { return said(text); });
}

Imaging::Reply Imaging::step(HostState& h, Did what, Nanos now) {
  const Point before = editor_.now();
  if (Status s = what == Did::undo ? editor_.undo() : editor_.redo(); !s) return no(h, now, s.error());
  if (const auto& counts = editor_.now().counts)
    event_count_ = counts->events, values_ = counts->values;
  else
    recount(before.document);
  changed(0, json_text(what == Did::undo ? "undo" : "redo"), now);
  return yes(h, now, "");
}

// Counts the events after an undo or redo.
void Imaging::recount(const Document& before) {
  const Scene &was = before.scene(), &is = document().scene();
  if (is.objects.size() >= was.objects.size())
    event_count_ = count_events(was.objects, event_count_, is.objects);
  else
    event_count_ -= count_events(is.objects, 0, was.objects);  // events of the objects that are gone
  values_ = bytes_of_values(is);
}

Result<std::string> Imaging::save(HostState&, const std::vector<std::string>& w, Nanos) {
  if (w.size() > 1)
    return fail(ErrorCode::name, "a host cannot choose the file", "choose it by betwixt serve --save FILE");
  if (save_.empty())
    return fail(ErrorCode::name, "this server saves no history", "choose it by betwixt serve --save FILE");
  end_change();
  if (Status s = history_.save(editor_.base(), editor_.steps(), editor_.undone()); !s) return s.error();
  return said(fmt::format("saved '{}'", save_));
}

Result<std::string> Imaging::set_aside_word(HostState&, const std::vector<std::string>&, Nanos) {
  const auto text = save_.empty() ? Result(std::optional<std::string>()) : read_script(set_aside_path(save_));
  if (!text) return text.error();
  return said(text->value_or(""));
}

// Gives a thousand numbers. Never gives one twice, nor one that a name in the document already uses.
Result<std::string> Imaging::names(HostState&, const std::vector<std::string>&, Nanos) {
  const Scene& scene = document().scene();
  const auto taken = [&](std::int64_t thousand) {
    if (names_given_.contains(thousand)) return true;
    for (std::int64_t n = thousand * names_at_once; n < (thousand + 1) * names_at_once; ++n)
      for (const char letter : name_letters)
        if (const std::string name = fmt::format("{}{}", letter, n);
            scene.names.find(name) || scene.lists->contains(name))
          return true;
    return false;
  };
  while (taken(next_names_)) ++next_names_;
  const std::int64_t first = next_names_ * names_at_once;
  if (first + names_at_once - 1 > last_name) return fail(ErrorCode::range, "there are no more numbers for names");
  ++next_names_;
  return fmt::format(",\"first\":{},\"last\":{}", first, first + names_at_once - 1);
}

}  // namespace betwixt
