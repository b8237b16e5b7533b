// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/checkpoint.h"

#include <sys/resource.h>

#include <atomic>
#include <exception>
#include <system_error>
#include <thread>
#include <utility>

namespace betwixt {
namespace {

constexpr int after_all_others = 10;  // its nice value

}  // namespace

struct Checkpoint::Work {
  Document document;
  std::size_t steps = 0;
  std::string name, path;
  LoadOptions options;
  Result<std::string> script = fail(ErrorCode::machine, "no script makes the document as it is");
  CheckpointStep step;
  std::optional<NextHistory> next;
  std::atomic<bool> done{false}, wanted{true};

  void run() {
    ::setpriority(PRIO_PROCESS, 0, after_all_others);  // of this thread only
    try {
      work();
    } catch (const std::exception& e) {  // out of memory
      script = fail(ErrorCode::machine, e.what());
    }
    document = {};
    step = {};
    done = true;
  }
  void work() {
    std::string text = write(document);
    const Loaded again = load_text(text, name, options);
    if (has_errors(again.diagnostics) || !(again.document == document)) return;
    if (!wanted) return;
    if (!path.empty()) {
      auto files = write_next(path, text, steps, step);
      if (!files) {
        script = files.error();
        return;
      }
      next = *std::move(files);
    }
    script = std::move(text);
  }
};

Checkpoint::Checkpoint(Document document, std::size_t steps, std::string name, std::string path,
                       const LoadOptions& options, CheckpointStep step)
    : work_(std::make_shared<Work>()), steps_(steps) {
  work_->document = std::move(document), work_->options = options;
  work_->name = std::move(name), work_->path = std::move(path);
  work_->steps = steps, work_->step = std::move(step);
  try {
    std::thread([work = work_] { work->run(); }).detach();
  } catch (const std::system_error&) {  // no thread could be started
    work_->done = true;
  }
}

Checkpoint::~Checkpoint() { work_->wanted = false; }

bool Checkpoint::done() const { return work_->done; }
const Result<std::string>& Checkpoint::script() const { return work_->script; }
std::string Checkpoint::take_script() { return *std::move(work_->script); }
std::optional<NextHistory> Checkpoint::take_next() { return std::exchange(work_->next, std::nullopt); }

}  // namespace betwixt
