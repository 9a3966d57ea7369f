#include "cirque/domains/sphere_normalization.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/layout/moebius_normalization.h"

namespace cirque {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// A first run from the balanced chart, others to remove the rounding of its product of boosts.
constexpr int kMaxRounds = 5;
constexpr double kCentred = 1e-14;    ///< further rounds would not help
constexpr double kTolerance = 1e-12;  ///< of the centre of mass
constexpr int kMaxImageSteps = 50;

struct Problem {
  const Surface& surface;
  const PlaneWithPole& plane;
};

Vector3d CentreOfMass(const std::vector<Vector3d>& points, const std::vector<double>& weights) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) sum += weights[i] * points[i];
  return sum;
}

SphereChart Apply(const SphereChart& chart, const std::vector<LorentzBoost>& boosts) {
  std::vector<Vector3d> centres;
  for (const LorentzBoost& boost : boosts) centres.push_back(boost.centre());
  return chart.Recentred(CentreOfBoosts(centres));
}

Status CheckCentred(const NormalizedChart& result) {
  if (result.residual <= kTolerance) return Status();
  return Status(StatusCode::kNotConverged,
                fmt::format("the centre of mass stays {:.1e} off the centre; another normalization "
                            "may do",
                            result.residual));
}

/// Moves the chart until the weighted centre of mass is 0, as far as rounding lets it.
Status Centre(const Problem& problem, NormalizedChart* result) {
  SolverLimits limits;
  limits.gradient_tolerance = kCentred;
  for (int round = 0; round < kMaxRounds; ++round) {
    const std::vector<Vector3d> points = LiftAll(problem.plane, result->chart);
    result->residual = CentreOfMass(points, result->weights).norm();
    if (result->residual <= kCentred) break;
    const LorentzNormalization step = MinimizeLorentz(points, result->weights, limits);
    if (step.summary.termination == Termination::kInvalidStart) {
      return Status::InvalidInput(step.summary.message);
    }
    result->iterations += step.summary.num_iterations();
    const SphereChart moved = Apply(result->chart, step.boosts);
    const Vector3d mass = CentreOfMass(LiftAll(problem.plane, moved), result->weights);
    if (!(mass.norm() < result->residual)) break;
    result->chart = moved;
    result->residual = mass.norm();
  }
  return CheckCentred(*result);
}

/// The centre of mass of the vertices on the sphere, weighted by their areas there.
Vector3d ImageCentre(const Problem& problem, const SphereChart& chart) {
  const std::vector<Vector3d> points = LiftAll(problem.plane, chart);
  return CentreOfMass(points, VertexAreas(problem.surface.triangulation, points));
}

/// How the centre of mass changes with the point of the ball that is carried to the centre.
Matrix3d ImageCentreSlope(const Problem& problem, const SphereChart& chart) {
  constexpr double kDifference = 1e-4;
  Matrix3d slope;
  for (int k = 0; k < 3; ++k) {
    const Vector3d y = kDifference * Vector3d::Unit(k);
    slope.col(k) =
        (ImageCentre(problem, chart.Recentred(y)) - ImageCentre(problem, chart.Recentred(-y))) /
        (2 * kDifference);
  }
  return slope;
}

/// The areas cover the sphere whatever the chart, so that their centre of mass is near 0 anyway and
/// moves little: taking the weights as constant would need thousands of rounds. Newton's method for
/// the three equations, with differences.
Status CentreByImageArea(const Problem& problem, NormalizedChart* result) {
  constexpr double kLongest = 0.5, kShortest = 1e-6, kDecrease = 0.1;
  Vector3d mass = ImageCentre(problem, result->chart);
  bool smaller = true;
  while (smaller && mass.norm() > kCentred && result->iterations < kMaxImageSteps) {
    Vector3d step = -ImageCentreSlope(problem, result->chart).fullPivLu().solve(mass);
    step *= std::min(1.0, kLongest / step.norm());
    smaller = false;
    for (double length = 1; !smaller && length > kShortest; length /= 2) {
      const SphereChart moved = result->chart.Recentred(length * step);
      const Vector3d next = ImageCentre(problem, moved);
      smaller = next.norm() < (1 - kDecrease * length) * mass.norm();
      if (!smaller) continue;
      result->chart = moved;
      mass = next;
    }
    ++result->iterations;
  }
  result->weights =
      VertexAreas(problem.surface.triangulation, LiftAll(problem.plane, result->chart));
  result->residual = mass.norm();
  return CheckCentred(*result);
}

/// The surface's edges, in the unit that gives it the area of the sphere, each weighted by the area
/// of its two triangles.
ScaledEdges EdgesOf(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  EdgeLengths lengths = MeasureEdgeLengths(surface);
  ScaledEdges edges;
  edges.weight.assign(t.num_edges(), 0);
  for (Index e = 0; e < t.num_edges(); ++e) {
    edges.ends.emplace_back(t.Tail(t.edge_halfedge[e]), t.Tip(t.edge_halfedge[e]));
  }
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Vector3d &a = surface.position[t.vertex[h]], &b = surface.position[t.Tail(h)],
                   &c = surface.position[t.Tip(h)];
    edges.weight[t.edge[h]] += (b - a).cross(c - a).norm();
  }
  // The sum has twice the area of every triangle, three times.
  const double area = std::accumulate(edges.weight.begin(), edges.weight.end(), 0.0) / 6;
  lengths.value *= std::sqrt(4 * kPi / area);
  edges.length.assign(lengths.value.begin(), lengths.value.end());
  return edges;
}

Status MinimizeAreaDistortion(const Problem& problem, NormalizedChart* result) {
  constexpr double kFlat = 1e-9;
  SolverLimits limits;
  limits.gradient_tolerance = 1e-11;
  const ScaledEdges edges = EdgesOf(problem.surface);
  for (int round = 0; round < 2; ++round) {
    const LogScaleNormalization step =
        MinimizeLogScale(LiftAll(problem.plane, result->chart), edges, limits);
    result->iterations += step.iterations;
    result->residual = step.gradient;
    result->chart = Apply(result->chart, step.boosts);
  }
  if (result->residual <= kFlat) return Status();
  return Status(StatusCode::kNotConverged,
                fmt::format("the area distortion has a slope of {:.1e} left", result->residual));
}

using Normalize = std::function<Status(const Problem&, NormalizedChart*)>;

const std::vector<std::pair<std::string, Normalize>>& Table() {
  static const std::vector<std::pair<std::string, Normalize>> kTable = {
      {"none", [](const Problem&, NormalizedChart*) { return Status(); }},
      {"uniform",
       [](const Problem& problem, NormalizedChart* result) {
         result->weights.assign(result->weights.size(), 1.0 / result->weights.size());
         return Centre(problem, result);
       }},
      {"surface_area", Centre},
      {"image_area", CentreByImageArea},
      {"least_area_distortion", MinimizeAreaDistortion}};
  return kTable;
}

}  // namespace

const std::vector<std::string>& SphereNormalizations() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const auto& [name, normalize] : Table()) names.push_back(name);
    return names;
  }();
  return kNames;
}

std::vector<Vector3d> LiftAll(const PlaneWithPole& plane, const SphereChart& chart) {
  std::vector<Vector3d> points;
  points.reserve(plane.position.size());
  for (const Eigen::Vector2d& z : plane.position) points.push_back(chart.Lift(z));
  points[plane.pole] = SphereChart::Infinity();
  return points;
}

std::vector<double> VertexAreas(const Triangulation& t, const std::vector<Vector3d>& position) {
  std::vector<double> area(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const Vector3d& a = position[t.vertex[h]];
    const Vector3d u = position[t.vertex[h + 1]] - a, v = position[t.vertex[h + 2]] - a;
    for (Index c = h; c < h + 3; ++c) area[t.vertex[c]] += u.cross(v).norm();
  }
  const double total = std::accumulate(area.begin(), area.end(), 0.0);
  // A vertex of needles alone still counts as one.
  for (double& a : area) a = std::max(a / total, std::numeric_limits<double>::min());
  return area;
}

StatusOr<NormalizedChart> NormalizeChart(const Surface& surface, const PlaneWithPole& plane,
                                         const std::string& normalization) {
  NormalizedChart result;
  result.weights = VertexAreas(surface.triangulation, surface.position);
  std::vector<double> weights = result.weights;
  weights[plane.pole] = 0;
  result.chart = BalancedChart(plane.position, weights);
  for (const auto& [name, normalize] : Table()) {
    if (name != normalization) continue;
    if (Status s = normalize({surface, plane}, &result); !s.ok()) return s;
    return result;
  }
  return Status::InvalidInput(UnknownName("normalization", normalization, SphereNormalizations()));
}

Matrix3d PrincipalAxes(const std::vector<Vector3d>& points, const std::vector<double>& weights) {
  Matrix3d moments = Matrix3d::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    moments += weights[i] * points[i] * points[i].transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(moments);  // increasing
  Matrix3d axes;
  for (const int row : {0, 1}) {
    Vector3d axis = solver.eigenvectors().col(2 - row);
    double skewness = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      skewness += weights[i] * std::pow(points[i].dot(axis), 3);
    }
    axes.row(row) = skewness < 0 ? -axis : axis;
  }
  axes.row(2) = axes.row(0).cross(axes.row(1));
  return axes;
}

std::vector<Vector3d> LiftAll(const Surface& surface, const PlaneWithPole& plane,
                              const SphereChart& chart, bool principal_axes) {
  std::vector<Vector3d> points = LiftAll(plane, chart);
  if (!principal_axes) return points;
  const Matrix3d axes = PrincipalAxes(points, VertexAreas(surface.triangulation, surface.position));
  for (Vector3d& x : points) x = (axes * x).normalized();
  return points;
}

}  // namespace cirque
