#include "experiments/verify_map/infeasibility_check.h"

#include <algorithm>
#include <cmath>

#include <boost/multiprecision/cpp_int.hpp>
#include <fmt/format.h>

#include "experiments/verify_map/removed_vertex.h"
#include "experiments/verify_map/topology.h"

namespace cirque::verify_map {
namespace {

using boost::multiprecision::cpp_rational;

/// Integers count multiples of 2^-1074, the smallest double: every finite double is one, and sums
/// of them stay exact without the common divisors a rational would look for at every addition.
using Fixed = boost::multiprecision::cpp_int;
constexpr int kFractionBits = 1074;

Fixed ToFixed(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);  // x = fraction * 2^exponent
  Fixed mantissa = static_cast<long long>(std::ldexp(fraction, 53));
  const int shift = exponent - 53 + kFractionBits;
  if (shift >= 0) return mantissa << shift;
  // A subnormal: its last bits are zero, so that the division is exact.
  return mantissa / (Fixed(1) << -shift);
}

double Rounded(const Fixed& twice_scaled) {
  return cpp_rational(twice_scaled, Fixed(1) << (2 * kFractionBits)).convert_to<double>();
}

void Expect(bool condition, const std::string& message, InfeasibilityReport* report) {
  if (!condition) report->errors.push_back(message);
}

void CheckNumbers(const std::string& key, const std::vector<double>& values, std::size_t size,
                  InfeasibilityReport* report) {
  Expect(values.size() == size,
         fmt::format("{} has {} entries instead of {}", key, values.size(), size), report);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    return report->errors.push_back(fmt::format("{}[{}] is not finite", key, i));
  }
}

void CheckIds(const std::string& key, const std::vector<Index>& ids, Index end, bool increasing,
              InfeasibilityReport* report) {
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] < 0 || ids[i] >= end) {
      return report->errors.push_back(
          fmt::format("{}[{}] = {} does not exist; there are {}", key, i, ids[i], end));
    }
    if (increasing && i > 0 && ids[i] <= ids[i - 1]) {
      return report->errors.push_back(fmt::format("{}[{}] = {} does not increase", key, i, ids[i]));
    }
  }
}

void CheckIntervals(const InfeasibilityCertificate& proof, InfeasibilityReport* report) {
  for (std::size_t i = 0; i < proof.constrained_vertex.size(); ++i) {
    if (proof.lower_over_pi[i] <= proof.upper_over_pi[i]) continue;
    return report->errors.push_back(fmt::format("the interval of vertex {} is empty: [{}, {}] pi",
                                                proof.constrained_vertex[i], proof.lower_over_pi[i],
                                                proof.upper_over_pi[i]));
  }
}

void CheckForm(const InfeasibilityCertificate& proof, const FanMesh& mesh,
               InfeasibilityReport* report) {
  const double epsilon = proof.epsilon_over_pi;
  Expect(epsilon >= 0 && epsilon < 1.0 / 3,
         fmt::format("epsilon_over_pi = {} is not in [0, 1/3): no triangle has such angles anyway",
                     epsilon),
         report);
  const std::size_t num_constrained = proof.constrained_vertex.size();
  CheckNumbers("face_multiplier", proof.face_multiplier,
               static_cast<std::size_t>(mesh.num_triangles()), report);
  CheckNumbers("vertex_multiplier", proof.vertex_multiplier, num_constrained, report);
  CheckNumbers("lower_over_pi", proof.lower_over_pi, num_constrained, report);
  CheckNumbers("upper_over_pi", proof.upper_over_pi, num_constrained, report);
  CheckIds("constrained_vertex", proof.constrained_vertex, mesh.num_vertices, true, report);
  CheckIds("carrying_faces", proof.carrying_faces, mesh.num_triangles(), false, report);
  CheckIds("carrying_vertices", proof.carrying_vertices, mesh.num_vertices, false, report);
  if (report->accepted()) CheckIntervals(proof, report);
}

/// Sorts the constrained vertices by what is asked of them.
void NameConstraints(const InfeasibilityCertificate& proof, const Surface& surface,
                     InfeasibilityReport* report) {
  const FanMesh& mesh = surface.mesh;
  std::vector<Index> corners(mesh.num_vertices, 0);
  std::vector<bool> on_boundary(mesh.num_vertices, false);
  for (Index h = 0; h < static_cast<Index>(mesh.vertex.size()); ++h) {
    ++corners[mesh.Tail(h)];
    if (surface.twin[h] == kNone) on_boundary[mesh.Tail(h)] = on_boundary[mesh.Tip(h)] = true;
  }
  for (std::size_t i = 0; i < proof.constrained_vertex.size(); ++i) {
    const Index v = proof.constrained_vertex[i];
    const double lower = proof.lower_over_pi[i], upper = proof.upper_over_pi[i];
    if (corners[v] == 0) {
      report->errors.push_back(fmt::format("constrained vertex {} belongs to no triangle", v));
    } else if (on_boundary[v]) {
      if (lower > 0 || upper < corners[v]) report->prescribed.push_back(v);
    } else if (lower == 2 && upper == 2) {
      ++report->num_flat;
    } else {
      report->cones.push_back(v);
    }
  }
}

/// The two sides, as multiples of 2^-2148, and whether (A'y)_e is not zero for some e.
struct Sides {
  Fixed left, right;
  bool some_nonzero = false;
};

/// The maximum over Q_e of p a_l + q a_r is taken at a corner: eps (p + q) + (1 - 3 eps) max(0, p,
/// q); over [eps, 1 - eps] that of p a is eps p + (1 - 2 eps) max(0, p). So only sums of
/// multipliers are needed, and epsilon enters once at the end.
Sides SumSides(const InfeasibilityCertificate& proof, const Surface& surface) {
  const FanMesh& mesh = surface.mesh;
  std::vector<double> of_vertex(mesh.num_vertices, 0.0);
  Sides sides;
  for (std::size_t i = 0; i < proof.constrained_vertex.size(); ++i) {
    const double y = proof.vertex_multiplier[i];
    of_vertex[proof.constrained_vertex[i]] = y;
    sides.left += ToFixed(y) * ToFixed(y > 0 ? proof.lower_over_pi[i] : proof.upper_over_pi[i]);
  }
  for (const double y : proof.face_multiplier) sides.left += ToFixed(y) << kFractionBits;
  const auto opposite = [&](Index h) {
    return Fixed(ToFixed(proof.face_multiplier[h / 3]) +
                 ToFixed(of_vertex[mesh.vertex[FanMesh::Prev(h)]]));
  };
  Fixed sum = 0, inner_maxima = 0, boundary_maxima = 0;
  for (Index h = 0; h < static_cast<Index>(mesh.vertex.size()); ++h) {
    const Fixed p = opposite(h);
    sum += p;
    sides.some_nonzero = sides.some_nonzero || p != 0;
    const Index t = surface.twin[h];
    if (t == kNone && p > 0) boundary_maxima += p;
    if (t < h) continue;
    const Fixed larger = std::max(p, opposite(t));
    if (larger > 0) inner_maxima += larger;
  }
  const Fixed one = Fixed(1) << kFractionBits, epsilon = ToFixed(proof.epsilon_over_pi);
  sides.right =
      epsilon * sum + (one - 3 * epsilon) * inner_maxima + (one - 2 * epsilon) * boundary_maxima;
  return sides;
}

void CheckInequality(const InfeasibilityCertificate& proof, const Surface& surface,
                     InfeasibilityReport* report) {
  const Sides sides = SumSides(proof, surface);
  report->evaluated = true;
  const Fixed margin = sides.left - sides.right;
  report->left = Rounded(sides.left);
  report->right = Rounded(sides.right);
  report->margin = Rounded(margin);
  const bool open = proof.epsilon_over_pi == 0 && sides.some_nonzero;
  if (margin > 0 || (open && margin == 0)) return;
  report->errors.push_back(
      fmt::format("the inequality fails: left side - right side = {:.6g}, which should be positive",
                  report->margin));
}

}  // namespace

StatusOr<InfeasibilityReport> CheckInfeasibility(const InfeasibilityCertificate& given,
                                                 const PolygonSoup& in) {
  StatusOr<FanMesh> mesh = FanTriangulate(in);
  if (!mesh.ok()) return mesh.status().In("IN");
  StatusOr<Surface> surface = BuildSurface(*std::move(mesh));
  if (!surface.ok()) return surface.status().In("IN");
  InfeasibilityReport report;
  report.num_triangles = surface->mesh.num_triangles();
  report.epsilon_over_pi = given.epsilon_over_pi;
  report.removed_vertex = given.removed_vertex;
  InfeasibilityCertificate proof = given;
  CheckForm(proof, surface->mesh, &report);
  if (report.accepted() && proof.removed_vertex != kNone) {
    RemoveVertex(&*surface, &proof, &report);
  }
  if (report.accepted()) NameConstraints(proof, *surface, &report);
  if (report.accepted()) CheckInequality(proof, *surface, &report);
  return report;
}

}  // namespace cirque::verify_map
