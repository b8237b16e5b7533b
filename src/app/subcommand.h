// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A subcommand is data: what it is called, what it takes, what it does. The command line, helps, completions and the
// manual page follow from it. Each has a file of its own, which enlists it.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "betwixt/render.h"
#include "betwixt/result.h"

namespace betwixt {

// Where a value goes: a flag's to a bool, values that can be many to a list, one of a form of its own to its reader.
using ReadValue = std::function<Status(const std::string&)>;
using Into = std::variant<bool*, int*, std::int64_t*, std::size_t*, std::string*, std::optional<std::string>*,
                          std::vector<std::string>*, ReadValue>;

// What a shell offers where a value is due, besides the parameter's words.
enum class Offer { nothing, files, scripts };

// An argument, or an option.
struct Parameter {
  std::string name;        // "FILE" for an argument, "--jobs" or "-o,--output" for an option
  std::string value = {};  // what helps call an option's value: "N"; empty for flags and arguments
  std::string sentence;    // what it is, or says
  Into into = static_cast<bool*>(nullptr);
  bool required = false;
  bool separated = false;                         // one word holds many, with commas between
  bool repeated = false;                          // the reader is asked again and again
  bool hidden = false;                            // from helps, completions and the manual
  bool words_only = false;                        // `words` are all that is taken
  std::vector<std::string> words = {};            // that a shell offers
  std::optional<std::pair<int, int>> range = {};  // of a number
  Offer offer = Offer::nothing;
  std::string needs = {}, excludes = {};  // another option

  bool is_option() const { return name.starts_with('-'); }
  bool is_flag() const { return std::holds_alternative<bool*>(into); }
};

struct Subcommand {
  int rank = 0;  // its place in lists
  std::string name, sentence;
  std::vector<Parameter> takes = {};
  std::string note = {};          // for the end of its help
  std::string example = {};       // the same
  std::string manual = {};        // what the manual says beyond the sentence
  std::function<int()> run = {};  // gives the exit code
};

// All that are enlisted, by rank. What they take is kept in them, so they are made once.
const std::vector<Subcommand>& subcommands();
// What every one of them takes besides.
const std::vector<Parameter>& common_parameters();

// A subcommand's file says `const Enlisted enlisted_render(render_subcommand);`.
struct Enlisted {
  explicit Enlisted(Subcommand (*make)());
};

// Rows that several have.
Parameter script_parameter(std::string& file);
Parameter frames_parameter(std::string& frames, const std::string& examples = "1f..24f");
void append_picture_parameters(std::vector<Parameter>&, RenderOptions&);  // --size, --style, --samples

}  // namespace betwixt
