// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// Results that do not depend on a document: files that were read, code that was compiled. If the document changes while
// a command is carried out, the command is carried out again. Then it uses the results of its first try.
#pragma once

#include <any>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <utility>

namespace betwixt {

class KeptResults {
 public:
  // The key: the kind of work, and its input.
  using Store = std::map<std::pair<std::string, std::string>, std::any, std::less<>>;

  // During its lifetime, this thread keeps results in the store.
  explicit KeptResults(Store& store) : before_(std::exchange(current, &store)) {}
  ~KeptResults() { current = before_; }
  KeptResults(const KeptResults&) = delete;
  KeptResults& operator=(const KeptResults&) = delete;

  // Returns make(), or what it returned before for the same `what` and `of`.
  template <class Make>
  static std::invoke_result_t<Make> get(std::string what, std::string of, Make&& make) {
    using R = std::invoke_result_t<Make>;
    if (!current) return make();
    std::pair key(std::move(what), std::move(of));
    auto at = current->find(key);
    if (at == current->end()) at = current->emplace(std::move(key), std::any(R(make()))).first;
    return std::any_cast<const R&>(at->second);
  }

 private:
  static inline thread_local Store* current = nullptr;
  Store* const before_;
};

}  // namespace betwixt
