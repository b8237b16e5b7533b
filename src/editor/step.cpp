// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "editor/step.h"

#include <algorithm>
#include <utility>

#include "base/memory.h"
#include "editor/said_line.h"
#include "editor/track_rows.h"

namespace betwixt {
namespace {

constexpr char between_lines = '\0';

// Returns true for several lines, or for one logical line over several.
bool stands_alone(const Step& s) { return s.rows || s.lines.size() > 1 || s.lines[0].find('\n') != std::string::npos; }

}  // namespace

bool stands_below(const Step& step, const Step* above) {
  return above && !step.sheet.empty() && above->sheet == step.sheet && !stands_alone(step);
}

std::vector<std::string> lines_of(const Step& step, const Step* above) {
  std::vector<std::string> out;
  std::string_view sheet = stands_below(step, above) ? std::string_view() : step.sheet;
  for (std::string line; !sheet.empty();) {
    const std::size_t end = std::min(sheet.find('\n'), sheet.size());
    line += sheet.substr(0, end);
    sheet.remove_prefix(std::min(end + 1, sheet.size()));
    if (!sheet.empty() && goes_on(line)) {
      line += '\n';
      continue;
    }
    out.push_back(std::exchange(line, {}));
  }
  out.insert(out.end(), step.lines.begin(), step.lines.end());
  for (std::size_t i = 0; step.rows && i < step.rows->times.size(); ++i) step.rows->write(i, out.emplace_back());
  return out;
}

std::size_t bytes_of(const Step& step) {
  if (step.rows) return packed(step).size() + 1;
  std::size_t n = step.sheet.size() + 1;
  for (const std::string& line : step.lines) n += line.size() + 1;
  return n;
}

std::size_t memory_of(const Step& step) {
  std::size_t n = sizeof(Step) + bytes_held(step.sheet) + bytes_held(step.lines);
  for (const std::string& line : step.lines) n += bytes_held(line);
  return n + (step.rows ? step.rows->bytes() : 0);
}

std::string as_script(std::string_view base, std::span<const Step> steps) {
  std::string out(base);
  if (!steps.empty() && !out.empty() && out.back() != '\n') out += '\n';
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const Step& s = steps[i];
    if (!s.sheet.empty() && !stands_below(s, i > 0 ? &steps[i - 1] : nullptr)) out += s.sheet + "\n";
    for (const std::string& line : s.lines) out += line + "\n";
    if (s.rows) s.rows->write_all("", "\n", out);
  }
  return out;
}

std::string packed(const Step& step) {
  if (step.sheet.empty() && step.lines.size() == 1 && !step.rows) return step.lines[0];
  std::string out = step.sheet;
  for (const std::string& line : step.lines) (out += between_lines) += line;
  if (step.rows) step.rows->write_all({&between_lines, 1}, "", out);
  return out;
}

Step unpacked(std::string_view text) {
  Step step;
  std::size_t end = text.find(between_lines);
  if (end == std::string_view::npos) return {{std::string(text)}, {}};
  step.sheet = text.substr(0, end);
  while (end != std::string_view::npos) {
    text.remove_prefix(end + 1);
    end = text.find(between_lines);
    step.lines.emplace_back(text.substr(0, end));
  }
  return step;
}

}  // namespace betwixt
