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
  std::string name;
  LoadOptions options;
  std::optional<std::string> script;
  std::atomic<bool> done{false};

  void run() {
    ::setpriority(PRIO_PROCESS, 0, after_all_others);  // of this thread alone
    try {
      std::string text = write(document);
      const Loaded again = load_text(text, name, options);
      if (!has_errors(again.diagnostics) && again.document == document) script = std::move(text);
    } catch (const std::exception&) {  // memory that is not to be had
      script.reset();
    }
    document = {};
    done = true;
  }
};

Checkpoint::Checkpoint(Document document, std::size_t steps, std::string name, const LoadOptions& options)
    : work_(std::make_shared<Work>()), steps_(steps) {
  work_->document = std::move(document), work_->name = std::move(name), work_->options = options;
  try {
    std::thread([work = work_] { work->run(); }).detach();
  } catch (const std::system_error&) {  // no thread is to be had
    work_->done = true;
  }
}

bool Checkpoint::done() const { return work_->done; }
const std::optional<std::string>& Checkpoint::script() const { return work_->script; }

}  // namespace betwixt
