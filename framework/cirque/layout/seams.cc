#include "cirque/layout/seams.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/intrinsic/intrinsic_surface.h"

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
      return Status::InvalidInput(
          fmt::format("the seam from vertex {} (0-based) to vertex {} (0-based) turns by {:.9g} "
                      "pi, no multiple of "
                      "2 pi / {}; give cones of such angles, and on loops and handles too",
                      t.Tail(seam.halfedges.front()), t.Tip(seam.halfedges.back()),
                      seam.rotation / kPi, order));
    }
    // A half turn either way is the same; one of the two names it.
    multiples.push_back(static_cast<int>(2 * multiple == -order ? -multiple : multiple));
  }
  return multiples;
}

namespace {

/// The rotation by multiple 2 pi / order; by right angles without rounding.
Eigen::Matrix2d Rotation(int multiple, int order) {
  Eigen::Matrix2d rotation;
  if ((4 * multiple) % order == 0) {
    constexpr std::array<int, 4> kCosine = {1, 0, -1, 0};
    const int quarter = ((4 * multiple / order) % 4 + 4) % 4;
    const int c = kCosine[quarter], s = kCosine[(quarter + 3) % 4];
    rotation << c, -s, s, c;
  } else {
    const double angle = 2 * kPi * multiple / order;
    rotation << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  }
  return rotation;
}

class Snapper {
 public:
  Snapper(const Triangulation& t, const Cut& cut, const CornerUv& uv)
      : t_(t), open_(CutOpen(t, cut)), position_(open_.num_vertices) {
    for (Index c = 0; c < open_.num_halfedges(); ++c) position_[open_.vertex[c]] = uv.value[c];
  }

  void Snap(const std::vector<Seam>& seams, const std::vector<Eigen::Matrix2d>& rotation) {
    // What rounding leaves of the first displacement, the next ones take away.
    constexpr int kRounds = 3;
    for (int round = 0; round < kRounds; ++round) AgreeAtNodes(seams, rotation);
    for (std::size_t i = 0; i < seams.size(); ++i) MoveRightSide(seams[i], rotation[i]);
  }

  /// Hands the positions back; returns the largest displacement.
  double WriteTo(CornerUv* uv) const {
    double moved = 0;
    for (Index c = 0; c < open_.num_halfedges(); ++c) {
      const Eigen::Vector2d& p = position_[open_.vertex[c]];
      moved = std::max(moved, (p - uv->value[c]).norm());
      uv->value[c] = p;
    }
    return moved;
  }

 private:
  Index Left(Index corner) const { return open_.vertex[corner]; }
  Index LeftTail(Index h) const { return Left(Triangulation::Next(h)); }
  Index LeftTip(Index h) const { return Left(Triangulation::Prev(h)); }
  Index RightTail(Index h) const { return LeftTip(t_.twin[h]); }
  Index RightTip(Index h) const { return LeftTail(t_.twin[h]); }

  /// Displaces the ends of seams least so that right - R left is the same at both ends of each.
  void AgreeAtNodes(const std::vector<Seam>& seams, const std::vector<Eigen::Matrix2d>& rotation) {
    std::vector<Index> number(open_.num_vertices, kNone), vertex;
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::VectorXd target(2 * seams.size());
    for (std::size_t i = 0; i < seams.size(); ++i) {
      const Index first = seams[i].halfedges.front(), last = seams[i].halfedges.back();
      const std::array<Index, 4> end = {RightTail(first), LeftTail(first), RightTip(last),
                                        LeftTip(last)};
      const Eigen::Matrix2d one = Eigen::Matrix2d::Identity();
      const std::array<Eigen::Matrix2d, 4> factor = {one, -rotation[i], -one, rotation[i]};
      Eigen::Vector2d gap(0, 0);
      for (int k = 0; k < 4; ++k) {
        gap += factor[k] * position_[end[k]];
        if (number[end[k]] == kNone) {
          number[end[k]] = static_cast<Index>(vertex.size());
          vertex.push_back(end[k]);
        }
        for (int entry = 0; entry < 4; ++entry) {
          const int row = entry / 2, column = entry % 2;
          entries.emplace_back(2 * i + row, 2 * number[end[k]] + column, factor[k](row, column));
        }
      }
      target.segment<2>(2 * i) = -gap;
    }
    Eigen::SparseMatrix<double> agreement(target.size(), 2 * vertex.size());
    agreement.setFromTriplets(entries.begin(), entries.end());
    Displace(agreement, target, vertex);
  }

  /// Conjugate gradients from zero find the least of all solutions.
  void Displace(const Eigen::SparseMatrix<double>& agreement, const Eigen::VectorXd& target,
                const std::vector<Index>& vertex) {
    Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double>, Eigen::IdentityPreconditioner>
        solver(agreement);
    const Eigen::VectorXd displacement = solver.solve(target);
    if (!displacement.allFinite()) return;
    for (std::size_t i = 0; i < vertex.size(); ++i) {
      position_[vertex[i]] += displacement.segment<2>(2 * i);
    }
  }

  /// The vertices between the seam's ends; each lies on this seam alone.
  void MoveRightSide(const Seam& seam, const Eigen::Matrix2d& rotation) {
    const Index first = seam.halfedges.front();
    const Eigen::Vector2d translation =
        position_[RightTail(first)] - rotation * position_[LeftTail(first)];
    for (std::size_t i = 0; i + 1 < seam.halfedges.size(); ++i) {
      const Index h = seam.halfedges[i];
      position_[RightTip(h)] = rotation * position_[LeftTip(h)] + translation;
    }
  }

  const Triangulation& t_;
  Triangulation open_;
  std::vector<Eigen::Vector2d> position_;
};

}  // namespace

double SnapSeams(const Triangulation& t, const Cut& cut, const SeamReport& report,
                 const std::vector<int>& multiple, int order, CornerUv* uv) {
  CHECK_EQ(multiple.size(), report.seams.size());
  if (report.seams.empty()) return 0;
  std::vector<Eigen::Matrix2d> rotation;
  for (const int m : multiple) rotation.push_back(Rotation(m, order));
  Snapper snapper(t, cut, *uv);
  snapper.Snap(report.seams, rotation);
  return snapper.WriteTo(uv);
}

}  // namespace cirque
