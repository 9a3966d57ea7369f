#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "cirque/core/enum_words.h"
#include "cirque/core/option.h"
#include "cirque/core/status.h"
#include "cirque/core/text.h"

namespace cirque {

/// One line of the table of an options struct T: what the option is called, where it is stored, what
/// it means; and by the chained calls what it may be.
template <class T>
class Option {
 public:
  /// A member of T or of a base of it: bool, int, double, std::string, std::vector<int>, or an enum
  /// with words (kEnumWords), which are then the texts allowed.
  template <class Value, class Owner>
  Option(std::string name, Value Owner::*member, std::string help) {
    info_.name = std::move(name);
    info_.help = std::move(help);
    if constexpr (std::is_same_v<Value, bool>) info_.kind = OptionKind::kBoolean;
    if constexpr (std::is_same_v<Value, int>) info_.kind = OptionKind::kInteger;
    if constexpr (std::is_same_v<Value, double>) info_.kind = OptionKind::kNumber;
    if constexpr (std::is_same_v<Value, std::vector<int>>) info_.kind = OptionKind::kIntegers;
    if constexpr (std::is_enum_v<Value>) {
      info_.words = WordsOf<Value>();
      get_ = [member](const T& of) { return OptionValue(ToWord(of.*member)); };
      set_ = [member](const OptionValue& value, T* of) {
        of->*member = *FromWord<Value>(std::get<std::string>(value));
      };
    } else {
      get_ = [member](const T& of) { return OptionValue(of.*member); };
      set_ = [member](const OptionValue& value, T* of) { of->*member = std::get<Value>(value); };
    }
    info_.default_text = ToText(get_(T()));
  }

  /// A number within these, both included.
  Option Between(double lower, double upper) && {
    info_.bounds = {lower, upper};
    return std::move(*this);
  }
  /// A text among these; none: any.
  Option OneOf(std::vector<std::string> words) && {
    info_.words = std::move(words);
    return std::move(*this);
  }
  /// A text that passes this, such as a name with options of its own.
  Option Checked(OptionInfo::Check check) && {
    info_.check = std::move(check);
    return std::move(*this);
  }
  Option Unit(std::string unit) && {
    info_.unit = std::move(unit);
    return std::move(*this);
  }
  Option About(std::string group) && {
    info_.group = std::move(group);
    return std::move(*this);
  }
  Option Formerly(std::string name) && {
    info_.former.push_back(std::move(name));
    return std::move(*this);
  }

  const OptionInfo& info() const { return info_; }
  OptionValue Get(const T& of) const { return get_(of); }

  Status Check(const T& of) const { return CheckValue(info_, Get(of)); }

  Status Set(const std::string& text, T* of) const {
    const StatusOr<OptionValue> value = ParseValue(info_, text);
    if (value.ok()) set_(*value, of);
    return value.status();
  }

 private:
  OptionInfo info_;
  std::function<OptionValue(const T&)> get_;
  std::function<void(const OptionValue&, T*)> set_;
};

/// The options of a struct T, one line an option: the only place that knows their names, bounds,
/// meaning and, read from the struct itself, defaults. They are set, validated, printed and
/// documented by it.
template <class T>
class OptionTable {
 public:
  /// `owner` names the struct in messages: "newton".
  OptionTable(std::string owner, std::vector<Option<T>> options)
      : owner_(std::move(owner)), options_(std::move(options)) {}

  const std::string& owner() const { return owner_; }
  const std::vector<Option<T>>& options() const { return options_; }

  /// The option of that name, or of that former name; null: there is none.
  const Option<T>* Find(const std::string& name) const {
    for (const Option<T>& option : options_) {
      const std::vector<std::string>& former = option.info().former;
      if (option.info().name == name) return &option;
      if (std::find(former.begin(), former.end(), name) != former.end()) return &option;
    }
    return nullptr;
  }

  /// Sets what the map names. Errors (invalid input): an unknown name, a value that does not parse or
  /// may not be; the message names option, value and bound.
  Status Set(const OptionMap& map, T* target) const {
    for (const auto& [name, text] : map) {
      const Option<T>* option = Find(name);
      if (!option) return Status::InvalidInput(UnknownName(owner_ + " option", name, Names()));
      if (Status s = option->Set(text, target); !s.ok()) return s.In(owner_);
    }
    return Status();
  }

  /// Whether every option of the struct may have the value it has; messages as above.
  Status Validate(const T& of) const {
    for (const Option<T>& option : options_) {
      if (Status s = option.Check(of); !s.ok()) return s.In(owner_);
    }
    return Status();
  }

  /// All values as they would be written: Set gives back the same struct.
  OptionMap Values(const T& of) const {
    OptionMap values;
    for (const Option<T>& option : options_) values[option.info().name] = ToText(option.Get(of));
    return values;
  }

  std::vector<OptionInfo> Infos() const {
    std::vector<OptionInfo> infos;
    for (const Option<T>& option : options_) infos.push_back(option.info());
    return infos;
  }

  std::vector<std::string> Names() const {
    std::vector<std::string> names;
    for (const Option<T>& option : options_) names.push_back(option.info().name);
    return names;
  }

 private:
  std::string owner_;
  std::vector<Option<T>> options_;
};

/// The rows of a base's table, then those of the struct's own.
template <class T>
std::vector<Option<T>> Joined(std::vector<Option<T>> base, std::vector<Option<T>> own) {
  base.insert(base.end(), own.begin(), own.end());
  return base;
}

}  // namespace cirque
