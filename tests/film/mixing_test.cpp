// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Tests the sound of a film, sample by sample, and as other programs read it.
#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "betwixt/language.h"
#include "film/films.h"
#include "support/waves.h"

namespace betwixt {
namespace {

class Mixing : public Film {
 protected:
  // No two samples are the same, so that one that is off by one is seen.
  void SetUp() override {
    Film::SetUp();
    write_wave((folder_ / "ramp.wav").string(), ramp());
  }
  static std::vector<float> ramp() {
    std::vector<float> all;
    for (int i = 0; i < 2 * 96'000; ++i)
      all.push_back(static_cast<float>((i % 2 == 0 ? 1 : -1) * (i / 2 + 1) / 96'000.0));
    return all;
  }
  std::vector<float> mixed(const std::string& script, double from, double seconds) const {
    std::ofstream(folder_ / "film.bx") << "rate 24\n" << script;
    const Loaded l = load_file((folder_ / "film.bx").string());
    EXPECT_FALSE(has_errors(l.diagnostics)) << script;
    std::vector<float> all(2 * static_cast<std::size_t>(std::llround(seconds * 48'000)));
    const Status done = mix_sounds(Program::compile(l.document), from_seconds(from), all);
    EXPECT_TRUE(done);
    return all;
  }
};

// wanted(film seconds, own sample) is the gain; the file is played from sample `skip` on at sample `at`.
template <class F>
void expect_heard(const std::vector<float>& is, std::int64_t at, std::int64_t skip, std::int64_t until, F&& gain) {
  int wrong = 0;
  for (std::int64_t i = 0; i < static_cast<std::int64_t>(is.size()) / 2; ++i) {
    const std::int64_t own = i - at + skip;
    const bool heard = own >= skip && own >= 0 && own < until;
    const double wanted = heard ? gain(static_cast<double>(own) / 48'000) * static_cast<double>(own + 1) / 96'000.0 : 0;
    if (std::abs(is[2 * static_cast<std::size_t>(i)] - wanted) > 2e-6 ||
        std::abs(is[2 * static_cast<std::size_t>(i) + 1] + wanted) > 2e-6)
      if (++wrong < 5)
        ADD_FAILURE() << "sample " << i << ": " << is[2 * static_cast<std::size_t>(i)] << ", not " << wanted;
  }
  EXPECT_EQ(wrong, 0);
}
constexpr auto whole = [](double) { return 1.0; };

TEST_F(Mixing, ASoundStandsWhereItBelongsToTheSample) {
  const std::string begin = "create s sound file=\"ramp.wav\" ";
  expect_heard(mixed(begin + "at=1f", 0, 3), 0, 0, 96'000, whole);
  expect_heard(mixed(begin + "at=13f", 0, 3), 24'000, 0, 96'000, whole);
  expect_heard(mixed(begin + "at=13f from=0.25s until=1s", 0, 3), 24'000, 12'000, 48'000, whole);
  expect_heard(mixed(begin + "at=13f from=0.25s until=1s", 0.75, 1), -12'000, 12'000, 48'000, whole);
  expect_heard(mixed(begin + "at=-1s", 0, 2), -48'000, 0, 96'000, whole);
  expect_heard(mixed(begin + "at=9s", 0, 2), 10'000'000, 0, 96'000, whole);
  expect_heard(mixed(begin + "gain=0.25", 0, 2), 0, 0, 96'000, [](double) { return 0.25; });
}

TEST_F(Mixing, GainsAndFadesAreStraight) {
  const std::string begin = "create s sound file=\"ramp.wav\" ";
  expect_heard(mixed(begin + "fade-in=0.5s fade-out=1s", 0, 2), 0, 0, 96'000, [](double own) {
    return std::min({own / 0.5, (2 - own) / 1, 1.0});
  });
  expect_heard(mixed(begin + "at=1f\ns.gain\n  1f 0 linear\n  97f 4\n", 0, 2), 0, 0, 96'000,
               [](double own) { return own; });
  const auto two = mixed(begin + "at=1f\ncreate z like s\nset z.gain 0.5", 0, 1);
  expect_heard(two, 0, 0, 96'000, [](double) { return 1.5; });
  const auto gone = mixed(begin + "at=1f\nremove s", 0, 1);
  expect_heard(gone, 0, 0, 0, whole);
}

// As another program hears it: coded, but to the millisecond.
TEST_F(Mixing, FilmsHaveItInTime) {
  std::vector<float> ticks(2 * 4 * 48'000);  // four seconds, for a film of two
  const std::vector<int> at{4'800, 33'333, 72'000, 90'000};
  for (const int k : at)
    for (int i = 0; i < 480; ++i)
      ticks[2 * static_cast<std::size_t>(k + i)] = ticks[2 * static_cast<std::size_t>(k + i) + 1] =
          static_cast<float>(0.8 * std::sin(0.3 * i) * (1 - i / 480.0));
  for (const char* name : {"film.mp4", "film.webm"}) {
    FilmOptions o = options(name, 60);
    o.rate = {30, 1};
    o.sounds = [&](std::span<float> stereo) -> Status {
      EXPECT_EQ(stereo.size(), 2u * 96'000);
      std::copy_n(ticks.begin(), stereo.size(), stereo.begin());
      return Nothing{};
    };
    ASSERT_TRUE(make_film(o, gray_steps())) << name;
    EXPECT_EQ(probe(o.path, "nb_read_frames"), "60");
    const std::string bytes = output_of("ffmpeg -v error -i '" + o.path + "' -f f32le -ac 2 -ar 48000 -");
    std::vector<float> heard(bytes.size() / sizeof(float));
    std::memcpy(heard.data(), bytes.data(), heard.size() * sizeof(float));
    EXPECT_NEAR(static_cast<double>(heard.size()) / 2, 96'000, 1'100) << name;  // one packet more, at most
    // The best place of each tick within 10 ms, by correlation.
    for (const int k : at) {
      int best = 0;
      double most = -1;
      for (int shift = -480; shift <= 480; ++shift) {
        double sum = 0;
        for (int i = 0; i < 480; ++i) {
          const auto there = static_cast<std::size_t>(2 * (k + shift + i));
          if (there < heard.size())
            sum += static_cast<double>(heard[there]) * ticks[static_cast<std::size_t>(2 * (k + i))];
        }
        if (sum > most) most = sum, best = shift;
      }
      EXPECT_LE(std::abs(best), 24) << name << ", the tick at " << k;  // half a millisecond
    }
  }
  for (const char* name : {"film.gif", "film.apng"}) {
    FilmOptions o = options(name, 3);
    o.sounds = [](std::span<float>) -> Status { return fail(ErrorCode::machine, "nobody should ask for it"); };
    EXPECT_TRUE(make_film(o, gray_steps())) << name;
    EXPECT_FALSE(takes_sound(o.path));
  }
  EXPECT_TRUE(takes_sound("a.mp4"));
  EXPECT_FALSE(takes_sound("a-%d.png"));
  EXPECT_FALSE(takes_sound("a.doc"));
}

TEST_F(Mixing, ASoundThatFailsIsTheFilmsError) {
  FilmOptions o = options("film.mp4");
  o.sounds = [](std::span<float>) -> Status { return fail(ErrorCode::file, "the tape is torn"); };
  const auto made = make_film(o, gray_steps());
  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().message, "the tape is torn");
  EXPECT_EQ(files(), (std::vector<std::string>{"ramp.wav"}));
}

}  // namespace
}  // namespace betwixt
