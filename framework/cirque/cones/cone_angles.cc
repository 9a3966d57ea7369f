#include "cirque/cones/cone_angles.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cirque/core/name_with_options.h"

namespace cirque {
namespace {

const OptionTable<ConeAngleOptions>& AngleOptionTable() {
  static const OptionTable<ConeAngleOptions> kTable(
      "cone_angles",
      {{"angles", &ConeAngleOptions::angles, 0, 0, ConeAngleWords(), "how"},
       {"width", &ConeAngleOptions::width, 0, 2 * kPi, {}, "half of a range [rad]"}});
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
      const double wanted = (2 * kPi - cone.lower) / unit;
      least_.push_back(std::ceil(problem_.LeastCurvature(cone.vertex) / unit - 1e-9));
      greatest_.push_back(std::floor(problem_.GreatestCurvature() / unit + 1e-9));
      wanted_.push_back(wanted);
      count_.push_back(std::clamp(std::round(wanted), least_.back(), greatest_.back()));
    }
    if (problem_.IsClosed() && !CloseTotal()) {
      return Status::InvalidInput(fmt::format(
          "cones at {} vertices with angles in multiples of pi/{} cannot add up as Gauss-Bonnet "
          "asks: use more cones, or free angles",
          cones_.size(), parts_));
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
    return std::abs(count_[i] + step - wanted_[i]) - std::abs(count_[i] - wanted_[i]);
  }

  const ConeProblem& problem_;
  std::vector<Cone>& cones_;
  const int parts_;
  std::vector<double> wanted_, count_, least_, greatest_;
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

std::vector<std::string> ConeAngleWords() { return {"free", "pi/2", "pi/3", "ranges"}; }

StatusOr<ConeAngleOptions> ParseConeAngles(const std::string& text) {
  StatusOr<NameWithOptions> parsed = ParseNameWithOptions(text);
  if (!parsed.ok()) return parsed.status();
  if (parsed->name != "ranges" && parsed->options.contains("width")) {
    return Status::InvalidInput("cone_angles: a width belongs to ranges, not to " + parsed->name);
  }
  parsed->options["angles"] = parsed->name;
  ConeAngleOptions options;
  if (Status s = AngleOptionTable().Set(parsed->options, &options); !s.ok()) return s;
  return options;
}

StatusOr<std::vector<Cone>> ApplyConeAngles(const ConeProblem& problem, std::vector<Cone> cones,
                                            const ConeAngleOptions& options) {
  const auto open_end = std::stable_partition(cones.begin(), cones.end(), [&](const Cone& c) {
    return c.lower == c.upper && problem.IsCandidate(c.vertex);
  });
  const std::vector<Cone> kept(open_end, cones.end());
  cones.erase(open_end, cones.end());
  if (options.angles == "ranges") Widen(problem, options.width, &cones);
  if (options.angles.starts_with("pi/")) {
    const int parts = options.angles.back() - '0';
    if (Status s = Rounding(problem, &cones, parts).Run(); !s.ok()) return s;
  }
  cones.insert(cones.end(), kept.begin(), kept.end());
  return cones;
}

}  // namespace cirque
