#include "cirque/core/text.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

namespace cirque {
namespace {

/// Levenshtein distance where an exchange of two neighbours is one step (Damerau; optimal string
/// alignment), by three rows of the table.
int EditDistance(std::string_view a, std::string_view b) {
  std::vector<int> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = static_cast<int>(i) + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const int substituted = above[j] + (a[i] == b[j] ? 0 : 1);
      row[j + 1] = std::min({substituted, row[j] + 1, above[j + 1] + 1});
      const bool exchanged = i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j];
      if (exchanged) row[j + 1] = std::min(row[j + 1], before[j - 1] + 1);
    }
  }
  return row.back();
}

}  // namespace

std::string NearestWord(std::string_view word, const std::vector<std::string>& known) {
  int least = std::max<int>(2, static_cast<int>(word.size()) / 3) + 1;
  std::string nearest;
  for (const std::string& candidate : known) {
    // The lengths alone say that much, which spares long words the table of distances.
    const auto at_least =
        static_cast<long long>(candidate.size()) - static_cast<long long>(word.size());
    if (std::abs(at_least) >= least) continue;
    const int distance = EditDistance(word, candidate);
    if (distance >= least) continue;
    least = distance;
    nearest = candidate;
  }
  return nearest;
}

std::string UnknownName(std::string_view kind, std::string_view name,
                        const std::vector<std::string>& known) {
  const std::string nearest = NearestWord(name, known);
  const std::string hint = nearest.empty() ? "" : fmt::format("; did you mean '{}'?", nearest);
  return fmt::format("unknown {} '{}'{} Known: {}", kind, name, nearest.empty() ? "." : hint,
                     Join(known));
}

void CheckIsNew(std::string_view kind, std::string_view name,
                const std::vector<std::string>& known) {
  CHECK(std::find(known.begin(), known.end(), name) == known.end())
      << kind << " '" << name << "' is there already; its table names each once";
}

std::string Join(const std::vector<std::string>& words, std::string_view separator) {
  return fmt::format("{}", fmt::join(words, separator));
}

std::string Wrapped(std::string first, std::string_view text, std::size_t indent,
                    std::size_t columns) {
  std::string lines, line = std::move(first);
  if (line.size() >= indent) {
    lines = line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    line.clear();
  }
  line.resize(indent, ' ');
  std::istringstream words{std::string(text)};
  for (std::string word; words >> word;) {
    const bool is_first = line.size() == indent;
    if (!is_first && line.size() + 1 + word.size() > columns) {
      lines += line + "\n";
      line.assign(indent, ' ');
    } else if (!is_first) {
      line += ' ';
    }
    line += word;
  }
  return lines + line + "\n";
}

std::string IdList(const std::vector<int>& ids, int limit) {
  const int shown = std::min<int>(limit, static_cast<int>(ids.size()));
  std::string list = fmt::format("{}", fmt::join(ids.begin(), ids.begin() + shown, ", "));
  const int hidden = static_cast<int>(ids.size()) - shown;
  return hidden > 0 ? fmt::format("{} and {} more", list, hidden) : list;
}

}  // namespace cirque
