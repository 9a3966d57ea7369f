#include "cirque/verify/sphere_check.h"

#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>
#include <boost/multiprecision/cpp_int.hpp>
#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/verify/findings.h"
#include "cirque/verify/polygon_check.h"
#include "cirque/verify/report_words.h"
#include "cirque/verify/topology.h"

namespace cirque::verify {
namespace {

using Eigen::Vector3d;
using Rational = boost::multiprecision::cpp_rational;

int ExactSign(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  Rational x[3][3];
  for (int k = 0; k < 3; ++k) {
    x[0][k] = a[k];
    x[1][k] = b[k];
    x[2][k] = c[k];
  }
  const Rational determinant = x[0][0] * (x[1][1] * x[2][2] - x[1][2] * x[2][1]) +
                               x[0][1] * (x[1][2] * x[2][0] - x[1][0] * x[2][2]) +
                               x[0][2] * (x[1][0] * x[2][1] - x[1][1] * x[2][0]);
  return determinant.sign();
}

/// IN must be a closed surface of genus 0.
Status CheckTopology(const Surface& surface) {
  std::vector<bool> used(surface.mesh.num_vertices, false);
  for (const Index v : surface.mesh.vertex) used[v] = true;
  Index vertices = 0, boundary = 0;
  for (const bool is_used : used) vertices += is_used;
  for (const Index twin : surface.twin) boundary += twin == kNone;
  if (boundary > 0) {
    return Status::InvalidInput(
        fmt::format("{}: no closed surface, so no map of it covers the sphere once",
                    Count(boundary, "boundary edge")));
  }
  const Index faces = surface.mesh.num_triangles();
  const Index euler = vertices - 3 * faces / 2 + faces;
  if (euler == 2) return Status();
  return Status::InvalidInput(
      fmt::format("V - E + F = {}, not 2 as for one closed surface of genus 0", euler));
}

/// Matches the faces; false when the rest cannot be judged.
bool Match(const PolygonSoup& in, const PolygonSoup& out, SphereReport* report) {
  if (in.position.size() != out.position.size()) {
    report->errors.push_back(
        fmt::format("IN has {} and OUT {}; OUT must keep IN's vertices in their order",
                    Count(in.position.size(), "vertex"), out.position.size()));
    return false;
  }
  report->match = MatchByNumber(in, out);
  report->errors = MatchErrors(in, out, report->match, 0);
  return report->match.faces.complete();
}

/// Whether all points are on the sphere.
bool JudgePoints(const TriangleMesh& mesh, const std::vector<Vector3d>& sphere, double tolerance,
                 SphereReport* report) {
  std::vector<bool> judged(mesh.num_vertices, false);
  for (const Index v : mesh.vertex) {
    if (judged[v]) continue;
    judged[v] = true;
    const double deviation = std::abs(sphere[v].norm() - 1);
    report->radius_deviation = std::fmax(report->radius_deviation, deviation);
    if (!(deviation <= tolerance)) report->off_sphere.push_back(v);
  }
  if (report->off_sphere.empty()) return true;
  report->errors.push_back(fmt::format("{} not on the unit sphere ({}): by up to {:.3g}",
                                       Count(report->off_sphere.size(), "vertex"),
                                       IdList(report->off_sphere), report->radius_deviation));
  return false;
}

/// The shape of a face as seen from the centre, and triangles that fill it where there are any.
ImageOf ImageOnSphere(const std::vector<Vector3d>& sphere) {
  return [&sphere](const std::vector<FaceCorner>& corners) {
    const auto turn = [&](int i, int j, int k) {
      return DeterminantSign(sphere[corners[i].vertex], sphere[corners[j].vertex],
                             sphere[corners[k].vertex]);
    };
    const auto n = static_cast<int>(corners.size());
    if (n == 3) {
      const int sign = turn(0, 1, 2);
      return std::pair(sign > 0   ? PolygonShape::kSimple
                       : sign < 0 ? PolygonShape::kFlipped
                                  : PolygonShape::kZeroArea,
                       CutFan(3));
    }
    const std::vector<int> ears = CutEars(n, turn);
    if (!ears.empty()) return std::pair(PolygonShape::kSimple, ears);
    const bool flipped = !CutEars(n, [&](int i, int j, int k) { return -turn(i, j, k); }).empty();
    return std::pair(flipped ? PolygonShape::kFlipped : PolygonShape::kFolded, CutFan(n));
  };
}

void JudgeMap(const TriangleMesh& mesh, const std::vector<Index>& twin, const PolygonSoup& in,
              const PolygonSoup& out, const SphereCheckOptions& options, SphereReport* report) {
  report->measured = true;
  const std::vector<std::string> turned = OrientationErrors(report->orientations, report->noun);
  report->errors.insert(report->errors.end(), turned.begin(), turned.end());
  report->degree = CoveringDegree(mesh, out.position);
  if (!(std::abs(report->degree - 1) <= options.degree_tolerance)) {
    report->errors.push_back(
        fmt::format("the triangles cover the sphere {:.9g} times, not once", report->degree));
  }
  report->delaunay_margin = SphericalDelaunayMargin(mesh, twin, out.position);
  report->centre_uniform = CentreUniform(mesh, out.position);
  report->centre_by_area = CentreByArea(mesh, in.position, out.position);
  report->distortion = MeasureOnSphere(mesh, in.position, out.position);
}

}  // namespace

int DeterminantSign(const Vector3d& a, const Vector3d& b, const Vector3d& c) {
  const Vector3d minors = b.cross(c);
  const double magnitude = std::abs(a.x()) * (std::abs(b.y() * c.z()) + std::abs(b.z() * c.y())) +
                           std::abs(a.y()) * (std::abs(b.z() * c.x()) + std::abs(b.x() * c.z())) +
                           std::abs(a.z()) * (std::abs(b.x() * c.y()) + std::abs(b.y() * c.x()));
  const double determinant = a.dot(minors);
  // Four roundings lie on the way of every product, and a sum of six terms has three more levels.
  constexpr double kBound = 8 * std::numeric_limits<double>::epsilon();
  constexpr double kNoUnderflow = 1e-280;
  if (magnitude > kNoUnderflow && std::abs(determinant) > kBound * magnitude) {
    return determinant > 0 ? 1 : -1;
  }
  return ExactSign(a, b, c);
}

std::string SphereReport::Verdict() const {
  return valid() ? "valid (injective)" : "INVALID: " + Join(errors, "; ");
}

StatusOr<SphereReport> VerifySphereMap(const PolygonSoup& in, const PolygonSoup& out,
                                       const SphereCheckOptions& options) {
  for (std::size_t v = 0; v < in.position.size(); ++v) {
    if (in.position[v].allFinite()) continue;
    return Status::InvalidInput(
        fmt::format("IN: vertex {} has a coordinate that is not finite", v));
  }
  if (const Status s = CheckFaces(out); !s.ok()) return s.In("OUT");
  StatusOr<TriangleMesh> in_mesh = FanTriangulate(in);
  if (!in_mesh.ok()) return in_mesh.status().In("IN");
  const StatusOr<Surface> surface = BuildSurface(*std::move(in_mesh));
  if (!surface.ok()) return surface.status().In("IN");
  if (const Status s = CheckTopology(*surface); !s.ok()) return s.In("IN");
  SphereReport report;
  report.noun = FaceNoun(in);
  report.num_faces = in.num_polygons();
  report.num_vertices = surface->mesh.num_vertices;
  if (!Match(in, out, &report)) return report;
  const std::vector<Index>& reversed = report.match.faces.reversed;
  if (surface->turned.empty() && !reversed.empty()) {
    report.errors.push_back(fmt::format("{} run the other way round than in IN ({})",
                                        Count(reversed.size(), report.noun), IdList(reversed)));
  }
  if (!JudgePoints(surface->mesh, out.position, options.radius_tolerance, &report)) return report;
  const JudgedFaces faces{TurnedFaces(in, *surface), std::vector<bool>(in.num_polygons(), false)};
  JudgedMesh judged = BuildJudgedMesh(in, faces, report.match, ImageOnSphere(out.position),
                                      [](const FaceCorner&, const FaceCorner&) { return true; });
  const StatusOr<std::vector<Index>> twin = PairHalfedges(judged.mesh);
  if (!twin.ok()) return twin.status().In("OUT");
  report.orientations = std::move(judged.orientations);
  JudgeMap(judged.mesh, *twin, in, out, options, &report);
  return report;
}

}  // namespace cirque::verify
