#include "cirque/core/option.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "cirque/core/text.h"

namespace cirque {
namespace {

/// The whole text as a number: no octal, no trailing characters.
template <class Number>
std::optional<OptionValue> ParseNumber(const std::string& text) {
  Number value = {};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

std::optional<OptionValue> ParseIntegers(const std::string& text) {
  std::vector<int> list;
  std::istringstream items(text);
  for (std::string item; std::getline(items, item, ',');) {
    const std::optional<OptionValue> integer = ParseNumber<int>(item);
    if (!integer) return std::nullopt;
    list.push_back(std::get<int>(*integer));
  }
  return list;
}

std::optional<OptionValue> Parse(OptionKind kind, const std::string& text) {
  switch (kind) {
    case OptionKind::kBoolean:
      if (text == "true" || text == "false") return text == "true";
      return std::nullopt;
    case OptionKind::kInteger:
      return ParseNumber<int>(text);
    case OptionKind::kNumber:
      return ParseNumber<double>(text);
    case OptionKind::kText:
      return text;
    case OptionKind::kIntegers:
      return ParseIntegers(text);
  }
  return std::nullopt;
}

std::string InBounds(const OptionInfo& option) {
  const std::string unit = option.unit.empty() ? "" : " " + option.unit;
  const char* kind = option.kind == OptionKind::kNumber ? "a number" : "an integer";
  if (option.bounds.lower == -Bounds().upper && option.bounds.upper == Bounds().upper) {
    return kind + unit;
  }
  return fmt::format("{} in [{:g}, {:g}]{}", kind, option.bounds.lower, option.bounds.upper, unit);
}

Status Refusal(const OptionInfo& option, const std::string& text) {
  const std::string nearest = NearestWord(text, option.words);
  const std::string hint = nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
  return Status::InvalidInput(
      fmt::format("{} = '{}' is not {}{}", option.name, text, Expectation(option), hint));
}

}  // namespace

std::string ToText(const OptionValue& value) {
  if (const auto* list = std::get_if<std::vector<int>>(&value)) {
    return fmt::format("{}", fmt::join(*list, ","));
  }
  return std::visit(
      [](const auto& v) -> std::string {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::vector<int>>)
          return {};
        else
          return fmt::format("{}", v);
      },
      value);
}

std::string Expectation(const OptionInfo& option) {
  switch (option.kind) {
    case OptionKind::kBoolean:
      return "true or false";
    case OptionKind::kInteger:
    case OptionKind::kNumber:
      return InBounds(option);
    case OptionKind::kText:
      return option.words.empty() ? "a text" : "one of " + Join(option.words);
    case OptionKind::kIntegers:
      return "a list with commas, each " + InBounds(option);
  }
  return {};
}

Status CheckValue(const OptionInfo& option, const OptionValue& value) {
  const auto within = [&](double number) {  // false for NaN
    return number >= option.bounds.lower && number <= option.bounds.upper;
  };
  bool allowed = true;
  if (const int* integer = std::get_if<int>(&value)) allowed = within(*integer);
  if (const double* number = std::get_if<double>(&value)) allowed = within(*number);
  if (const auto* list = std::get_if<std::vector<int>>(&value)) {
    allowed = std::all_of(list->begin(), list->end(), within);
  }
  const std::string* text = std::get_if<std::string>(&value);
  if (text && *text == option.default_text) return Status();
  const std::vector<std::string>& words = option.words;
  if (text && !words.empty()) {
    allowed = std::find(words.begin(), words.end(), *text) != words.end();
  }
  if (!allowed) return Refusal(option, ToText(value));
  return text && option.check ? option.check(*text).In(option.name) : Status();
}

StatusOr<OptionValue> ParseValue(const OptionInfo& option, const std::string& text) {
  const std::optional<OptionValue> value = Parse(option.kind, text);
  if (!value) return Refusal(option, text);
  const Status status = CheckValue(option, *value);
  return status.ok() ? StatusOr<OptionValue>(*value) : status;
}

std::vector<std::string> UseNewNames(const std::vector<OptionInfo>& known, OptionMap* options) {
  std::vector<std::string> notes;
  for (const OptionInfo& option : known) {
    for (const std::string& former : option.former) {
      auto given = options->extract(former);
      if (given.empty()) continue;
      notes.push_back(fmt::format("'{}' is called '{}' now", former, option.name));
      given.key() = option.name;
      options->insert(std::move(given));
    }
  }
  return notes;
}

StatusOr<NameWithOptions> ParseNameWithOptions(const std::string& text) {
  const auto refuse = [&](const std::string& why) {
    return Status::InvalidInput(
        fmt::format("'{}': {}; expected NAME or NAME:KEY=VALUE,KEY=VALUE", text, why));
  };
  const std::size_t colon = text.find(':');
  NameWithOptions parsed = {text.substr(0, colon), {}};
  if (parsed.name.empty()) return refuse("the name is missing");
  if (colon == std::string::npos) return parsed;
  std::istringstream rest(text.substr(colon + 1));
  for (std::string item; std::getline(rest, item, ',');) {
    const std::size_t equals = item.find('=');
    if (equals == std::string::npos || equals == 0) return refuse("'" + item + "' is no KEY=VALUE");
    const std::string key = item.substr(0, equals);
    if (!parsed.options.emplace(key, item.substr(equals + 1)).second) {
      return refuse("'" + key + "' is given twice");
    }
  }
  return parsed;
}

}  // namespace cirque
