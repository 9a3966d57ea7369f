#include "cirque/layout/seams.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include <fmt/format.h>

#include "cirque/intrinsic/corner_angles.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

/// The vertices where paths of the cut end.
std::vector<bool> Nodes(const Triangulation& t, const Cut& cut, const std::vector<Index>& cones) {
  std::vector<Index> ends(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (cut.edge[t.edge[h]] && t.twin[h] != kNone) ++ends[t.Tail(h)];
  }
  std::vector<bool> node = BoundaryVertices(t);
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (ends[v] != 2) node[v] = true;
  }
  for (const Index v : cones) node[v] = true;
  return node;
}

/// The opened halfedge that follows h on the left side of a path, at a vertex that is no node.
Index NextOnSeam(const Triangulation& t, const Cut& cut, Index h) {
  Index g = Triangulation::Next(h);
  while (!cut.edge[t.edge[g]]) g = Triangulation::Next(t.twin[g]);
  return g;
}

/// Measures the motions in the plane, which complex numbers make short: right = unit left + t.
class SeamMeter {
 public:
  SeamMeter(const Triangulation& t, const CornerUv& uv) : t_(t), uv_(uv) {}

  void Measure(Seam* seam, SeamReport* report) const {
    Complex turn = 0;
    for (const Index h : seam->halfedges) turn += Right(h) * std::conj(Left(h));
    seam->rotation = std::arg(turn);
    const Complex unit = std::polar(1., seam->rotation);
    Complex shift = 0;
    for (const Index h : seam->halfedges) shift += RightTail(h) - unit * LeftTail(h);
    shift /= static_cast<double>(seam->halfedges.size());
    seam->translation = {shift.real(), shift.imag()};
    for (const Index h : seam->halfedges) Compare(h, unit, shift, report);
  }

 private:
  Complex At(Index corner) const { return {uv_.value[corner].x(), uv_.value[corner].y()}; }
  Complex LeftTail(Index h) const { return At(Triangulation::Next(h)); }
  Complex LeftTip(Index h) const { return At(Triangulation::Prev(h)); }
  Complex RightTail(Index h) const { return LeftTip(t_.twin[h]); }
  Complex RightTip(Index h) const { return LeftTail(t_.twin[h]); }
  Complex Left(Index h) const { return LeftTip(h) - LeftTail(h); }
  Complex Right(Index h) const { return RightTip(h) - RightTail(h); }

  void Compare(Index h, Complex unit, Complex shift, SeamReport* report) const {
    const double left = std::abs(Left(h)), right = std::abs(Right(h));
    const auto raise = [](double* worst, double value) { *worst = std::max(*worst, value); };
    raise(&report->max_length_mismatch, std::abs(left - right) / std::max(left, right));
    raise(&report->max_rotation_mismatch, std::abs(std::arg(Right(h) * std::conj(unit * Left(h)))));
    raise(&report->max_gap, std::abs(RightTail(h) - unit * LeftTail(h) - shift));
    raise(&report->max_gap, std::abs(RightTip(h) - unit * LeftTip(h) - shift));
  }

  const Triangulation& t_;
  const CornerUv& uv_;
};

double Diameter(const CornerUv& uv) {
  Eigen::Vector2d lower = uv.value.front(), upper = lower;
  for (const Eigen::Vector2d& p : uv.value) {
    lower = lower.cwiseMin(p);
    upper = upper.cwiseMax(p);
  }
  return (upper - lower).norm();
}

/// Walking counter-clockwise about v and leaving the face of a halfedge that ends at v across it,
/// one comes from its path's left to its right. Directions turn by Theta within the faces and by
/// the rotations across the paths, and come back to what they were.
double ConeMismatch(const Triangulation& t, const std::vector<Seam>& seams,
                    const CornerAngles& angles) {
  std::vector<double> turn = VertexAngleSums(t, angles);
  std::vector<bool> on_cut(t.num_vertices, false);
  for (const Seam& seam : seams) {
    for (const Index h : seam.halfedges) {
      turn[t.Tip(h)] += seam.rotation;
      turn[t.Tail(h)] -= seam.rotation;
      on_cut[t.Tip(h)] = on_cut[t.Tail(h)] = true;
    }
  }
  const std::vector<bool> boundary = BoundaryVertices(t);
  double worst = 0;
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (!on_cut[v] || boundary[v]) continue;
    worst = std::max(worst, std::abs(std::remainder(turn[v], 2 * kPi)));
  }
  return worst;
}

}  // namespace

std::vector<Seam> TraceSeams(const Triangulation& t, const Cut& cut,
                             const std::vector<Index>& cones) {
  if (cut.IsEmpty()) return {};
  const std::vector<bool> node = Nodes(t, cut, cones);
  std::vector<bool> traced(t.num_edges(), false);
  std::vector<Seam> seams;
  // First the paths that begin at a node, then what is left: closed ones.
  for (const bool closed : {false, true}) {
    for (Index start = 0; start < t.num_halfedges(); ++start) {
      const Index edge = t.edge[start];
      if (!cut.edge[edge] || t.twin[start] == kNone || traced[edge]) continue;
      if (!closed && !node[t.Tail(start)]) continue;
      Seam& seam = seams.emplace_back();
      for (Index h = start; !traced[t.edge[h]]; h = NextOnSeam(t, cut, h)) {
        traced[t.edge[h]] = true;
        seam.halfedges.push_back(h);
        if (node[t.Tip(h)]) break;
      }
    }
  }
  return seams;
}

SeamReport MeasureSeams(const Triangulation& t, const Cut& cut, const std::vector<Index>& cones,
                        const CornerAngles& flat_angles, const CornerUv& uv) {
  SeamReport report;
  report.seams = TraceSeams(t, cut, cones);
  if (report.seams.empty()) return report;
  const SeamMeter meter(t, uv);
  for (Seam& seam : report.seams) meter.Measure(&seam, &report);
  report.max_gap /= Diameter(uv);
  report.max_cone_mismatch = ConeMismatch(t, report.seams, flat_angles);
  return report;
}

StatusOr<std::vector<int>> IntegerRotations(const Triangulation& t, const SeamReport& report,
                                            int order, double tolerance) {
  const double unit = 2 * kPi / order;
  std::vector<int> multiples;
  for (const Seam& seam : report.seams) {
    const double multiple = std::round(seam.rotation / unit);
    if (!(std::abs(seam.rotation - multiple * unit) <= tolerance)) {
      return Status::InvalidInput(fmt::format(
          "the seam from vertex {} to vertex {} (0-based) turns by {:.9g} pi, no multiple of "
          "2 pi / {}; give cones of such angles, and on loops and handles too",
          t.Tail(seam.halfedges.front()), t.Tip(seam.halfedges.back()), seam.rotation / kPi,
          order));
    }
    // A half turn either way is the same; one of the two names it.
    multiples.push_back(static_cast<int>(2 * multiple == -order ? -multiple : multiple));
  }
  return multiples;
}

}  // namespace cirque
