#include "cirque/verify/sphere_check.h"

#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Geometry>
#include <boost/multiprecision/cpp_int.hpp>
#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/verify/findings.h"
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

/// Matches the triangles; false when the rest cannot be judged.
bool Match(const PolygonSoup& in, const PolygonSoup& out, const FanMesh& in_mesh,
           const FanMesh& out_mesh, SphereReport* report) {
  if (in.position.size() != out.position.size()) {
    report->errors.push_back(
        fmt::format("IN has {} and OUT {}; OUT must keep IN's vertices in their order",
                    Count(in.position.size(), "vertex"), out.position.size()));
    return false;
  }
  report->correspondence = MatchTriangles(in_mesh, out_mesh);
  const Correspondence& match = report->correspondence;
  if (!match.missing.empty()) {
    report->errors.push_back(fmt::format("{} of IN missing from OUT ({})",
                                         Count(match.missing.size(), "triangle"),
                                         IdList(match.missing)));
  }
  if (!match.extra.empty()) {
    report->errors.push_back(fmt::format("{} of OUT not in IN (numbers of OUT: {})",
                                         Count(match.extra.size(), "triangle"),
                                         IdList(match.extra)));
  }
  return match.complete();
}

void JudgePoints(const FanMesh& mesh, const std::vector<Vector3d>& sphere, double tolerance,
                 SphereReport* report) {
  std::vector<bool> judged(mesh.num_vertices, false);
  for (const Index v : mesh.vertex) {
    if (judged[v]) continue;
    judged[v] = true;
    const double deviation = std::abs(sphere[v].norm() - 1);
    report->radius_deviation = std::fmax(report->radius_deviation, deviation);
    if (!(deviation <= tolerance)) report->off_sphere.push_back(v);
  }
  if (report->off_sphere.empty()) return;
  report->errors.push_back(fmt::format("{} not on the unit sphere ({}): by up to {:.3g}",
                                       Count(report->off_sphere.size(), "vertex"),
                                       IdList(report->off_sphere), report->radius_deviation));
}

void JudgeOrientation(const FanMesh& mesh, const std::vector<Vector3d>& sphere,
                      SphereReport* report) {
  for (Index h = 0; h < static_cast<Index>(mesh.vertex.size()); h += 3) {
    const int sign = DeterminantSign(sphere[mesh.vertex[h]], sphere[mesh.vertex[h + 1]],
                                     sphere[mesh.vertex[h + 2]]);
    if (sign < 0) report->flipped.push_back(h / 3);
    if (sign == 0) report->flat.push_back(h / 3);
  }
  for (const auto& [name, ids] :
       {std::pair("flipped", &report->flipped), std::pair("without area", &report->flat)}) {
    if (ids->empty()) continue;
    report->errors.push_back(
        fmt::format("{} {} ({})", Count(ids->size(), "triangle"), name, IdList(*ids)));
  }
}

/// `mesh`: OUT's triangles as OUT lists them, in IN's order.
void JudgeMap(const FanMesh& mesh, const std::vector<Index>& twin, const PolygonSoup& in,
              const PolygonSoup& out, const SphereCheckOptions& options, SphereReport* report) {
  JudgePoints(mesh, out.position, options.radius_tolerance, report);
  if (!report->valid()) return;
  report->measured = true;
  JudgeOrientation(mesh, out.position, report);
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
  const StatusOr<FanMesh> in_mesh = FanTriangulate(in), out_mesh = FanTriangulate(out);
  if (!in_mesh.ok()) return in_mesh.status().In("IN");
  if (!out_mesh.ok()) return out_mesh.status().In("OUT");
  const StatusOr<Surface> surface = BuildSurface(*in_mesh);
  if (!surface.ok()) return surface.status().In("IN");
  if (const Status s = CheckTopology(*surface); !s.ok()) return s.In("IN");
  SphereReport report;
  report.num_triangles = in_mesh->num_triangles();
  report.num_vertices = in_mesh->num_vertices;
  if (!Match(in, out, *in_mesh, *out_mesh, &report)) return report;
  const bool in_is_oriented = surface->turned.empty();
  if (in_is_oriented && !report.correspondence.reversed.empty()) {
    report.errors.push_back(fmt::format("{} run the other way round than in IN ({})",
                                        Count(report.correspondence.reversed.size(), "triangle"),
                                        IdList(report.correspondence.reversed)));
  }
  const FanMesh mesh = Reorder(*out_mesh, report.correspondence);
  const StatusOr<std::vector<Index>> twin = PairHalfedges(mesh);
  if (!twin.ok()) return twin.status().In("OUT");
  JudgeMap(mesh, *twin, in, out, options, &report);
  return report;
}

}  // namespace cirque::verify
