#include "cirque/verify/angle_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cirque::verify {
namespace {

double CornerAngle(const UvComplex& complex, Index h) {
  const Point a = complex.Tip(h) - complex.uv[h];
  const Point b = complex.uv[TriangleMesh::Prev(h)] - complex.uv[h];
  return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
}

/// Whether the direction from the apex to p has its angle in [pi, 2 pi).
bool InLowerHalf(const Point& apex, const Point& p) {
  return p.y() < apex.y() || (p.y() == apex.y() && p.x() < apex.x());
}

/// What the vertices' corners add up to.
struct VertexSums {
  explicit VertexSums(Index n) : angle(n, 0), turns(n, 0), inside(n, true), on_seam(n, false) {}
  std::vector<double> angle;
  /// How often the corners, each turning counterclockwise by less than pi, pass the direction +x:
  /// the number of full turns of a closed fan, without rounding.
  std::vector<int> turns;
  std::vector<bool> inside, on_seam;
};

VertexSums SumCorners(const UvComplex& complex, const std::vector<double>& angle) {
  const TriangleMesh& mesh = complex.mesh();
  VertexSums sums(mesh.num_vertices);
  std::vector<bool> used(mesh.num_vertices, false);
  for (Index h = 0; h < static_cast<Index>(angle.size()); ++h) {
    const Index v = mesh.Tail(h);
    used[v] = true;
    sums.angle[v] += angle[h];
    const Point& apex = complex.uv[h];
    const bool passes =
        InLowerHalf(apex, complex.Tip(h)) && !InLowerHalf(apex, complex.uv[TriangleMesh::Prev(h)]);
    if (passes) ++sums.turns[v];
    for (const Index end : {v, mesh.Tip(h)}) {
      if (complex.surface.twin[h] == kNone) sums.inside[end] = false;
      if (complex.IsSeam(h)) sums.on_seam[end] = true;
    }
  }
  for (Index v = 0; v < mesh.num_vertices; ++v) {
    if (!used[v]) sums.inside[v] = false;
  }
  return sums;
}

void JudgeInnerVertices(const TriangleMesh& mesh, const VertexSums& sums, double tolerance,
                        AngleMeasures* result) {
  for (Index v = 0; v < static_cast<Index>(sums.angle.size()); ++v) {
    if (!sums.inside[v]) continue;
    const double deviation = std::abs(sums.angle[v] - 2 * kPi);
    if (!sums.on_seam[v]) {
      ++result->num_plain;
      result->largest_plain_deviation = std::max(result->largest_plain_deviation, deviation);
      if (sums.turns[v] != 1) result->wrapped.push_back(mesh.Origin(v));
      continue;
    }
    ++result->num_on_seam;
    if (deviation > tolerance) {
      result->cones.push_back({mesh.Origin(v), sums.angle[v]});
    } else {
      result->largest_flat_seam_deviation =
          std::max(result->largest_flat_seam_deviation, deviation);
    }
  }
}

void CompareWithTargets(const TriangleMesh& mesh, const VertexSums& sums,
                        const AngleTargets& targets, double tolerance, AngleMeasures* result) {
  result->largest_target_deviation = 0;
  for (Index v = 0; v < static_cast<Index>(sums.angle.size()); ++v) {
    const std::optional<AngleInterval> target = targets.At(mesh.Origin(v), sums.inside[v]);
    if (!target) continue;
    const double deviation = std::max({0.0, kPi * target->lower_over_pi - sums.angle[v],
                                       sums.angle[v] - kPi * target->upper_over_pi});
    result->largest_target_deviation = std::max(result->largest_target_deviation, deviation);
    if (deviation > tolerance) result->off_target.push_back(mesh.Origin(v));
  }
}

}  // namespace

AngleMeasures MeasureAngles(const UvComplex& complex, const AngleTargets& targets,
                            double tolerance) {
  AngleMeasures result;
  std::vector<double> angle(complex.uv.size());
  for (Index h = 0; h < static_cast<Index>(angle.size()); ++h) {
    angle[h] = CornerAngle(complex, h);
    result.smallest_angle = std::fmin(result.smallest_angle, angle[h]);
  }
  for (Index h = 0; h < static_cast<Index>(angle.size()); ++h) {
    const Index t = complex.surface.twin[h];
    if (t < h) continue;  // none, or done from the other side
    const double margin = kPi - angle[TriangleMesh::Prev(h)] - angle[TriangleMesh::Prev(t)];
    result.delaunay_margin = std::fmin(result.delaunay_margin, margin);
  }
  const VertexSums sums = SumCorners(complex, angle);
  JudgeInnerVertices(complex.mesh(), sums, tolerance, &result);
  if (!targets.empty()) CompareWithTargets(complex.mesh(), sums, targets, tolerance, &result);
  return result;
}

}  // namespace cirque::verify
