#include "cirque/equivalence/half_of_double.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "cirque/equivalence/double_surface.h"
#include "cirque/intrinsic/flip_complex.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/intrinsic/normal_coordinates.h"
#include "cirque/intrinsic/ptolemy_complex.h"
#include "cirque/intrinsic/restore_edges.h"
#include "cirque/intrinsic/triple_flip_complex.h"

namespace cirque {
namespace {

EdgeLengths NoLengths(const Triangulation& t) { return {Eigen::VectorXd::Zero(t.num_edges())}; }

/// Edges of the double that are on the surface's boundary: those of its boundary halfedges.
std::vector<bool> MirrorLine(const Triangulation& surface, const Triangulation& doubled) {
  std::vector<bool> mirror(doubled.num_edges(), false);
  for (Index h = 0; h < surface.num_halfedges(); ++h) {
    if (surface.twin[h] == kNone) mirror[doubled.edge[h]] = true;
  }
  return mirror;
}

/// Numbers the faces that lie on the surface: what begins behind their first side is of it.
std::vector<Index> FacesOfHalf(const NormalCoordinates& normal, Index faces_of_surface) {
  const Index faces = normal.complex().num_halfedges() / 3;
  std::vector<Index> number(faces, kNone);
  Index next = 0;
  for (Index f = 0; f < faces; ++f) {
    const Index begins_in = Triangulation::Face(normal.InputCorner(3 * f, -1));
    if (begins_in < faces_of_surface) number[f] = next++;
  }
  return number;
}

/// A halfedge of the double's as one of the half's.
Index InHalf(const std::vector<Index>& face_of_half, Index h) {
  const Index f = face_of_half[Triangulation::Face(h)];
  return f == kNone ? kNone : 3 * f + h % 3;
}

/// The half as a triangulation, with the flat lengths.
IntrinsicTriangulation CutOut(const Triangulation& surface, const NormalCoordinates& normal,
                              const FlipComplex& metric, const std::vector<Index>& face_of_half) {
  std::vector<Index> vertex, twin, of_double;
  for (Index h = 0; h < metric.num_halfedges(); ++h) {
    if (InHalf(face_of_half, h) == kNone) continue;
    vertex.push_back(metric.vertex(h));
    twin.push_back(InHalf(face_of_half, metric.twin(h)));
    of_double.push_back(h);
  }
  IntrinsicTriangulation cut_out;
  cut_out.triangulation = NumberEdges(surface.num_vertices, std::move(vertex), std::move(twin));
  const Triangulation& t = cut_out.triangulation;
  cut_out.lengths = NoLengths(t);
  cut_out.edge_of_input.assign(surface.num_edges(), kNone);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index there = of_double[h];
    cut_out.lengths.value[t.edge[h]] = metric.length(there);
    if (!normal.IsShared(there)) continue;
    const Index input = normal.SharedHalfedge(there);
    if (input < surface.num_halfedges()) cut_out.edge_of_input[surface.edge[input]] = t.edge[h];
  }
  return cut_out;
}

/// The double's flat metric with the surface's boundary among its edges.
struct RestoredBoundary {
  NormalCoordinates normal;
  FlipComplex metric;
  CornerAngles angles;
  std::vector<Index> flips;
};

CornerAngles AnglesIn(const FlipComplex& metric) {
  Index last = 0;
  for (Index h = 0; h < metric.num_halfedges(); ++h) last = std::max(last, metric.vertex(h));
  const Triangulation t = metric.MakeTriangulation(last + 1);
  return MeasureCornerAngles(t, metric.MakeLengths(t));
}

CornerAngles AnglesIn(const TripleFlipComplex& metric) {
  CornerAngles angles;
  angles.value.resize(metric.complex().num_halfedges());
  for (Index h = 0; h < angles.value.size(); ++h) angles.value[h] = metric.Angle(h);
  return angles;
}

/// The flat lengths with the digits that they were solved with.
std::vector<TripleDouble> ExtendedLengths(const LogScalesResult& result) {
  const std::vector<TripleDouble>& log_lengths = result.extended_log_lengths;
  std::vector<TripleDouble> lengths;
  for (const TripleDouble& x : log_lengths) {
    lengths.push_back(Exp(x + (result.log_lengths[0] - log_lengths[0].Value())));
  }
  return lengths;
}

/// Doubles' lengths have a triangle's angles to half their digits or more where all are above this
/// [rad].
constexpr double kWideAngle = 1e-6;

const FlipComplex& Lengths(const FlipComplex& metric) { return metric; }
const FlipComplex& Lengths(const TripleFlipComplex& metric) { return metric.complex(); }

template <class Metric>
std::optional<RestoredBoundary> RestoreIn(Metric metric, NormalCoordinates normal,
                                          const Triangulation& input,
                                          const std::vector<bool>& boundary) {
  std::vector<Index> flips;
  if (!RestoreEdges(input, boundary, &normal, &metric, &flips)) return {};
  CornerAngles angles = AnglesIn(metric);
  return RestoredBoundary{std::move(normal), Lengths(metric), std::move(angles), std::move(flips)};
}

/// With lengths in doubles, which are enough but for needles and for vertices all but on the
/// boundary's line.
std::optional<RestoredBoundary> RestoreBoundary(const Triangulation& surface,
                                                const Triangulation& input,
                                                const LogScalesResult& result,
                                                const EdgeLengths& flat) {
  const std::vector<bool> boundary = MirrorLine(surface, input);
  const Triangulation& solved = result.intrinsic.triangulation;
  NormalCoordinates normal(input);
  for (const Index h : result.intrinsic.flips) normal.Flip(h);
  auto rounded = RestoreIn(FlipComplex(solved, flat), normal, input, boundary);
  if (rounded && rounded->angles.value.minCoeff() > kWideAngle) return rounded;
  auto extended =
      RestoreIn(TripleFlipComplex(solved, ExtendedLengths(result)), normal, input, boundary);
  return extended ? extended : rounded;
}

/// Angles of the double's corners that the half has, in the order of its own.
CornerAngles AnglesOfHalf(const CornerAngles& angles, const std::vector<Index>& face_of_half) {
  std::vector<double> part;
  for (Index h = 0; h < angles.value.size(); ++h) {
    if (InHalf(face_of_half, h) != kNone) part.push_back(angles.value[h]);
  }
  const auto n = static_cast<Eigen::Index>(part.size());
  return {Eigen::Map<const Eigen::VectorXd>(part.data(), n)};
}

}  // namespace

EquivalentTriangulation TakeWhole(const Triangulation& surface, const LogScalesResult& result,
                                  const EdgeLengths& flat) {
  IntrinsicTriangulation scaled = result.intrinsic;
  scaled.lengths = flat;
  return {{surface, result.delaunay, std::move(scaled), result.log_scale}, {}};
}

std::optional<HalfOfDouble> TakeHalf(const Triangulation& surface, const LogScalesResult& result,
                                     const EdgeLengths& flat, EquivalentTriangulation* whole) {
  const DoubledSurface doubled = DoubleSurface(surface, NoLengths(surface));
  const Triangulation &input = doubled.triangulation, &solved = result.intrinsic.triangulation;
  const auto restored = RestoreBoundary(surface, input, result, flat);
  if (!restored) return {};
  const std::vector<Index>& back = restored->flips;
  whole->face_of_half = FacesOfHalf(restored->normal, surface.num_faces());
  const auto mirrored = std::count(whole->face_of_half.begin(), whole->face_of_half.end(), kNone);
  if (mirrored != surface.num_faces()) return {};
  HalfOfDouble half;
  half.half = CutOut(surface, restored->normal, restored->metric, whole->face_of_half);
  half.angles = AnglesOfHalf(restored->angles, whole->face_of_half);
  PtolemyComplex ideal(solved, result.log_lengths);
  for (const Index h : back) ideal.Flip(h);
  ScaledTriangulation& of = whole->whole;
  of.input = input;
  of.delaunay = result.delaunay;
  of.scaled.triangulation = ideal.MakeTriangulation(input.num_vertices);
  of.scaled.lengths.value = ideal.MakeLogLengths(of.scaled.triangulation).array().exp();
  of.scaled.flips = result.intrinsic.flips;
  of.scaled.flips.insert(of.scaled.flips.end(), back.begin(), back.end());
  of.log_scale.resize(input.num_vertices);
  for (Index v = 0; v < input.num_vertices; ++v) {
    of.log_scale[v] = result.log_scale[doubled.original[v]];
  }
  return half;
}

namespace {

/// What of a double's overlay is of the half.
Overlay HalfOf(const Overlay& whole, const std::vector<Index>& face_of_half, Index num_vertices) {
  Overlay part;
  part.num_vertices = num_vertices;
  part.first_corner.assign(1, 0);
  std::vector<Index> number(whole.num_vertices + whole.crossing.size(), kNone);
  for (Index v = 0; v < part.num_vertices; ++v) number[v] = v;
  for (Index p = 0; p < whole.num_faces(); ++p) {
    const Index f = face_of_half[whole.other_face[p]];
    if (f == kNone) continue;
    for (Index c = whole.first_corner[p]; c < whole.first_corner[p + 1]; ++c) {
      const Overlay::Corner& corner = whole.corner[c];
      Index& vertex = number[corner.vertex];
      if (vertex == kNone) {
        vertex = part.num_vertices + static_cast<Index>(part.crossing.size());
        part.crossing.push_back(whole.crossing[corner.vertex - whole.num_vertices]);
        part.crossing.back().other = InHalf(face_of_half, part.crossing.back().other);
      }
      part.corner.push_back({vertex, corner.input, InHalf(face_of_half, corner.other)});
    }
    part.first_corner.push_back(static_cast<Index>(part.corner.size()));
    part.input_face.push_back(whole.input_face[p]);
    part.other_face.push_back(f);
  }
  return part;
}

/// The vertices of the surface come first among those of its double.
Index VerticesOfHalf(const EquivalentTriangulation& equivalent) {
  const Triangulation& t = equivalent.whole.scaled.triangulation;
  Index most = 0;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (InHalf(equivalent.face_of_half, h) != kNone) most = std::max(most, t.vertex[h]);
  }
  return most + 1;
}

}  // namespace

StatusOr<Overlay> OverlayOf(const EquivalentTriangulation& equivalent, std::int64_t most_faces) {
  if (equivalent.face_of_half.empty()) return OverlayThroughDelaunay(equivalent.whole, most_faces);
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max() / 2;
  const StatusOr<Overlay> whole =
      OverlayThroughDelaunay(equivalent.whole, 2 * std::min(most_faces, kMost));
  if (!whole.ok()) return whole.status();
  return HalfOf(*whole, equivalent.face_of_half, VerticesOfHalf(equivalent));
}

}  // namespace cirque
