#include "cirque/verify/infeasibility_check.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>
#include <fmt/format.h>

#include "cirque/verify/topology.h"

namespace cirque::verify {
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

void CheckIntervals(const InfeasibilityCertificate& certificate, InfeasibilityReport* report) {
  for (std::size_t i = 0; i < certificate.constrained_vertex.size(); ++i) {
    if (certificate.lower_over_pi[i] <= certificate.upper_over_pi[i]) continue;
    return report->errors.push_back(fmt::format(
        "the interval of vertex {} is empty: [{}, {}] pi", certificate.constrained_vertex[i],
        certificate.lower_over_pi[i], certificate.upper_over_pi[i]));
  }
}

void CheckForm(const InfeasibilityCertificate& certificate, const TriangleMesh& mesh,
               Index num_faces, InfeasibilityReport* report) {
  const double epsilon = certificate.epsilon_over_pi;
  Expect(epsilon >= 0 && epsilon < 1.0 / 3,
         fmt::format("epsilon_over_pi = {} is not in [0, 1/3): no triangle has such angles anyway",
                     epsilon),
         report);
  const std::size_t num_constrained = certificate.constrained_vertex.size();
  CheckNumbers("face_multiplier", certificate.face_multiplier,
               static_cast<std::size_t>(mesh.num_triangles()), report);
  CheckNumbers("vertex_multiplier", certificate.vertex_multiplier, num_constrained, report);
  CheckNumbers("lower_over_pi", certificate.lower_over_pi, num_constrained, report);
  CheckNumbers("upper_over_pi", certificate.upper_over_pi, num_constrained, report);
  CheckIds("constrained_vertex", certificate.constrained_vertex, mesh.num_vertices, true, report);
  CheckIds("carrying_faces", certificate.carrying_faces,
           certificate.triangle_face.empty() ? mesh.num_triangles() : num_faces, false, report);
  CheckIds("carrying_vertices", certificate.carrying_vertices, mesh.num_vertices, false, report);
  if (report->accepted()) CheckIntervals(certificate, report);
}

/// The triangles that a certificate names, as the parts of one face.
class NamedParts {
 public:
  NamedParts(const InfeasibilityCertificate& certificate, const PolygonSoup& in)
      : certificate_(certificate), in_(in) {}

  /// Adds those from `begin` to `end`, all of a face. False: they do not fill it.
  bool Add(std::size_t begin, std::size_t end, TriangleMesh* mesh) const {
    const Index f = certificate_.triangle_face[begin];
    const Index first = in_.first_corner[f], n = in_.first_corner[f + 1] - first;
    std::vector<FaceCorner> corners;
    for (Index k = 0; k < n; ++k) corners.push_back({in_.corner[first + k], first + k, k});
    const auto corner = certificate_.triangle_corner.begin();
    const std::vector<int> parts(corner + static_cast<std::ptrdiff_t>(3 * begin),
                                 corner + static_cast<std::ptrdiff_t>(3 * end));
    if (!Fill(n, parts)) return false;
    AddTriangles(f, n, corners, parts, mesh);
    return true;
  }

 private:
  /// Whether n - 2 triangles have the border of the polygon, in whichever direction, and every
  /// diagonal twice.
  static bool Fill(Index n, const std::vector<int>& parts) {
    if (static_cast<Index>(parts.size()) != 3 * (n - 2)) return false;
    std::set<std::pair<int, int>> open;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const int a = parts[i], b = parts[i % 3 == 2 ? i - 2 : i + 1];
      if (a < 0 || a >= n || a == b) return false;
      if (open.erase({b, a}) == 0 && !open.insert({a, b}).second) return false;
    }
    if (static_cast<Index>(open.size()) != n) return false;
    const bool forwards = open.contains({0, 1 % n});
    for (int k = 0; k < n; ++k) {
      const int next = (k + 1) % n;
      if (!open.contains(forwards ? std::pair(k, next) : std::pair(next, k))) return false;
    }
    return true;
  }

  const InfeasibilityCertificate& certificate_;
  const PolygonSoup& in_;
};

/// The faces of IN, or some of them, in the triangles that the certificate names.
StatusOr<TriangleMesh> NamedTriangles(const InfeasibilityCertificate& certificate,
                                      const PolygonSoup& in, InfeasibilityReport* report) {
  if (const Status faces = CheckFaces(in); !faces.ok()) return faces;
  TriangleMesh mesh;
  mesh.num_vertices = static_cast<Index>(in.position.size());
  const std::vector<Index>& face = certificate.triangle_face;
  if (certificate.triangle_corner.size() != 3 * face.size()) {
    report->errors.push_back(fmt::format("triangle_corner has {} entries instead of {}",
                                         certificate.triangle_corner.size(), 3 * face.size()));
    return mesh;
  }
  CheckIds("triangle_face", face, in.num_polygons(), false, report);
  const NamedParts parts(certificate, in);
  std::vector<bool> named(in.num_polygons(), false);
  for (std::size_t begin = 0, end = 0; report->accepted() && begin < face.size(); begin = end) {
    while (end < face.size() && face[end] == face[begin]) ++end;
    if (named[face[begin]] || !parts.Add(begin, end, &mesh)) {
      report->errors.push_back(
          fmt::format("the triangles named of face {} do not fill it, or not one after the other",
                      face[begin]));
      break;
    }
    named[face[begin]] = true;
  }
  report->num_faces_left_out = static_cast<Index>(std::count(named.begin(), named.end(), false));
  report->names_triangles = true;
  return mesh;
}

/// Per vertex how many corners it has and whether it is on the boundary.
struct VertexPlaces {
  explicit VertexPlaces(const Surface& surface)
      : corners(surface.mesh.num_vertices, 0), on_boundary(surface.mesh.num_vertices, false) {
    const TriangleMesh& mesh = surface.mesh;
    for (Index h = 0; h < static_cast<Index>(mesh.vertex.size()); ++h) {
      ++corners[mesh.Tail(h)];
      if (surface.twin[h] == kNone) on_boundary[mesh.Tail(h)] = on_boundary[mesh.Tip(h)] = true;
    }
  }

  std::vector<Index> corners;
  std::vector<bool> on_boundary;
};

/// Sorts the constrained vertices by what is asked of them.
void NameConstraints(const InfeasibilityCertificate& certificate, const Surface& surface,
                     InfeasibilityReport* report) {
  const VertexPlaces places(surface);
  for (std::size_t i = 0; i < certificate.constrained_vertex.size(); ++i) {
    const Index v = certificate.constrained_vertex[i];
    const double lower = certificate.lower_over_pi[i], upper = certificate.upper_over_pi[i];
    if (places.corners[v] == 0) {
      report->errors.push_back(fmt::format("constrained vertex {} belongs to no triangle", v));
    } else if (places.on_boundary[v]) {
      if (lower > 0 || upper < places.corners[v]) report->prescribed.push_back(v);
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
Sides SumSides(const InfeasibilityCertificate& certificate, const Surface& surface) {
  const TriangleMesh& mesh = surface.mesh;
  std::vector<double> of_vertex(mesh.num_vertices, 0.0);
  Sides sides;
  for (std::size_t i = 0; i < certificate.constrained_vertex.size(); ++i) {
    const double y = certificate.vertex_multiplier[i];
    of_vertex[certificate.constrained_vertex[i]] = y;
    sides.left +=
        ToFixed(y) * ToFixed(y > 0 ? certificate.lower_over_pi[i] : certificate.upper_over_pi[i]);
  }
  for (const double y : certificate.face_multiplier) sides.left += ToFixed(y) << kFractionBits;
  const auto opposite = [&](Index h) {
    return Fixed(ToFixed(certificate.face_multiplier[h / 3]) +
                 ToFixed(of_vertex[mesh.vertex[TriangleMesh::Prev(h)]]));
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
  const Fixed one = Fixed(1) << kFractionBits, epsilon = ToFixed(certificate.epsilon_over_pi);
  sides.right =
      epsilon * sum + (one - 3 * epsilon) * inner_maxima + (one - 2 * epsilon) * boundary_maxima;
  return sides;
}

bool Holds(const InfeasibilityCertificate& certificate, const Sides& sides) {
  const bool open = certificate.epsilon_over_pi == 0 && sides.some_nonzero;
  return sides.left > sides.right || (open && sides.left == sides.right);
}

void CheckInequality(const InfeasibilityCertificate& certificate, const Surface& surface,
                     InfeasibilityReport* report) {
  const Sides sides = SumSides(certificate, surface);
  report->evaluated = true;
  const Fixed margin = sides.left - sides.right;
  report->left = Rounded(sides.left);
  report->right = Rounded(sides.right);
  report->margin = Rounded(margin);
  if (Holds(certificate, sides)) return;
  report->errors.push_back(
      fmt::format("the inequality fails: left side - right side = {:.6g}, which should be positive",
                  report->margin));
}

/// Puts the targets asked about in the place of the certificate's.
void CompareWithAsked(InfeasibilityCertificate certificate, const Surface& surface,
                      const AngleTargets& asked, InfeasibilityReport* report) {
  const VertexPlaces places(surface);
  report->targets_given = !asked.at.empty();
  for (std::size_t i = 0; i < certificate.constrained_vertex.size(); ++i) {
    const Index v = certificate.constrained_vertex[i];
    double &lower = certificate.lower_over_pi[i], &upper = certificate.upper_over_pi[i];
    if (places.on_boundary[v] && certificate.removed_vertex != kNone) continue;
    const AngleInterval wanted =
        asked.At(v, !places.on_boundary[v])
            .value_or(AngleInterval{0, static_cast<double>(places.corners[v])});
    if (!(lower <= wanted.lower_over_pi && wanted.upper_over_pi <= upper)) {
      report->own_targets.push_back(v);
      report->own_intervals.push_back({lower, upper});
    }
    lower = wanted.lower_over_pi;
    upper = wanted.upper_over_pi;
  }
  report->proves_asked = Holds(certificate, SumSides(certificate, surface));
}

}  // namespace

StatusOr<InfeasibilityReport> CheckInfeasibility(const InfeasibilityCertificate& given,
                                                 const PolygonSoup& in, const AngleTargets& asked) {
  InfeasibilityReport report;
  StatusOr<TriangleMesh> mesh =
      given.triangle_face.empty() ? FanTriangulate(in) : NamedTriangles(given, in, &report);
  if (!mesh.ok()) return mesh.status().In("IN");
  if (!report.accepted()) return report;
  StatusOr<Surface> surface = BuildSurface(*std::move(mesh));
  if (!surface.ok()) return surface.status().In("IN");
  report.num_triangles = surface->mesh.num_triangles();
  report.epsilon_over_pi = given.epsilon_over_pi;
  report.removed_vertex = given.removed_vertex;
  InfeasibilityCertificate certificate = given;
  CheckForm(certificate, surface->mesh, in.num_polygons(), &report);
  if (report.accepted() && certificate.removed_vertex != kNone) {
    RemoveVertex(&*surface, &certificate, &report);
  }
  if (report.accepted()) NameConstraints(certificate, *surface, &report);
  if (report.accepted()) CheckInequality(certificate, *surface, &report);
  if (report.accepted()) CompareWithAsked(certificate, *surface, asked, &report);
  return report;
}

}  // namespace cirque::verify
