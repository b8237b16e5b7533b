// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// betwixt test: films that must keep their values and their pictures.
#include <fmt/format.h>

#include <atomic>
#include <thread>

#include "app/command.h"
#include "app/golden.h"
#include "app/subcommand.h"
#include "base/counted.h"
#include "base/in_parallel.h"
#include "base/tell_user.h"

namespace betwixt {
namespace {

struct TestCall {
  std::string path;
  bool update = false;
  int jobs = 0;
};

int run_golden(const TestCall& call) {
  const std::vector<std::string> files = golden_files(call.path);
  if (files.empty())
    return complain(fail(ErrorCode::file, fmt::format("there is no file .expect for '{}'", call.path),
                         "film.expect beside film.bx says what the film must show: at 48f ball.position (1 2 3)"),
                    wrong_call);
  std::vector<GoldenResult> results(files.size());
  std::atomic<std::size_t> next = 0;
  const std::size_t jobs = call.jobs > 0 ? static_cast<std::size_t>(call.jobs) : std::thread::hardware_concurrency();
  in_parallel(std::clamp<std::size_t>(jobs, 1, files.size()), [&](std::size_t) {
    for (std::size_t k = next++; k < files.size(); k = next++) results[k] = check_golden(files[k], call.update);
  });
  std::size_t checks = 0, failed = 0;
  for (const GoldenResult& r : results) {
    checks += r.checks, failed += r.failures.size();
    for (const std::string& f : r.failures) tell_user(f + "\n");
    for (const std::string& w : r.written) fmt::print("{} written\n", w);
  }
  fmt::print("{}, {}, {} failed\n", counted(files.size(), "film"), counted(checks, "check"), failed);
  return failed > 0 ? wrong_input : all_done;
}

const Enlisted enlisted_test(run_golden, [](TestCall& call) -> Subcommand {
  return {.rank = 64,
          .name = "test",
          .sentence = "checks that films still have the values and pictures that files beside them name",
          .takes = {{.name = "DIR",
                     .sentence = "a folder with files X.expect beside X.bx, or one of these files",
                     .into = &call.path,
                     .required = true,
                     .offer = Offer::files},
                    flag("--update", "writes the pictures anew instead of comparing them", call.update),
                    {.name = "--jobs",
                     .value = "N",
                     .sentence = "how many films are checked at once; by default one for each processor",
                     .into = &call.jobs,
                     .range = std::pair(1, 256)}},
          .example = "betwixt test films",
          .manual =
              "A line of X.expect is \"at TIME TARGET VALUE [within NUMBER]\", \"frame TIME \\\"PICTURE.png\\\" "
              "[within NUMBER]\" or \"size WxH\" for the pictures below it. Where a picture differs, the one that "
              "was found and the difference are written beside it. The exit code is 1 if a check fails."};
});

}  // namespace
}  // namespace betwixt
