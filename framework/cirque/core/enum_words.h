#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cirque {

/// One value of an enum and the word for it in flags, configs, records and messages.
template <class E>
struct EnumWord {
  E value;
  std::string_view word;
};

/// The words of an enum, the only place that spells them. An enum that has words specialises this
/// beside itself:
///   template <>
///   inline constexpr auto kEnumWords<Seams> = std::to_array<EnumWord<Seams>>(
///       {{Seams::kRigid, "rigid"}, {Seams::kFree, "free"}});
template <class E>
inline constexpr auto kEnumWords = nullptr;

/// All words, in the order of the table.
template <class E>
std::vector<std::string> WordsOf() {
  std::vector<std::string> words;
  for (const EnumWord<E>& known : kEnumWords<E>) words.emplace_back(known.word);
  return words;
}

/// The word of a value; empty for one that the table lacks.
template <class E>
std::string ToWord(E value) {
  for (const EnumWord<E>& known : kEnumWords<E>) {
    if (known.value == value) return std::string(known.word);
  }
  return {};
}

/// The value that the word stands for, or nothing.
template <class E>
std::optional<E> FromWord(std::string_view word) {
  for (const EnumWord<E>& known : kEnumWords<E>) {
    if (known.word == word) return known.value;
  }
  return std::nullopt;
}

}  // namespace cirque
