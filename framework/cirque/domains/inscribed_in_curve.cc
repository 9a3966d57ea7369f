#include "cirque/domains/inscribed_in_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cirque/core/types.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;

constexpr double kCorner = kPi / 6;  ///< the least turning of a curve's corner [rad]
constexpr int kMostStarts = 256;
constexpr int kSamples = 1024;         ///< of a turning function
constexpr double kHandedOn = 1e-14;    ///< [rad] of what a corner lacks, that is none
constexpr int kMostHandedOn = 100000;  ///< times

/// A turning function: how far a curve has turned at shares of its length.
class TurningFunction {
 public:
  /// `arc`: increasing from 0, one more than `turning`: the length.
  TurningFunction(std::vector<double> arc, std::vector<double> turning)
      : arc_(std::move(arc)), turning_(std::move(turning)) {}

  /// At the middles of equal parts from corner `first` on.
  std::vector<double> SampledFrom(std::size_t first) const {
    const std::size_t n = turning_.size();
    const double length = arc_.back();
    std::vector<double> samples;
    double turned = 0;
    std::size_t passed = 0;  // corners beyond the first
    for (int i = 0; i < kSamples; ++i) {
      const double at = (i + 0.5) / kSamples * length;
      for (; passed + 1 < n && ArcFrom(first, passed + 1) <= at; ++passed) {
        turned += turning_[(first + passed + 1) % n];
      }
      samples.push_back(turned);
    }
    return samples;
  }

 private:
  double ArcFrom(std::size_t first, std::size_t count) const {
    const std::size_t n = turning_.size(), k = first + count;
    return k < n ? arc_[k] - arc_[first] : arc_.back() - arc_[first] + arc_[k - n];
  }

  std::vector<double> arc_, turning_;
};

/// Variance of their difference.
double DistanceButForRotation(const std::vector<double>& a, const std::vector<double>& b) {
  double mean = 0, squares = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean += (a[i] - b[i]) / static_cast<double>(a.size());
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    squares += (a[i] - b[i] - mean) * (a[i] - b[i] - mean);
  }
  return squares;
}

VectorXd LogShares(const VectorXd& lengths) { return (lengths.array() / lengths.sum()).log(); }

}  // namespace

std::vector<double> InscribedPolygons::Arcs(const VectorXd& shape) const {
  const VectorXd part = (shape.array() - shape.maxCoeff()).exp();
  const double scale = curve_.length() / part.sum();
  std::vector<double> arcs;
  double arc = 0;
  for (Eigen::Index k = 0; k < shape.size(); ++k) {
    arcs.push_back(arc * scale);
    arc += part[k];
  }
  return arcs;
}

std::vector<Vector2d> InscribedPolygons::Corners(const std::vector<double>& arcs) const {
  std::vector<Vector2d> corners;
  for (const double arc : arcs) corners.push_back(curve_.At(arc));
  return corners;
}

VectorXd InscribedPolygons::Angles(const VectorXd& shape, const VectorXd& lower,
                                   const VectorXd& upper) const {
  const Eigen::Index n = shape.size();
  const std::vector<Vector2d> corner = Corners(Arcs(shape));
  const auto at = [&](Eigen::Index k) { return corner[static_cast<std::size_t>((k + n) % n)]; };
  VectorXd angle(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    angle[k] = kPi - AngleBetween(at(k) - at(k - 1), at(k + 1) - at(k));
  }
  // Nothing, unless the polygon is so coarse that it is not simple.
  angle.array() += (kPi * static_cast<double>(n - 2) - angle.sum()) / static_cast<double>(n);
  for (int times = 0; times < kMostHandedOn; ++times) {
    const VectorXd kept = angle.cwiseMax(lower).cwiseMin(upper);
    const VectorXd excess = angle - kept;
    if (excess.cwiseAbs().maxCoeff() <= kHandedOn) break;
    angle = kept;
    for (Eigen::Index k = 0; k < n; ++k) {
      angle[(k + n - 1) % n] += excess[k] / 2;
      angle[(k + 1) % n] += excess[k] / 2;
    }
  }
  return angle;
}

VectorXd InscribedPolygons::Missing(const VectorXd& shape, const VectorXd& lengths) const {
  const std::vector<Vector2d> corner = Corners(Arcs(shape));
  VectorXd sides(shape.size());
  for (std::size_t k = 0; k < corner.size(); ++k) {
    const double side = (corner[(k + 1) % corner.size()] - corner[k]).norm();
    sides[static_cast<Eigen::Index>(k)] = std::max(side, std::numeric_limits<double>::min());
  }
  return LogShares(lengths) - LogShares(sides);
}

std::vector<bool> InscribedPolygons::MeetCorners(std::vector<double>* arcs) const {
  const std::size_t n = arcs->size();
  std::vector<bool> met(n, false);
  met[0] = std::abs(curve_.TurningAt(0)) >= kCorner;
  for (std::size_t point = 1; point < curve_.points().size(); ++point) {
    if (std::abs(curve_.TurningAt(point)) < kCorner) continue;
    const double arc = curve_.arcs()[point];
    const auto above = std::upper_bound(arcs->begin(), arcs->end(), arc);
    const auto after = static_cast<std::size_t>(above - arcs->begin());
    const double next = after < n ? (*arcs)[after] : curve_.length();
    const std::size_t nearest = next - arc < arc - (*arcs)[after - 1] ? after % n : after - 1;
    if (nearest == 0 || met[nearest]) continue;
    met[nearest] = true, (*arcs)[nearest] = arc;
  }
  return met;
}

int NearestStart(const ClosedCurve& curve, const VectorXd& lengths, const VectorXd& angles) {
  const auto n = static_cast<std::size_t>(lengths.size());
  std::vector<double> arc = {0}, turning, turning_of_curve;
  for (std::size_t k = 0; k < n; ++k) {
    arc.push_back(arc.back() + lengths[static_cast<Eigen::Index>(k)]);
    turning.push_back(kPi - angles[static_cast<Eigen::Index>(k)]);
  }
  for (std::size_t k = 0; k < curve.points().size(); ++k) {
    turning_of_curve.push_back(curve.TurningAt(k));
  }
  const auto wanted = TurningFunction(curve.arcs(), turning_of_curve).SampledFrom(0);
  const TurningFunction polygon(std::move(arc), std::move(turning));
  const std::size_t step = (n + kMostStarts - 1) / kMostStarts;
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < n; k += step) {
    const double distance = DistanceButForRotation(polygon.SampledFrom(k), wanted);
    if (distance < least) least = distance, best = k;
  }
  return static_cast<int>(best);
}

}  // namespace cirque
