#include "cirque/cones/cone.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/core/metric.h"
#include "cirque/core/option.h"

namespace cirque {
namespace {

constexpr double kRounding = 1e-9;  ///< [rad] of a sum of all targets

/// What is wrong with a cone; empty: nothing.
std::string Fault(const Cone& cone, const std::vector<Index>& corners) {
  const auto count = static_cast<Index>(corners.size());
  if (cone.vertex < 0 || cone.vertex >= count) {
    return fmt::format("the surface has vertices 0 to {} only", count - 1);
  }
  if (!(cone.lower <= cone.upper && cone.lower >= 0 && cone.upper > 0)) {
    return fmt::format(
        "its angle sum is to lie in [{}, {}] rad: give 0 <= lower <= upper, upper > 0", cone.lower,
        cone.upper);
  }
  if (cone.lower >= kPi * corners[cone.vertex]) {
    return fmt::format("its {}, each less than pi, cannot add up to {:.6g} pi",
                       Count(corners[cone.vertex], "corner"), cone.lower / kPi);
  }
  return {};
}

}  // namespace

StatusOr<ConeTargets> TargetsAtCones(const Triangulation& t, const std::vector<Cone>& cones) {
  ConeTargets targets = FreeBoundaryTargets(t);
  const std::vector<Index> corners = CornersPerVertex(t);
  std::vector<bool> named(t.num_vertices, false);
  for (const Cone& cone : cones) {
    std::string fault = Fault(cone, corners);
    if (fault.empty() && named[cone.vertex]) fault = "it is named twice";
    if (!fault.empty()) {
      return Status::InvalidInput(
          fmt::format("cone at vertex {} (0-based): {}", cone.vertex, fault));
    }
    named[cone.vertex] = true;
    targets.lower[cone.vertex] = cone.lower;
    targets.upper[cone.vertex] = cone.upper;
  }
  return targets;
}

StatusOr<ConeTargets> ConeTargetsOf(const Triangulation& t, const std::vector<Cone>& cones) {
  StatusOr<ConeTargets> targets = TargetsAtCones(t, cones);
  if (!targets.ok()) return targets;
  const GaussBonnetDefect defect = MeasureGaussBonnetDefect(t, *targets);
  if (BoundaryLoops(t).empty() && !defect.IsZeroPossible(kRounding)) {
    return Status::InvalidInput(fmt::format(
        "Gauss-Bonnet: with {} the angle sums are {:.6g} pi {} what the triangles have; "
        "a closed surface needs cones of curvature {} pi in all",
        Count(cones.size(), "cone"), std::abs(defect.lower > 0 ? defect.lower : defect.upper) / kPi,
        defect.lower > 0 ? "above" : "below", 2 * EulerCharacteristic(t)));
  }
  return targets;
}

std::vector<Cone> ConesOf(const Triangulation& t, const ConeTargets& targets) {
  const ConeTargets plain = FreeBoundaryTargets(t);
  std::vector<Cone> cones;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (targets.lower[v] == plain.lower[v] && targets.upper[v] == plain.upper[v]) continue;
    cones.push_back({v, targets.lower[v], targets.upper[v]});
  }
  return cones;
}

namespace {

const OptionTable<ConeAngleOptions>& AngleOptionTable() {
  using O = ConeAngleOptions;
  static const OptionTable<O> kTable(
      "cone_angles",
      {{"angles", &O::angles, "how"},
       Option<O>("width", &O::width, "half of a range").Between(0, 2 * kPi).Unit("rad")});
  return kTable;
}

/// Curvatures as whole numbers of parts of pi.
class Rounding {
 public:
  Rounding(const ConeProblem& problem, std::vector<Cone>* cones, int parts)
      : problem_(problem), cones_(*cones), parts_(parts) {}

  Status Run() {
    const double unit = kPi / parts_;
    for (const Cone& cone : cones_) {
      const double target = (2 * kPi - cone.lower) / unit;
      least_.push_back(std::ceil(problem_.LeastCurvature(cone.vertex) / unit - 1e-9));
      greatest_.push_back(std::floor(problem_.GreatestCurvature() / unit + 1e-9));
      target_.push_back(target);
      count_.push_back(std::clamp(std::round(target), least_.back(), greatest_.back()));
    }
    if (problem_.IsClosed() && !CloseTotal()) {
      return Status::InvalidInput(
          fmt::format("cones at {} with angles in multiples of pi/{} cannot add up as Gauss-Bonnet "
                      "asks: use more cones, or free angles",
                      Count(cones_.size(), "vertex"), parts_));
    }
    for (std::size_t i = 0; i < cones_.size(); ++i) {
      cones_[i].lower = cones_[i].upper = kPi * (2 - count_[i] / parts_);
    }
    std::erase_if(cones_, [](const Cone& c) { return c.lower == 2 * kPi; });
    return Status();
  }

 private:
  /// One unit after the other where it is missed least.
  bool CloseTotal() {
    const double total = std::round(problem_.TotalCurvature() / kPi) * parts_;
    double missing = total;
    for (const double count : count_) missing -= count;
    for (; missing != 0; missing -= missing > 0 ? 1 : -1) {
      const double step = missing > 0 ? 1 : -1;
      int best = -1;
      for (std::size_t i = 0; i < count_.size(); ++i) {
        const double next = count_[i] + step;
        if (next < least_[i] || next > greatest_[i]) continue;
        if (best < 0 || Cost(i, step) < Cost(best, step)) best = static_cast<int>(i);
      }
      if (best < 0) return false;
      count_[best] += step;
    }
    return true;
  }

  double Cost(std::size_t i, double step) const {
    return std::abs(count_[i] + step - target_[i]) - std::abs(count_[i] - target_[i]);
  }

  const ConeProblem& problem_;
  std::vector<Cone>& cones_;
  const int parts_;
  std::vector<double> target_, count_, least_, greatest_;
};

void Widen(const ConeProblem& problem, double width, std::vector<Cone>* cones) {
  for (Cone& cone : *cones) {
    const double least = 2 * kPi - problem.GreatestCurvature();
    const double greatest = 2 * kPi - problem.LeastCurvature(cone.vertex);
    const double angle = cone.lower;
    cone.lower = std::min(angle, std::max(least, angle - width));
    cone.upper = std::max(angle, std::min(greatest, angle + width));
  }
}

}  // namespace

StatusOr<ConeAngleOptions> ParseConeAngles(const std::string& text) {
  StatusOr<NameWithOptions> parsed = ParseNameWithOptions(text);
  if (!parsed.ok()) return parsed.status();
  if (parsed->name != "ranges" && parsed->options.contains("width")) {
    return Status::InvalidInput("a width belongs to ranges, not to " + parsed->name);
  }
  parsed->options["angles"] = parsed->name;
  ConeAngleOptions options;
  if (Status s = AngleOptionTable().Set(parsed->options, &options); !s.ok()) return s;
  return options;
}

Status CheckConeAngles(const std::string& text) { return ParseConeAngles(text).status(); }

StatusOr<std::vector<Cone>> ApplyConeAngles(const ConeProblem& problem, std::vector<Cone> cones,
                                            const ConeAngleOptions& options) {
  const auto open_end = std::stable_partition(cones.begin(), cones.end(), [&](const Cone& c) {
    return c.lower == c.upper && problem.IsCandidate(c.vertex);
  });
  const std::vector<Cone> kept(open_end, cones.end());
  cones.erase(open_end, cones.end());
  if (options.angles == ConeAngleRule::kRanges) Widen(problem, options.width, &cones);
  if (options.angles == ConeAngleRule::kHalves || options.angles == ConeAngleRule::kThirds) {
    const int parts = options.angles == ConeAngleRule::kHalves ? 2 : 3;
    if (Status s = Rounding(problem, &cones, parts).Run(); !s.ok()) return s;
  }
  cones.insert(cones.end(), kept.begin(), kept.end());
  return cones;
}

}  // namespace cirque
