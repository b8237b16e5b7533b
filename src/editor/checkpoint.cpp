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
  std::string name, path;
  LoadOptions options;
  Result<std::string> script = fail(ErrorCode::machine, "no script makes the document as it is");
  std::optional<ScriptBeside> beside;
  std::atomic<bool> done{false};

  void run() {
    ::setpriority(PRIO_PROCESS, 0, after_all_others);  // of this thread only
    try {
      work();
    } catch (const std::exception& e) {  // out of memory
      script = fail(ErrorCode::machine, e.what());
    }
    document = {};
    done = true;
  }
  void work() {
    std::string text = write(document);
    const Loaded again = load_text(text, name, options);
    if (has_errors(again.diagnostics) || !(again.document == document)) return;
    if (!path.empty()) {
      auto there = write_beside(path, text);
      if (!there) {
        script = there.error();
        return;
      }
      beside = *std::move(there);
    }
    script = std::move(text);
  }
};

Checkpoint::Checkpoint(Document document, std::size_t steps, std::string name, std::string path,
                       const LoadOptions& options)
    : work_(std::make_shared<Work>()), steps_(steps) {
  work_->document = std::move(document), work_->options = options;
  work_->name = std::move(name), work_->path = std::move(path);
  try {
    std::thread([work = work_] { work->run(); }).detach();
  } catch (const std::system_error&) {  // no thread could be started
    work_->done = true;
  }
}

bool Checkpoint::done() const { return work_->done; }
const Result<std::string>& Checkpoint::script() const { return work_->script; }
std::string Checkpoint::take_script() { return *std::move(work_->script); }
const std::optional<ScriptBeside>& Checkpoint::beside() const { return work_->beside; }

void Checkpoint::free_beside(std::vector<Step> steps) {
  try {
    std::thread([gone = std::move(steps)] {}).detach();
  } catch (const std::system_error&) {  // no thread could be started: they are freed here
  }
}

}  // namespace betwixt
