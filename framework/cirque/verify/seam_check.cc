#include "cirque/verify/seam_check.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/verify/report_words.h"

namespace cirque::verify {
namespace {

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// What takes one side of a seam edge to the other: from the patch of greater number to that of
/// smaller.
struct Passage {
  Index halfedge;
  double log_ratio;
  double rotation;
};

Passage PassageAt(const UvComplex& complex, Index h) {
  const Index t = complex.surface.twin[h];
  const Point here = complex.Tip(h) - complex.Tail(h), there = complex.Tail(t) - complex.Tip(t);
  const double ratio = std::log(here.norm()) - std::log(there.norm());
  const double rotation = std::atan2(there.x() * here.y() - there.y() * here.x(), there.dot(here));
  const double sign = complex.patch[h / 3] <= complex.patch[t / 3] ? 1 : -1;
  return {h, sign * ratio, sign * rotation};
}

using Passages = std::map<std::pair<Index, Index>, std::vector<Passage>>;

Passages CollectPassages(const UvComplex& complex) {
  Passages passages;
  for (Index h = 0; h < static_cast<Index>(complex.uv.size()); ++h) {
    const Index t = complex.surface.twin[h];
    if (t < h || !complex.IsSeam(h)) continue;
    passages[std::minmax(complex.patch[h / 3], complex.patch[t / 3])].push_back(
        PassageAt(complex, h));
  }
  return passages;
}

void KeepLarger(double value, Index halfedge, double* largest, Index* where) {
  if (value <= *largest) return;
  *largest = value;
  *where = halfedge;
}

}  // namespace

SeamAgreement CompareSeams(const UvComplex& complex, int order) {
  SeamAgreement result;
  for (const auto& [patches, passages] : CollectPassages(complex)) {
    const bool one_patch = patches.first == patches.second;
    std::vector<double> ratios;
    for (const Passage& passage : passages) ratios.push_back(passage.log_ratio);
    const double scale = one_patch ? 0.0 : Median(std::move(ratios));
    const double turn = one_patch ? 0.0 : passages.front().rotation;
    for (const Passage& passage : passages) {
      KeepLarger(std::abs(std::expm1(passage.log_ratio - scale)), passage.halfedge,
                 &result.largest_difference, &result.worst_halfedge);
      if (order <= 0) continue;
      KeepLarger(std::abs(std::remainder(passage.rotation - turn, 2 * kPi / order)),
                 passage.halfedge, &result.largest_rotation_gap, &result.worst_rotation);
    }
  }
  return result;
}

namespace {

std::string PairList(const std::set<VertexPair>& edges) {
  constexpr std::size_t kShown = 10;
  std::vector<std::string> words;
  for (const auto& [a, b] : edges) {
    if (words.size() == kShown) break;
    words.push_back(fmt::format("{}-{}", a, b));
  }
  if (edges.size() > kShown) words.push_back(fmt::format("and {} more", edges.size() - kShown));
  return Join(words);
}

void CompareWithList(const UvComplex& complex, const std::vector<VertexPair>& edges,
                     std::vector<std::string>* errors) {
  std::set<VertexPair> wanted, cut, missing, unwanted;
  for (const auto& [a, b] : edges) wanted.insert(std::minmax(a, b));
  for (Index h = 0; h < static_cast<Index>(complex.uv.size()); ++h) {
    if (!complex.IsSeam(h)) continue;
    cut.insert(std::minmax({complex.mesh().Origin(complex.mesh().Tail(h)),
                            complex.mesh().Origin(complex.mesh().Tip(h))}));
  }
  std::set_difference(wanted.begin(), wanted.end(), cut.begin(), cut.end(),
                      std::inserter(missing, missing.end()));
  std::set_difference(cut.begin(), cut.end(), wanted.begin(), wanted.end(),
                      std::inserter(unwanted, unwanted.end()));
  if (!missing.empty()) {
    errors->push_back(fmt::format("{} that should be a seam is none: {}",
                                  Count(missing.size(), "edge"), PairList(missing)));
  }
  if (!unwanted.empty()) {
    errors->push_back(fmt::format("{} that should not be there: {}",
                                  Count(unwanted.size(), "seam edge"), PairList(unwanted)));
  }
}

}  // namespace

std::vector<std::string> SeamErrors(const UvComplex& complex, const SeamAgreement& found,
                                    const SeamLimits& limits) {
  std::vector<std::string> errors;
  if (limits.max_patches && complex.num_patches > *limits.max_patches) {
    errors.push_back(
        fmt::format("{}, {} allowed", Count(complex.num_patches, "patch"), *limits.max_patches));
  }
  if (limits.max_edges && complex.num_seam_edges > *limits.max_edges) {
    errors.push_back(fmt::format("{}, {} allowed", Count(complex.num_seam_edges, "seam edge"),
                                 *limits.max_edges));
  }
  if (limits.edges) CompareWithList(complex, *limits.edges, &errors);
  if (limits.rigid && found.largest_difference > limits.tolerance) {
    errors.push_back(fmt::format(
        "the two sides of seam {} differ in length by {:.3g}, {:.3g} allowed",
        NameEdge(complex, found.worst_halfedge), found.largest_difference, limits.tolerance));
  }
  if (limits.rotation_order > 0 && found.largest_rotation_gap > limits.tolerance) {
    errors.push_back(fmt::format(
        "the two sides of seam {} are turned against each other by no multiple of 2 pi / {}: "
        "{:.3g} rad off, {:.3g} allowed",
        NameEdge(complex, found.worst_rotation), limits.rotation_order, found.largest_rotation_gap,
        limits.tolerance));
  }
  return errors;
}

std::string SeamStatement(const UvComplex& complex) {
  const std::string patches = Count(complex.num_patches, "patch");
  const std::string seams = Count(complex.num_seam_edges, "seam edge");
  if (!complex.torn()) return fmt::format("{}, {}", patches, seams);
  return fmt::format("torn: {} of {}, {}", patches, Count(complex.num_components, "component"),
                     seams);
}

namespace {

/// The whole numbers of a line; nothing where a word is none.
std::optional<std::vector<long long>> WholeNumbers(const std::string& line) {
  std::vector<long long> numbers;
  const std::string text = line.substr(0, line.find('#'));
  const char *at = text.data(), *const end = text.data() + text.size();
  while (true) {
    while (at != end && (*at == ' ' || *at == '\t' || *at == '\r')) ++at;
    if (at == end) return numbers;
    long long number = 0;
    const auto [next, error] = std::from_chars(at, end, number);
    const bool ends = next == end || *next == ' ' || *next == '\t' || *next == '\r';
    if (error != std::errc() || !ends) return std::nullopt;
    numbers.push_back(number);
    at = next;
  }
}

}  // namespace

StatusOr<std::vector<VertexPair>> ReadEdges(const std::string& path, Index num_vertices) {
  std::ifstream file(path);
  if (!file) return Status::InvalidInput(fmt::format("{}: cannot be read", path));
  std::vector<VertexPair> edges;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    const std::optional<std::vector<long long>> words = WholeNumbers(line);
    if (words && words->empty()) continue;
    if (!words || words->size() < 2 || words->size() > 3) {
      return Status::InvalidInput(fmt::format(
          "{}:{}: an edge is 'from to' or 'from to face', numbers from 1", path, number));
    }
    for (const long long v : {(*words)[0], (*words)[1]}) {
      if (v >= 1 && v <= num_vertices) continue;
      return Status::InvalidInput(
          fmt::format("{}:{}: no vertex {}; there are {}", path, number, v, num_vertices));
    }
    edges.emplace_back(static_cast<Index>((*words)[0] - 1), static_cast<Index>((*words)[1] - 1));
  }
  return edges;
}

}  // namespace cirque::verify
