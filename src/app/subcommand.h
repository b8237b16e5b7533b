// SPDX-FileCopyrightText: 2026 The Betwixt authors
// SPDX-License-Identifier: Apache-2.0
//
// A subcommand is data: its name, its parameters, its function. The command line, help, completions and the manual page
// are generated from it. Each one has a file of its own, which registers it.
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

// The destination of a value: a bool for a flag, a list for repeated values, a reader for values with a syntax of their
// own.
using ReadValue = std::function<Status(const std::string&)>;
using Into = std::variant<bool*, int*, std::int64_t*, std::size_t*, std::string*, std::optional<std::string>*,
                          std::vector<std::string>*, ReadValue>;

// Completions that a shell offers for a value, besides the parameter's words.
enum class Offer { nothing, files, scripts, commands };

// An argument or an option.
struct Parameter {
  std::string name;        // "FILE" for an argument, "--jobs" or "-o,--output" for an option
  std::string value = {};  // the name of an option's value in help: "N"; empty for flags and arguments
  std::string sentence;    // the description
  Into into = static_cast<bool*>(nullptr);
  bool required = false;
  bool separated = false;                         // one word holds several values, with commas between them
  bool repeated = false;                          // the option can be given again; its reader is called each time
  bool hidden = false;                            // in help, completions and the manual
  bool words_only = false;                        // `words` are the only valid values
  std::vector<std::string> words = {};            // offered by a shell
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
  std::string note = {};          // printed at the end of its help
  std::string example = {};       // printed there too
  std::string manual = {};        // added to the sentence in the manual
  std::function<int()> run = {};  // returns the exit code; set by Enlisted
};

// Returns all registered subcommands, by rank. They hold the values of their parameters, so they are created once.
const std::vector<Subcommand>& subcommands();
// Returns the parameters that all subcommands share.
const std::vector<Parameter>& common_parameters();

// Registers a subcommand: `const Enlisted enlisted_tidy(tidy, [](TidyCall& call) -> Subcommand { … });`. The first
// function carries a call out and returns the exit code. The second one describes the subcommand and binds its
// parameters to the call.
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

// Parameters that several subcommands have.
Parameter script_parameter(std::string& file);
Parameter targets_parameter(std::vector<std::string>& targets, const std::string& sentence, bool required = false);
// With a `usual` ending the user can leave it out; output_or() then chooses the name.
Parameter output_parameter(std::string& out, const std::string& value, const std::string& sentence,
                           const std::string& usual = {});
// Returns the given output, or a file in the current folder: the script's name with the usual ending.
std::string output_or(const std::string& out, const std::string& script, const std::string& usual);
Parameter frames_parameter(std::string& frames, const std::string& examples = "1f..24f");
// Sets `frames` to those of a section.
Parameter section_parameter(std::string& frames);
Parameter file_option(const std::string& name, const std::string& value, const std::string& sentence, Into into,
                      const std::string& excludes = {});
// An option whose value is no file name.
Parameter option(const std::string& name, const std::string& value, const std::string& sentence, Into into,
                 const std::string& excludes = {});
Parameter flag(const std::string& name, const std::string& sentence, bool& given);
Parameter size_parameter(std::optional<std::pair<int, int>>& size, const std::string& sentence);

// Options for pictures. The script's values apply where an option is missing, then `otherwise`.
struct PictureCall {
  RenderOptions otherwise;
  std::optional<std::pair<int, int>> size = {};
  std::optional<int> samples = {};
  std::string pixel_filter = {};  // "": the script's
  RenderOptions of(const Document&) const;
};
// Options for motion blur.
struct ExposureCall {
  std::optional<std::string> shutter = {};
  std::optional<int> subframes = {};
  // Returns nullopt if there is no motion blur. Errors: syntax, range.
  Result<std::optional<Blur>> of(const Document&) const;
};
std::vector<Parameter> exposure_parameters(ExposureCall&);  // --shutter, --subframes
Parameter bits_parameter(int& bits);
Parameter colors_parameter(ColorCoding&);
Parameter quality_parameter(int& quality, const std::string& of);  // 1 to 100
std::vector<Parameter> picture_parameters(PictureCall&);  // --size, --style, --samples, --denoise, --pixel-filter
std::vector<Parameter> joined(std::initializer_list<std::vector<Parameter>>);

}  // namespace betwixt
