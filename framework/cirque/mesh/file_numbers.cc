#include "cirque/mesh/file_numbers.h"

#include <functional>
#include <regex>
#include <string>

namespace cirque {
namespace {

using NumberOf = std::function<Index(Index)>;

/// The decimal numbers of a list by those that `number_of` gives, from 1; empty where there is none
/// for one of them.
std::string Renumbered(const std::string& list, const NumberOf& number_of) {
  static const std::regex kNumber("[0-9]{1,9}");
  std::string text;
  auto end = list.cbegin();
  for (std::sregex_iterator match(list.begin(), list.end(), kNumber), last; match != last;
       ++match) {
    const Index number = number_of(std::stoi(match->str()));
    if (number == kNone) return {};
    text.append(end, (*match)[0].first);
    text += std::to_string(number + 1);
    end = (*match)[0].second;
  }
  text.append(end, list.cend());
  return text;
}

/// Replaces each "WORD LIST (0-based" of the message.
std::string Renumber(const std::string& message, const NumberOf& vertex, const NumberOf& face) {
  static const std::regex kMention(
      "(vertex|vertices|corners|faces?) ([0-9]+(?:, [0-9]+)*(?: and [0-9]+(?! more))?)"
      "( and [0-9]+ more)?"
      "(?: and (vertex|vertices) ([0-9]+(?:, [0-9]+)*)( and [0-9]+ more)?)?"
      " \\(0-based(?:\\)|(; ))");
  std::string text;
  auto end = message.cbegin();
  for (std::sregex_iterator match(message.begin(), message.end(), kMention), last; match != last;
       ++match) {
    const bool of_faces = (*match)[1].str().starts_with("face");
    const std::string list = Renumbered((*match)[2], of_faces ? face : vertex);
    const std::string second = Renumbered((*match)[5], vertex);
    if (list.empty() || ((*match)[5].matched && second.empty())) continue;
    text.append(end, (*match)[0].first);
    text += (*match)[1].str() + " " + list + (*match)[3].str();
    if ((*match)[5].matched) {
      text += " and " + (*match)[4].str() + " " + second + (*match)[6].str();
    }
    if ((*match)[7].matched) text += " (";
    end = (*match)[0].second;
  }
  text.append(end, message.cend());
  return text;
}

NumberOf In(const std::vector<Index>& numbers) {
  return [&numbers](Index i) {
    return i < static_cast<Index>(numbers.size()) ? numbers[static_cast<std::size_t>(i)] : kNone;
  };
}

}  // namespace

std::string NumberedAsInFile(const Surface& surface, const std::string& message) {
  return Renumber(message, In(surface.soup_vertex), In(surface.soup_polygon));
}

std::string NumberedFromOne(const std::string& message) {
  const NumberOf same = [](Index i) { return i; };
  return Renumber(message, same, same);
}

}  // namespace cirque
