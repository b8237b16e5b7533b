// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
#include "exchange/tex.h"

#include <fmt/format.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <vector>

#include "base/child.h"
#include "base/files.h"
#include "base/utf8.h"
#include "exchange/parser_process.h"

namespace betwixt {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_characters = 10'000;
constexpr std::uint64_t most_drawn = std::uint64_t{1} << 20;      // bytes
constexpr rlim_t tex_seconds = 20, tex_memory = rlim_t{2} << 30;  // of each program
constexpr const char* packages = "sudo apt-get install texlive-latex-base dvisvgm";

// A private folder, removed at the end.
class WorkFolder {
 public:
  WorkFolder() {
    std::error_code why;
    std::string name = (fs::temp_directory_path(why) / "betwixt-tex-XXXXXX").string();
    if (!why && ::mkdtemp(name.data()) != nullptr) at_ = fs::absolute(name, why);
  }
  ~WorkFolder() {
    std::error_code ignored;
    if (!at_.empty()) fs::remove_all(at_, ignored);
  }
  WorkFolder(const WorkFolder&) = delete;
  WorkFolder& operator=(const WorkFolder&) = delete;
  const fs::path& path() const { return at_; }

 private:
  fs::path at_;
};

// Sets the limits that work without betwixt-parser.
void limit_child(pid_t pid) {
  constexpr rlim_t mebibyte = rlim_t{1} << 20;
  const rlimit seconds{tex_seconds, tex_seconds + 1}, memory{tex_memory, tex_memory},
      file{64 * mebibyte, 64 * mebibyte};
  ::prlimit(pid, RLIMIT_CPU, &seconds, nullptr);
  ::prlimit(pid, RLIMIT_AS, &memory, nullptr);
  ::prlimit(pid, RLIMIT_FSIZE, &file, nullptr);
}

// Runs a program in a jail and returns whether it succeeded. Environment variables restrict TeX's reading and writing
// to the folder, too.
Result<bool> run_in(const fs::path& folder, const std::vector<std::string>& call, std::chrono::milliseconds most) {
  const std::string program = find_program(call[0]), jail = find_parser();
  if (program.empty())
    return fail(ErrorCode::machine,
                fmt::format("formulas need the programs latex and dvisvgm, but {} is not installed", call[0]),
                packages);
  std::vector<std::string> words{"env",           "--chdir=" + folder.string(),     "openin_any=p",
                                 "openout_any=p", "TEXMFOUTPUT=" + folder.string(), "TMPDIR=" + folder.string()};
  if (!jail.empty())
    words.insert(words.end(), {fs::absolute(jail).string(), parser_version, parser_works_in, std::to_string(tex_memory),
                               std::to_string(tex_seconds), folder.string()});
  words.push_back(fs::absolute(program).string());  // of this folder, not of its own
  words.insert(words.end(), call.begin() + 1, call.end());
  pid_t pid = -1;
  if (const int failed = start_child(pid, words, {})) return system_error(failed, "start", call[0]);
  if (jail.empty()) limit_child(pid);
  const auto status = wait_for_child(pid, most);
  const int by = status && WIFSIGNALED(*status) ? WTERMSIG(*status) : 0;
  if (!status || by == SIGXCPU || by == SIGKILL)
    return fail(ErrorCode::machine, fmt::format("{} takes too long for this formula", call[0]));
  const int code = WIFEXITED(*status) ? WEXITSTATUS(*status) : 1;
  if (!jail.empty() && code == parser_of_another_version)
    return fail(ErrorCode::machine, "the program betwixt-parser has another version than this program");
  return code == 0;
}

// Returns the printable characters of the end, or the beginning, of TeX's output.
std::string shown(std::string_view said, std::size_t most, bool end) {
  std::string out(end && said.size() > most ? said.substr(said.size() - most) : said.substr(0, most));
  for (char& c : out)
    if (c < ' ' || c > '~') c = '?';
  while (!out.empty() && (out.back() == '.' || out.back() == ' ')) out.pop_back();
  return out;
}

// Returns TeX's error: "! Undefined control sequence." and, further below, "l.7 \fracc", up to which it had read.
Error complaint(const fs::path& log) {
  std::ifstream in(log);
  std::string what;
  for (std::string line; std::getline(in, line);) {
    if (what.empty() && line.starts_with("! ")) what = shown(std::string_view(line).substr(2), 200, false);
    if (what.empty() || !line.starts_with("l.")) continue;
    const std::string at = shown(line.substr(std::min(line.find(' '), line.size() - 1) + 1), 40, true);
    return fail(ErrorCode::syntax, fmt::format("the formula has an error: {}: {}", what, at));
  }
  if (what.empty()) return fail(ErrorCode::machine, "latex failed without an error message");
  return fail(ErrorCode::syntax, fmt::format("the formula has an error: {}", what));
}

// The square marks the baseline.
std::string text_for_tex(const std::string& formula) {
  return fmt::format(
      "\\documentclass{{article}}\n\\usepackage{{amsmath,amssymb}}\n\\pagestyle{{empty}}\n\\parindent0pt\n"
      "\\begin{{document}}\n\\hbox{{\\vrule width 72bp height 72bp depth "
      "0bp$\\displaystyle\n{}\n$}}\n\\end{{document}}\n",
      formula);
}

}  // namespace

Result<std::shared_ptr<const Outline>> set_by_tex(const std::string& formula, std::chrono::milliseconds most) {
  if (count_characters(formula) > most_characters)
    return fail(ErrorCode::range, fmt::format("a formula can have at most {} characters", most_characters));
  const WorkFolder folder;
  const fs::path& at = folder.path();
  if (at.empty()) return system_error(errno, "make", "a folder for latex");
  if (const int reason = put_file((at / "formula.tex").string(), text_for_tex(formula)))
    return system_error(reason, "write", "formula.tex");
  const auto set =
      run_in(at, {"latex", "-no-shell-escape", "-halt-on-error", "-interaction=nonstopmode", "formula.tex"}, most);
  if (!set) return set.error();
  if (!*set) return complaint(at / "formula.log");
  // TeX's "specials" could contain programs in other languages, so they are dropped.
  const auto drawn = run_in(
      at,
      {"dvisvgm", "--no-fonts", "--exact-bbox", "--no-specials", "--cache=none", "-o", "formula.svg", "formula.dvi"},
      most);
  if (!drawn) return drawn.error();
  const FileContents svg = read_contents((at / "formula.svg").string(), {.largest = most_drawn});
  if (svg.problem == ReadProblem::too_large)
    return fail(ErrorCode::range, "the formula is too large: more than 1 MiB of paths");
  if (!*drawn || svg.problem != ReadProblem::none)
    return fail(ErrorCode::machine, "dvisvgm failed to draw the formula");
  auto outline = read_tex_drawing(svg.text);
  if (!outline) return outline.error();
  return std::make_shared<const Outline>(*std::move(outline));
}

}  // namespace betwixt
