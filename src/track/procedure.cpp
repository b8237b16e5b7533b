// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "track/procedure.h"

namespace betwixt {
namespace {

Error wrong_role(const char* what) { return fail(ErrorCode::type, std::string("this procedure is not a ") + what); }

}  // namespace

Result<Value> Routine::value(Questions&, const std::vector<Value>&, std::uint64_t&) const {
  return wrong_role("value");
}
Result<State> Routine::step(Questions&, const State&, std::int64_t, double, std::uint64_t&) const {
  return wrong_role("stepped procedure");
}
Result<double> Routine::blend(double) const { return wrong_role("twerper"); }
Result<Value> Routine::between(Questions&, const TweenSegment&, std::uint64_t&) const { return wrong_role("tween"); }
Result<Value> Routine::filter(Input&, double, const Parameters&) const { return wrong_role("filter"); }
Status Routine::command(Host&, const std::vector<std::string>&) const { return wrong_role("command"); }

bool operator==(const Procedure& a, const Procedure& b) {
  return a.code == b.code ||
         (a.code && b.code && a.code->language == b.code->language && a.code->source == b.code->source);
}

}  // namespace betwixt
