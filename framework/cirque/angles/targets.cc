#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "cirque/angles/infeasibility.h"
#include "cirque/core/text.h"
#include "cirque/energy/angle_constraints.h"
#include "cirque/math/compensated_sum.h"

namespace cirque {
namespace {

constexpr double kRounding = 1e-9;  ///< [rad]: sums of given targets are not exact

std::string Times(double angle) { return fmt::format("{:.6g} pi", angle / kPi); }

Status CheckNumbers(const Triangulation& t, const ConeTargets& targets) {
  const auto count = static_cast<std::size_t>(t.num_vertices);
  if (targets.lower.size() != count || targets.upper.size() != count) {
    return Status::InvalidInput(fmt::format("{} lower and {} upper angle sums for {} vertices",
                                            targets.lower.size(), targets.upper.size(), count));
  }
  for (std::size_t v = 0; v < count; ++v) {
    const double lower = targets.lower[v], upper = targets.upper[v];
    const char* fault = !std::isfinite(lower) || !std::isfinite(upper) ? "is not finite"
                        : lower < 0 || upper < 0                       ? "is negative"
                        : lower > upper                                ? "is empty"
                                                                       : nullptr;
    if (!fault) continue;
    return Status::InvalidInput(
        fmt::format("the target [{}, {}] rad of vertex {} (0-based) {}; give 0 <= lower <= upper",
                    lower, upper, v, fault));
  }
  return Status();
}

/// Why the corners of these vertices cannot add up to their targets.
std::string CornerMessage(const ConeTargets& targets, const std::vector<Index>& corners,
                          const std::vector<bool>& boundary, const std::vector<int>& bad) {
  const int v = bad.front();
  if (targets.upper[v] == 0) {
    return fmt::format("the angle sums of vertices {} (0-based) must be 0, but angles are positive",
                       IdList(bad));
  }
  return fmt::format(
      "the angle sums of vertices {} (0-based) cannot be reached: {} vertex {} (0-based) has {} "
      "corners, "
      "each less than pi, and must reach {}; lower its target, or give it more triangles",
      IdList(bad), boundary[v] ? "boundary" : "inner", v, corners[v], Times(targets.lower[v]));
}

/// y_v = 1 at a vertex that is to be too large for its corners, if these matter, -1 at one that is
/// to be 0.
Status CheckCorners(const IntrinsicSurface& surface, const ConeTargets& targets, bool of_corners,
                    Eigen::VectorXd* vertex_y) {
  const std::vector<Index>& corners = surface.corners;
  std::vector<int> bad;
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    const bool too_large = of_corners && targets.lower[v] >= kPi * corners[v];
    if (!too_large && targets.upper[v] > 0) continue;
    if (bad.empty()) (*vertex_y)[v] = too_large ? 1 : -1;
    bad.push_back(v);
  }
  if (bad.empty()) return Status();
  return Status(StatusCode::kInfeasible, CornerMessage(targets, corners, surface.boundary, bad));
}

double Sum(const std::vector<double>& values) {
  CompensatedSum sum;
  for (const double value : values) sum += value;
  return sum.Value();
}

std::vector<int> CurvedVertices(const IntrinsicSurface& surface, const ConeTargets& targets) {
  std::vector<int> curved;
  for (Index v = 0; v < surface.triangulation.num_vertices; ++v) {
    const double flat = surface.boundary[v] ? kPi : 2 * kPi;
    if (targets.lower[v] != flat || targets.upper[v] != flat) curved.push_back(v);
  }
  return curved;
}

/// The angle sums of all vertices add up to those of all triangles. `sign`: +1 when the vertices
/// ask for too much, -1 for too little.
Status CheckGaussBonnet(const IntrinsicSurface& surface, const ConeTargets& targets, double* sign) {
  const Triangulation& t = surface.triangulation;
  if (!AngleConstraints(t, targets).HasGauge()) return Status();
  const double lower = Sum(targets.lower), upper = Sum(targets.upper), all = kPi * t.num_faces();
  const bool too_much = lower > all + kRounding, too_little = upper < all - kRounding;
  if (!too_much && !too_little) return Status();
  *sign = too_much ? 1 : -1;
  const std::vector<int> curved = CurvedVertices(surface, targets);
  return Status(
      StatusCode::kInfeasible,
      fmt::format(
          "Gauss-Bonnet: the vertices' angle sums add up to {} {}, the triangles' to {} pi; "
          "{} {} in all; {}",
          too_much ? "at least" : "at most", Times(too_much ? lower : upper), t.num_faces(),
          too_much ? "take away" : "add", Times(std::abs((too_much ? lower : upper) - all)),
          curved.empty() ? std::string("all vertices are to be flat: cones are needed")
                         : "not flat are the vertices " + IdList(curved) + " (0-based)"));
}

/// Multipliers by vertex (and one for all faces) in the rows of the constraints.
InfeasibilityCertificate Certify(const Triangulation& t, const ConeTargets& targets,
                                 double of_faces, const Eigen::VectorXd& of_vertices) {
  const AngleConstraints constraints(t, targets);
  Eigen::VectorXd y = Eigen::VectorXd::Constant(constraints.num_rows(), of_faces);
  for (std::size_t i = 0; i < constraints.constrained_vertices().size(); ++i) {
    y[t.num_faces() + static_cast<int>(i)] = of_vertices[constraints.constrained_vertices()[i]];
  }
  return InfeasibilityCertificateFrom(constraints, y);
}

}  // namespace

namespace {

Status CheckSums(const IntrinsicSurface& surface, const ConeTargets& targets, bool of_corners,
                 InfeasibilityCertificate* certificate) {
  const Triangulation& t = surface.triangulation;
  if (Status s = CheckNumbers(t, targets); !s.ok()) return s;
  Eigen::VectorXd of_vertices = Eigen::VectorXd::Zero(t.num_vertices);
  double of_faces = 0;
  Status status = CheckCorners(surface, targets, of_corners, &of_vertices);
  if (status.ok()) {
    double sign = 0;
    status = CheckGaussBonnet(surface, targets, &sign);
    of_vertices.setConstant(sign);
    of_faces = -sign;
  }
  if (!status.ok() && certificate) *certificate = Certify(t, targets, of_faces, of_vertices);
  return status;
}

}  // namespace

Status CheckTargets(const IntrinsicSurface& surface, const ConeTargets& targets,
                    InfeasibilityCertificate* certificate) {
  return CheckSums(surface, targets, true, certificate);
}

Status CheckAngleSums(const IntrinsicSurface& surface, const ConeTargets& targets,
                      InfeasibilityCertificate* certificate) {
  return CheckSums(surface, targets, false, certificate);
}

}  // namespace cirque
