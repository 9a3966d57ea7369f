#pragma once

#include <algorithm>
#include <charconv>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/status.h"
#include "cirque/core/text.h"

namespace cirque {

/// Options by name, as a config or a command line gives them.
using OptionMap = std::map<std::string, std::string>;

/// The fields of an options struct T by name, with their bounds and their meaning: one table from
/// which options are set, validated and documented.
template <class T>
class OptionTable {
 public:
  struct Field {
    std::string name;
    std::variant<int T::*, double T::*, std::string T::*> member;
    double lower, upper;               ///< of a number, both included
    std::vector<std::string> allowed;  ///< of a word; empty: any
    std::string help;
  };

  /// `owner` names the struct in messages: "newton".
  OptionTable(std::string owner, std::vector<Field> fields)
      : owner_(std::move(owner)), fields_(std::move(fields)) {}

  const std::vector<Field>& fields() const { return fields_; }

  /// Sets what the map names; an unknown name, a value that does not parse or one out of bounds is
  /// an error that names option, value and bound.
  Status Set(const OptionMap& options, T* target) const {
    for (const auto& [name, text] : options) {
      const Field* field = FindField(name);
      if (!field) return Status::InvalidInput(UnknownName(owner_ + " option", name, Names()));
      if (Status s = SetField(*field, text, target); !s.ok()) return s;
    }
    return Status();
  }

  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const Field& field : fields_) names.push_back(field.name);
    return names;
  }

 private:
  const Field* FindField(const std::string& name) const {
    for (const Field& field : fields_) {
      if (field.name == name) return &field;
    }
    return nullptr;
  }

  Status Refusal(const Field& field, const std::string& text, const std::string& expected) const {
    return Status::InvalidInput(
        fmt::format("{}: {} = '{}' is not {}", owner_, field.name, text, expected));
  }

  template <class Number>
  Status SetNumber(const Field& field, const std::string& text, Number* number) const {
    Number parsed = {};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    if (!whole || !(parsed >= field.lower && parsed <= field.upper)) {
      const char* kind = std::is_integral_v<Number> ? "an integer" : "a number";
      return Refusal(field, text,
                     fmt::format("{} in [{:g}, {:g}]", kind, field.lower, field.upper));
    }
    *number = parsed;
    return Status();
  }

  Status SetField(const Field& field, const std::string& text, T* target) const {
    if (const auto* integer = std::get_if<int T::*>(&field.member)) {
      return SetNumber(field, text, &(target->**integer));
    }
    if (const auto* real = std::get_if<double T::*>(&field.member)) {
      return SetNumber(field, text, &(target->**real));
    }
    const auto& allowed = field.allowed;
    if (!allowed.empty() && std::find(allowed.begin(), allowed.end(), text) == allowed.end()) {
      return Refusal(field, text, "one of " + Join(allowed));
    }
    target->*std::get<std::string T::*>(field.member) = text;
    return Status();
  }

  std::string owner_;
  std::vector<Field> fields_;
};

}  // namespace cirque
