// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/alignment.h"

#include <fmt/format.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>

#include "app/pronunciation.h"
#include "base/child.h"
#include "base/counted.h"
#include "base/files.h"
#include "base/utf8.h"
#include "exchange/sounds.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

constexpr const char* model_folder = "/usr/share/pocketsphinx/model/en-us";
constexpr const char* how_to_install = "sudo apt-get install pocketsphinx pocketsphinx-en-us espeak-ng";
constexpr std::size_t most_aligned = 100'000;  // words
constexpr std::size_t level_step = speech_rate / 200;
constexpr double frame_length = 0.01;  // seconds of a frame of the program

class AlignmentFolder {
 public:
  AlignmentFolder() {
    std::error_code why;
    std::string name = (fs::temp_directory_path(why) / "betwixt-words-XXXXXX").string();
    if (!why && ::mkdtemp(name.data()) != nullptr) at_ = name;
  }
  ~AlignmentFolder() {
    std::error_code ignored;
    if (!at_.empty()) fs::remove_all(at_, ignored);
  }
  AlignmentFolder(const AlignmentFolder&) = delete;
  AlignmentFolder& operator=(const AlignmentFolder&) = delete;
  bool made() const { return !at_.empty(); }
  std::string operator/(const std::string& name) const { return (at_ / name).string(); }
  std::string path() const { return at_.string(); }

 private:
  fs::path at_;
};

// Takes every third sample after a low-pass filter: 48 kHz to 16 kHz.
class Thinner {
 public:
  explicit Thinner(std::vector<float>& out) : out_(out) {
    double sum = 0;
    for (int i = 0; i < taps; ++i) {
      const double x = i - (taps - 1) / 2.0, cut = 7200.0 / sound_rate;
      const double ideal = x == 0 ? 2 * cut : std::sin(2 * M_PI * cut * x) / (M_PI * x);
      filter_[static_cast<std::size_t>(i)] = ideal * (0.54 - 0.46 * std::cos(2 * M_PI * i / (taps - 1)));
      sum += filter_[static_cast<std::size_t>(i)];
    }
    for (double& f : filter_) f /= sum;
    last_.assign((taps - 1) / 2, 0);
  }
  void put(std::span<const float> stereo) {
    for (std::size_t i = 0; i + 1 < stereo.size(); i += 2) last_.push_back((stereo[i] + stereo[i + 1]) / 2);
    std::size_t at = 0;
    for (; at + taps <= last_.size(); at += 3) {
      double sum = 0;
      for (std::size_t k = 0; k < taps; ++k) sum += filter_[k] * static_cast<double>(last_[at + k]);
      out_.push_back(std::isfinite(sum) ? static_cast<float>(std::clamp(sum, -1.0, 1.0)) : 0);
    }
    last_.erase(last_.begin(), last_.begin() + static_cast<std::ptrdiff_t>(at));
  }

 private:
  static constexpr int taps = 95;
  std::array<double, taps> filter_{};
  std::vector<float> last_, &out_;
};

Status put_samples(const std::string& path, std::span<const float> samples) {
  std::string bytes;
  bytes.reserve(2 * samples.size());
  for (const float s : samples) {
    const auto n = static_cast<std::int16_t>(std::lround(32767 * s));
    bytes += static_cast<char>(n & 0xFF), bytes += static_cast<char>(n >> 8);
  }
  return write_whole(path, bytes, true);
}

// The dictionary has an entry for each word of the text, w1 to wN, and the grammar a transition for each, in order.
Status put_grammar(const AlignmentFolder& folder, const std::vector<std::string>& words, const Pronunciations& said) {
  std::string dictionary;
  std::string grammar =
      fmt::format("FSG_BEGIN text\nNUM_STATES {}\nSTART_STATE 0\nFINAL_STATE {}\n", words.size() + 1, words.size());
  std::map<std::string, std::size_t> numbers;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto [number, fresh] = numbers.try_emplace(words[i], numbers.size() + 1);
    grammar += fmt::format("TRANSITION {} {} 1.0 w{}\n", i, i + 1, number->second);
    std::size_t way = 1;
    if (fresh)
      for (const std::string& phones : said.at(words[i])) {
        dictionary += fmt::format("w{}{} {}\n", number->second, way == 1 ? "" : fmt::format("({})", way), phones);
        ++way;
      }
  }
  if (Status s = write_whole(folder / "words.dict", dictionary, true); !s) return s;
  if (Status s = write_whole(folder / "words.fsg", grammar + "FSG_END\n", true); !s) return s;
  return write_whole(folder / "words.list", "speech\n", true);
}

// Runs the program. `beam`: how unlikely a way may be that is still followed.
Status run_aligner(const AlignmentFolder& folder, const std::string& program, const std::string& beam, double seconds,
                   const AlignmentProgress& progress) {
  const std::string model = model_folder;
  const std::vector<std::string> call{program,
                                      "-hmm",
                                      model + "/en-us",
                                      "-dict",
                                      folder / "words.dict",
                                      "-fsg",
                                      folder / "words.fsg",
                                      "-ctl",
                                      folder / "words.list",
                                      "-adcin",
                                      "yes",
                                      "-cepdir",
                                      folder.path(),
                                      "-cepext",
                                      ".raw",
                                      "-ctm",
                                      folder / "words.ctm",
                                      "-logfn",
                                      folder / "log",
                                      "-remove_silence",
                                      "no",
                                      "-remove_noise",
                                      "no",
                                      "-cmn",
                                      "batch",
                                      "-bestpath",
                                      "no",
                                      "-wip",
                                      "1.0",
                                      "-silprob",
                                      "0.1",
                                      "-beam",
                                      beam,
                                      "-pbeam",
                                      beam,
                                      "-wbeam",
                                      beam,
                                      "-maxhmmpf",
                                      "-1"};
  pid_t pid = -1;
  if (const int failed = start_child(pid, call, {-1, -1, -1})) return system_error(failed, "start", program);
  const auto begun = std::chrono::steady_clock::now();
  int status = 0;
  while (::waitpid(pid, &status, WNOHANG) == 0) {
    ::usleep(20'000);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begun;
    if (progress && !progress(passed.count(), 1 + 0.05 * seconds)) {
      ::kill(pid, SIGKILL), wait_for_child(pid);
      return fail(ErrorCode::range, "stopped");
    }
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return Nothing{};
  return fail(ErrorCode::machine, fmt::format("{} failed", program));
}

// Reads lines "speech 1 START LENGTH WORD SCORE". Pauses are no words. A last frame belongs to its word.
std::vector<SpokenWord> read_aligned(const std::string& text) {
  std::vector<SpokenWord> all;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::array<std::string_view, 5> fields;
    std::string_view rest = std::string_view(text).substr(at, end - at);
    for (std::string_view& field : fields) {
      rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
      field = rest.substr(0, rest.find(' '));
      rest.remove_prefix(field.size());
    }
    at = end + 1;
    double start = 0, length = 0;
    std::from_chars(fields[2].data(), fields[2].data() + fields[2].size(), start);
    std::from_chars(fields[3].data(), fields[3].data() + fields[3].size(), length);
    if (fields[4].starts_with('w')) all.push_back({start, start + length + frame_length, ""});
  }
  return all;
}

// Decibels of each 5 ms.
std::vector<double> levels_of(std::span<const float> samples, std::size_t step) {
  std::vector<double> levels;
  for (std::size_t at = 0; at + step <= samples.size(); at += step) {
    double sum = 1e-9 * static_cast<double>(step);
    for (const float s : samples.subspan(at, step)) sum += static_cast<double>(s) * static_cast<double>(s);
    levels.push_back(10 * std::log10(sum / static_cast<double>(step)));
  }
  return levels;
}

double level_that(std::vector<double> levels, double share_below) {
  const auto at = levels.begin() + static_cast<std::ptrdiff_t>(share_below * static_cast<double>(levels.size() - 1));
  std::nth_element(levels.begin(), at, levels.end());
  return *at;
}

struct Quiet {
  std::size_t from = 0, to = 0;
  std::size_t size() const { return to - from; }
};

// Returns the pause between two places: the first quiet part that is nearly as long as the longest.
Quiet pause_in(const std::vector<double>& levels, std::size_t from, std::size_t to, double below) {
  std::vector<Quiet> all;
  std::size_t longest = 0;
  for (std::size_t i = from; i < std::min(to, levels.size()); ++i) {
    if (levels[i] >= below) continue;
    if (all.empty() || all.back().to < i) all.push_back({i, i});
    all.back().to = i + 1;
    longest = std::max(longest, all.back().size());
  }
  const auto first = std::find_if(all.begin(), all.end(), [&](const Quiet& q) { return 10 * q.size() >= 6 * longest; });
  return first == all.end() ? Quiet{} : *first;
}

// The level that a tenth of the sound exceeds.
double loud_level(const std::vector<double>& levels) { return level_that(levels, 0.9); }

// Adds a faint noise, 38 dB below the voice. The model was made with recordings of real rooms: without noise, it takes
// parts of vowels for silence beside pauses that have no sound at all.
std::vector<float> as_in_a_room(std::span<const float> samples, double loud) {
  const double size = std::pow(10.0, (loud - 38) / 20);
  std::uint64_t seed = 1;
  const auto random = [&seed] {  // from -1 to 1
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(seed >> 33) / (1u << 30) - 1;
  };
  std::vector<float> all;
  all.reserve(samples.size());
  for (const float s : samples) {
    const double noise = size * (random() + random() + random());  // with the variance 1
    all.push_back(static_cast<float>(std::clamp(static_cast<double>(s) + noise, -1.0, 1.0)));
  }
  return all;
}

// A level between that of pauses and that of the voice.
double quiet_below(const std::vector<double>& levels) {
  const double loud = loud_level(levels), floor = std::max(level_that(levels, 0.05), loud - 50);
  return floor + 0.25 * (loud - floor);
}

// Words that last too long or are squeezed, and pauses in which something is said.
std::vector<std::string> doubts_about(const std::vector<SpokenWord>& words, const Pronunciations& said,
                                      const std::vector<double>& levels) {
  constexpr double longest_phone = 0.3, shortest_phone = 0.036, longest_gap = 0.7;
  constexpr std::size_t most = 5, squeezed_words = 4;
  const double below = quiet_below(levels);
  std::vector<std::string> all;
  std::size_t squeezed = 0;
  for (std::size_t i = 0; i < words.size() && all.size() < most; ++i) {
    const std::string& phones = said.at(words[i].text).front();
    const auto count = static_cast<double>(1 + std::count(phones.begin(), phones.end(), ' '));
    const double length = words[i].end - words[i].start;
    squeezed = length < shortest_phone * count ? squeezed + 1 : 0;
    if (length > 0.6 + longest_phone * count)
      all.push_back(fmt::format("at {:.1f} s '{}' lasts {:.1f} s", words[i].start, words[i].text, length));
    if (squeezed == squeezed_words)
      all.push_back(
          fmt::format("at {:.1f} s '{}' and the words before it are very short", words[i].start, words[i].text));
    const double next = i + 1 < words.size() ? words[i + 1].start : words[i].end;
    if (next - words[i].end < longest_gap) continue;
    const auto from = levels.begin() + static_cast<std::ptrdiff_t>(words[i].end * 200);
    const auto to = levels.begin() + std::min(static_cast<std::ptrdiff_t>(next * 200), std::ssize(levels));
    const auto loud = std::count_if(from, to, [&](double level) { return level >= below; });
    if (static_cast<double>(loud) / 200 > longest_gap)
      all.push_back(fmt::format("at {:.1f} s something is said after '{}'", words[i].end, words[i].text));
  }
  return all;
}

Error not_this_text(const std::vector<std::string>& words, std::size_t found) {
  if (found == 0)
    return fail(ErrorCode::file, "the text is not what is spoken in the recording",
                "the text must have every word that is spoken, and no other, in English");
  std::string near;
  for (std::size_t i = found > 3 ? found - 3 : 0; i < std::min(found + 3, words.size()); ++i) near += " " + words[i];
  return fail(ErrorCode::file, fmt::format("the text is not what is spoken: it was followed up to …{} …", near));
}

}  // namespace

void refine_edges(std::vector<SpokenWord>& words, std::span<const float> samples) {
  constexpr double seconds = static_cast<double>(level_step) / speech_rate, before = 0.04, behind = 0.06, least = 0.03;
  const std::vector<double> levels = levels_of(samples, level_step);
  if (levels.empty()) return;
  const double below = quiet_below(levels);
  const auto at = [&](double t) {
    return static_cast<std::size_t>(std::clamp(t / seconds, 0.0, static_cast<double>(levels.size())));
  };
  for (std::size_t i = 0; i <= words.size(); ++i) {
    const double end = i > 0 ? words[i - 1].end : 0, start = i < words.size() ? words[i].start : 1e9;
    if (start - end < least) continue;
    const double first = i > 0 ? std::max(end - before, words[i - 1].start + 2 * frame_length) : 0;
    const double last = i < words.size() ? std::min(start + behind, words[i].end - 2 * frame_length) : 1e9;
    const Quiet pause = pause_in(levels, at(first), at(last), below);
    if (pause.size() == 0) continue;
    if (i > 0) words[i - 1].end = static_cast<double>(pause.from) * seconds;
    if (i < words.size()) words[i].start = static_cast<double>(pause.to) * seconds;
  }
}

Result<Alignment> align_words(const std::string& sound, std::string_view text, const AlignmentProgress& progress) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    if (length == 0 || text[i] == '\0') return fail(ErrorCode::file, "the text is not UTF-8");
    i += length;
  }
  const std::vector<std::string> words = words_of_text(text);
  if (words.empty()) return fail(ErrorCode::range, "the text has no words");
  if (words.size() > most_aligned)
    return fail(ErrorCode::range, fmt::format("a text can have at most {} words", most_aligned));
  const std::string program = find_program("pocketsphinx_batch");
  const std::string dictionary = std::string(model_folder) + "/cmudict-en-us.dict";
  if (program.empty()) return fail(ErrorCode::machine, "the program pocketsphinx is not installed", how_to_install);
  if (!fs::exists(dictionary))
    return fail(ErrorCode::machine, "the English model of pocketsphinx is not installed", how_to_install);
  const AlignmentFolder folder;
  if (!folder.made()) return fail(ErrorCode::machine, "there is no place for temporary files");
  std::vector<float> samples;
  Thinner thinner(samples);
  const Status heard = decode_sound(sound, [&](std::span<const float> stereo) { return thinner.put(stereo), true; });
  if (!heard) return heard.error();
  thinner.put(std::vector<float>(200));
  const auto said = pronunciations(words, dictionary, folder.path());
  if (!said) return said.error();
  const std::vector<double> levels = levels_of(samples, level_step);
  if (levels.empty() || loud_level(levels) < -80) return fail(ErrorCode::file, fmt::format("{} is silent", sound));
  if (Status s = put_samples(folder / "speech.raw", as_in_a_room(samples, loud_level(levels))); !s) return s.error();
  if (Status s = put_grammar(folder, words, *said); !s) return s.error();
  std::vector<SpokenWord> found;
  for (const char* beam : {"1e-120", "1e-250"}) {  // the second takes longer, and loses no way
    const double seconds = static_cast<double>(samples.size()) / speech_rate;
    if (Status s = run_aligner(folder, program, beam, seconds, progress); !s) return s.error();
    const auto table = read_whole(folder / "words.ctm");
    found = read_aligned(table ? *table : std::string());
    if (found.size() == words.size()) break;
  }
  if (found.size() != words.size()) return not_this_text(words, found.size());
  refine_edges(found, samples);
  Alignment all;
  for (std::size_t i = 0; i < words.size(); ++i) found[i].text = words[i];
  all.doubts = doubts_about(found, *said, levels);
  for (SpokenWord& word : found) all.words.add(std::move(word));
  return all;
}

}  // namespace betwixt
