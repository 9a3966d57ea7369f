#include "experiments/experiment_report/comparison.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "experiments/common/records.h"

namespace cirque::experiment_report {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kTie = 1e-3;    ///< values that differ by less are equally good
constexpr double kLeast = 1e-5;  ///< distortion below it is none
constexpr double kTail = 0.025;

/// A figure, and what it is at best.
struct Figure {
  const char* label;
  const char* pointer;
  double best, least;
};

constexpr Figure kFigures[] = {
    {"mean quasi-conformal distortion - 1", "/values/quasi_conformal_mean", 1, kLeast},
    {"log area ratio, root mean square", "/values/log_area_ratio_l2", 0, kLeast},
    {"CPU time [s]", "/cpu_seconds", 0, 0},
};

double Median(std::vector<double> values) {
  if (values.empty()) return kNan;
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::vector<std::string> InOrder(const std::vector<Run>& runs, std::string Run::*name) {
  std::vector<std::string> names;
  for (const Run& run : runs) {
    if (std::find(names.begin(), names.end(), run.*name) == names.end()) names.push_back(run.*name);
  }
  return names;
}

std::size_t PlaceOf(const std::vector<std::string>& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

/// [mesh][method].
std::vector<std::vector<double>> ValuesOf(const std::vector<Run>& runs, const Figure& figure,
                                          const Comparison& of) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> repeats;
  for (const Run& run : runs) {
    const double value = NumberAt(run.record, figure.pointer) - figure.best;
    if (!run.IsOk() || !std::isfinite(value)) continue;
    repeats[{PlaceOf(of.meshes, run.mesh), PlaceOf(of.methods, run.method)}].push_back(
        value < figure.least ? 0 : value);
  }
  std::vector<std::vector<double>> values(of.meshes.size(),
                                          std::vector<double>(of.methods.size(), kNan));
  for (const auto& [place, own] : repeats) values[place.first][place.second] = Median(own);
  return values;
}

int MapsOf(const Comparison& of, std::size_t method) {
  return static_cast<int>(std::count_if(of.value.begin(), of.value.end(), [&](const auto& row) {
    return std::isfinite(row[method]);
  }));
}

bool IsMapped(const std::vector<double>& row) {
  return std::any_of(row.begin(), row.end(), [](double value) { return std::isfinite(value); });
}

/// The least of the contenders of a mesh; NaN where one has no map of it.
double LeastOf(const std::vector<double>& row, const std::vector<MethodScore>& scores) {
  double least = kInfinity;
  for (std::size_t m = 0; m < row.size(); ++m) {
    if (scores[m].contends && !std::isfinite(row[m])) return kNan;
    if (scores[m].contends) least = std::min(least, row[m]);
  }
  return least;
}

/// How a method does, of which ContendersOf has said whether it contends.
void ScoreMethod(std::size_t method, Comparison* of) {
  MethodScore& score = of->scores[method];
  std::vector<double> own, ratios;
  for (const std::vector<double>& row : of->value) {
    const double value = row[method], first = row[0];
    if (!std::isfinite(value)) continue;
    own.push_back(value);
    if (value > 0 && first > 0) ratios.push_back(value / first);
    score.wins += score.contends && value <= (1 + kTie) * LeastOf(row, of->scores);
  }
  score.median = Median(own);
  score.pairs = static_cast<int>(ratios.size());
  score.ratio = Median(ratios);
  std::tie(score.ratio_low, score.ratio_high) = MedianInterval(ratios);
}

/// Who maps how much, and who contends.
std::vector<MethodScore> ContendersOf(const Comparison& of) {
  const auto mapped = std::count_if(of.value.begin(), of.value.end(), IsMapped);
  std::vector<MethodScore> scores(of.methods.size());
  for (std::size_t m = 0; m < of.methods.size(); ++m) {
    scores[m].method = of.methods[m];
    scores[m].maps = MapsOf(of, m);
    scores[m].contends = 2 * scores[m].maps >= mapped;
  }
  return scores;
}

/// "A and B".
std::string Enumerated(const std::vector<std::string>& names) {
  return fmt::format("{}", fmt::join(names, " and "));
}

/// What follows on the verdict where methods were left out of it.
std::string LeftOut(const Comparison& of) {
  std::string sentence;
  for (const MethodScore& score : of.scores) {
    if (score.contends) continue;
    sentence += fmt::format(" {} maps {} of {} and does not count.", score.method, score.maps,
                            of.meshes.size());
  }
  return sentence;
}

std::string VerdictOf(const Comparison& of) {
  if (of.common == 0) return fmt::format("{}: no mesh is mapped by every method.", of.label);
  int most = 0;
  for (const MethodScore& score : of.scores) most = std::max(most, score.wins);
  std::vector<std::string> best;
  const MethodScore* shown = nullptr;
  for (const MethodScore& score : of.scores) {
    if (!score.contends || score.wins < most) continue;
    best.push_back(score.method);
    if (shown == nullptr && &score != &of.scores[0]) shown = &score;
  }
  std::string sentence = fmt::format("{}: least by {} on {} of {} meshes", of.label,
                                     Enumerated(best), most, of.common);
  if (shown == nullptr || shown->pairs == 0) return sentence + ".";
  sentence += fmt::format("; {} has {:.3g} times that of {} in the median of {}", shown->method,
                          shown->ratio, of.methods[0], shown->pairs);
  if (!std::isfinite(shown->ratio_high)) return sentence + ", too few for an interval.";
  return sentence + fmt::format(" (95 %: {:.3g} to {:.3g}).", shown->ratio_low, shown->ratio_high);
}

}  // namespace

std::pair<double, double> MedianInterval(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  // How many of n fair coins fall on one side at most once in 40 times.
  double cumulated = 0;
  std::size_t below = 0;
  for (std::size_t k = 0; 2 * k < values.size(); ++k) {
    const auto x = static_cast<double>(k);
    cumulated += std::exp(std::lgamma(n + 1) - std::lgamma(x + 1) - std::lgamma(n - x + 1) -
                          n * std::log(2));
    if (cumulated > kTail) break;
    below = k + 1;
  }
  if (below == 0) return {-kInfinity, kInfinity};
  return {values[below - 1], values[values.size() - below]};
}

std::vector<Comparison> CompareMethods(const std::vector<Run>& runs) {
  std::vector<Comparison> comparisons;
  const std::vector<std::string> methods = InOrder(runs, &Run::method);
  if (methods.size() < 2) return comparisons;
  for (const Figure& figure : kFigures) {
    Comparison comparison;
    comparison.label = figure.label;
    comparison.meshes = InOrder(runs, &Run::mesh);
    comparison.methods = methods;
    comparison.value = ValuesOf(runs, figure, comparison);
    if (std::none_of(comparison.value.begin(), comparison.value.end(), IsMapped)) continue;
    comparison.scores = ContendersOf(comparison);
    comparison.common = static_cast<int>(std::count_if(
        comparison.value.begin(), comparison.value.end(),
        [&](const auto& row) { return std::isfinite(LeastOf(row, comparison.scores)); }));
    for (std::size_t m = 0; m < methods.size(); ++m) {
      ScoreMethod(m, &comparison);
    }
    comparisons.push_back(std::move(comparison));
  }
  return comparisons;
}

std::vector<std::string> VerdictsOf(const std::vector<Comparison>& comparisons) {
  std::vector<std::string> sentences;
  for (const Comparison& comparison : comparisons) {
    sentences.push_back(VerdictOf(comparison) + LeftOut(comparison));
    char& first = sentences.back()[0];
    first = static_cast<char>(std::toupper(static_cast<unsigned char>(first)));
  }
  return sentences;
}

}  // namespace cirque::experiment_report
