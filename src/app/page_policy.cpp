// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "app/page_policy.h"

#include <fmt/format.h>

#include "base/base64.h"
#include "base/files.h"
#include "base/sha256.h"

namespace betwixt {
namespace {

std::string hash_of(std::string_view text) {
  const auto hash = sha256(text);
  return fmt::format(" 'sha256-{}'", base64(as_text(hash)));
}

}  // namespace

std::string PagePolicy::script(std::string_view text) {
  scripts_ += hash_of(text);
  return fmt::format("<script>{}</script>", text);
}
std::string PagePolicy::style(std::string_view text) {
  styles_ += hash_of(text);
  return fmt::format("<style>{}</style>", text);
}
std::string PagePolicy::script_beside(std::string_view name) {
  scripts_ += " 'self'";
  return fmt::format("<script src=\"{}\"></script>", name);
}
std::string PagePolicy::style_beside(std::string_view name) {
  styles_ += " 'self'";
  return fmt::format("<link rel=\"stylesheet\" href=\"{}\">", name);
}

std::string PagePolicy::said() const {
  return fmt::format(
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src{} 'wasm-unsafe-eval'; "
      "style-src{}; connect-src 'self'; img-src 'self'; base-uri 'none'; form-action 'none'; "
      "require-trusted-types-for 'script'; trusted-types 'none'\">",
      scripts_, styles_);
}

}  // namespace betwixt
