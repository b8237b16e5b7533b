// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A subcommand is data: what it is called, what it takes, what it does. The command line, helps, completions and the
// manual page follow from it. Each has a file of its own, which enlists it.
#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "betwixt/document.h"
#include "betwixt/render.h"
#include "betwixt/result.h"

namespace betwixt {

// Where a value goes: a flag's to a bool, values that can be many to a list, one of a form of its own to its reader.
using ReadValue = std::function<Status(const std::string&)>;
using Into = std::variant<bool*, int*, std::int64_t*, std::size_t*, std::string*, std::optional<std::string>*,
                          std::vector<std::string>*, ReadValue>;

// What a shell offers where a value is due, besides the parameter's words.
enum class Offer { nothing, files, scripts, commands };

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
  std::function<int()> run = {};  // gives the exit code; filled in by Enlisted
};

// All that are enlisted, by rank. What they take is kept in them, so they are made once.
const std::vector<Subcommand>& subcommands();
// What every one of them takes besides.
const std::vector<Parameter>& common_parameters();

// What a subcommand's file says: `const Enlisted enlisted_tidy(tidy, [](TidyCall& call) -> Subcommand { … });`. The
// first carries a call out and gives the exit code; the other says what the subcommand is, its parameters going into
// the call.
class Enlisted {
 public:
  template <class Call, class Describe>
  Enlisted(int (*carry_out)(Call&), Describe describe)
      : Enlisted([=] {
          const auto call = std::make_shared<std::remove_const_t<Call>>();
          Subcommand made = describe(*call);
          made.run = [carry_out, call] { return carry_out(*call); };
          return made;
        }) {}

 private:
  explicit Enlisted(std::function<Subcommand()> make);
};

// Parameters that several have.
Parameter script_parameter(std::string& file);
Parameter targets_parameter(std::vector<std::string>& targets, const std::string& sentence, bool required = false);
// With a `usual` ending it need not be said: output_or() then says what it is.
Parameter output_parameter(std::string& out, const std::string& value, const std::string& sentence,
                           const std::string& usual = {});
// The output that was asked for, or one in the current folder: the script's name with the usual ending.
std::string output_or(const std::string& out, const std::string& script, const std::string& usual);
Parameter frames_parameter(std::string& frames, const std::string& examples = "1f..24f");
Parameter file_option(const std::string& name, const std::string& value, const std::string& sentence, Into into,
                      const std::string& excludes = {});
// What is told in words, none of them a file's name.
Parameter option(const std::string& name, const std::string& value, const std::string& sentence, Into into,
                 const std::string& excludes = {});
Parameter flag(const std::string& name, const std::string& sentence, bool& given);
Parameter size_parameter(std::optional<std::pair<int, int>>& size, const std::string& sentence);

// What is asked for of pictures; the rest is the script's to say, then `otherwise`.
struct PictureCall {
  RenderOptions otherwise;
  std::optional<std::pair<int, int>> size = {};
  std::optional<int> samples = {};
  RenderOptions of(const Document&) const;
};
// How pictures are taken that take time.
struct ExposureCall {
  std::optional<std::string> shutter = {};
  std::optional<int> subframes = {};
  // None: nothing is blurred. Errors: syntax, range.
  Result<std::optional<Exposure>> of(const Document&) const;
};
std::vector<Parameter> exposure_parameters(ExposureCall&);  // --shutter, --subframes
Parameter bits_parameter(int& bits);
Parameter quality_parameter(int& quality, const std::string& of);  // 1 to 100
std::vector<Parameter> picture_parameters(PictureCall&);           // --size, --style, --samples
std::vector<Parameter> joined(std::initializer_list<std::vector<Parameter>>);

}  // namespace betwixt
