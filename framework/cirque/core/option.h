#pragma once

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <variant>
#include <vector>

#include "cirque/core/status.h"

namespace cirque {

/// Options by name, as a config or a command line gives them.
using OptionMap = std::map<std::string, std::string>;

/// The value of an option of any kind; an enum's is its word.
using OptionValue = std::variant<bool, int, double, std::string, std::vector<int>>;

/// What an option holds.
enum class OptionKind { kBoolean, kInteger, kNumber, kText, kIntegers };

/// Least and greatest value of a number, both included.
struct Bounds {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
};

/// What every way to set an option needs to know of it: flags, keys of configs, help texts and
/// reference pages are loops over these.
struct OptionInfo {
  using Check = std::function<Status(const std::string& text)>;

  std::string name;
  OptionKind kind = OptionKind::kText;
  std::string help;
  Bounds bounds = {};                    ///< of a number, or of each in a list
  std::vector<std::string> words = {};   ///< of a text: those allowed; empty: any
  std::string unit = {};                 ///< "rad", "s", "vertex"; empty: none
  std::string group = {};                ///< what it is about: help is ordered by it
  std::string default_text = {};         ///< as it would be written; always allowed
  std::vector<std::string> former = {};  ///< names that it had once, which still work
  Check check = {};                      ///< of a text, without doing what it says; empty: none
};

/// The value as it would be written: a number with all its digits, a list with commas.
std::string ToText(const OptionValue& value);

/// Whether the kind is one of numbers, by which runs can be ordered.
inline bool IsNumeric(OptionKind kind) {
  return kind == OptionKind::kInteger || kind == OptionKind::kNumber;
}

/// What a value must be: "an integer in [1, 1000]", "one of a, b", "true or false", "a text".
std::string Expectation(const OptionInfo& option);

/// Whether the option may have this value. Error (invalid input): "NAME = 'VALUE' is not EXPECTED",
/// with the word that was meant where a known one is near.
Status CheckValue(const OptionInfo& option, const OptionValue& value);

/// The value that a text stands for, checked. Errors (invalid input): as above.
StatusOr<OptionValue> ParseValue(const OptionInfo& option, const std::string& text);

/// "'OLD' is called 'NEW' now" for each option that `options` names by a former name; there it has
/// its new one from then on.
std::vector<std::string> UseNewNames(const std::vector<OptionInfo>& known, OptionMap* options);

/// A name of a registry and options for what it names, as flags and configs hold them in one text:
/// "NAME" or "NAME:KEY=VALUE,KEY=VALUE".
struct NameWithOptions {
  std::string name;
  OptionMap options;
};

/// Errors (invalid input): an empty name, an option without '=', a key that is empty or given
/// twice.
StatusOr<NameWithOptions> ParseNameWithOptions(const std::string& text);

}  // namespace cirque
