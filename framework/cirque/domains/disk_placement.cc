#include "cirque/domains/disk_placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/layout/linear_layout.h"
#include "cirque/metrics/injectivity.h"

namespace cirque {
namespace {

constexpr int kMaxRecentrings = 60;
constexpr double kCentred = 1e-14;     ///< then the centre moves to 0
constexpr double kTinyShare = 1e-300;  ///< of a vertex without area: weights must be positive

std::vector<double> AreaShares(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  std::vector<double> share(t.num_vertices, 0);
  double total = 0;
  for (Index f = 0; f < t.num_faces(); ++f) {
    const auto corner = [&](int k) { return surface.position[t.vertex[3 * f + k]]; };
    const double area = (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
    for (Index h = 3 * f; h < 3 * f + 3; ++h) share[t.vertex[h]] += area;
    total += 3 * area;
  }
  for (double& a : share) a = std::max(a / total, kTinyShare);
  return share;
}

/// Half of the two boundary edges at a vertex.
std::vector<double> LengthShares(const Triangulation& t, const EdgeLengths& lengths) {
  std::vector<double> share(t.num_vertices, 0);
  double total = 0;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (!t.IsBoundaryEdge(e)) continue;
    const Index h = t.edge_halfedge[e];
    for (const Index v : {t.Tail(h), t.Tip(h)}) share[v] += lengths.value[e];
    total += 2 * lengths.value[e];
  }
  for (double& s : share) s = std::max(s / total, kTinyShare);
  return share;
}

Complex OnCircle(Complex w) { return w / std::abs(w); }

}  // namespace

bool PutsMassAtCentre(const DomainOptions& options) {
  return !options.normalization.empty() && options.normalization != "none";
}

DiskPlacement::DiskPlacement(const Surface& surface, const IntrinsicSurface& intrinsic,
                             const DomainOptions& domain, const SolveControl& control)
    : t_(surface.triangulation),
      numbers_(surface.soup_vertex),
      domain_(domain),
      control_(control),
      on_boundary_(intrinsic.boundary),
      weights_(PositiveCotangents(t_, intrinsic.angles)),
      area_(AreaShares(surface)),
      length_(LengthShares(t_, intrinsic.lengths)),
      centre_(domain.centre),
      angle_zero_(domain.angle_zero) {
  if (angle_zero_ != kNone) return;
  angle_zero_ = static_cast<Index>(std::find(on_boundary_.begin(), on_boundary_.end(), true) -
                                   on_boundary_.begin());
}

bool DiskPlacement::InCore(Index v) const {
  return v == chart_.disk.pole || chart_.disk.rest.of_vertex[v] != kNone;
}

ExtendedComplex DiskPlacement::InChart(Index v) const {
  return v == chart_.disk.pole ? ExtendedComplex::Infinity() : ExtendedComplex(chart_.position[v]);
}

/// The median of the chart's inner vertices by area, in either coordinate.
Complex DiskPlacement::AmidTheSurface() const {
  std::vector<std::pair<double, double>> x, y;
  for (const Index v : chart_.disk.rest.vertex) {
    if (on_boundary_[v]) continue;
    x.emplace_back(chart_.position[v].real(), area_[v]);
    y.emplace_back(chart_.position[v].imag(), area_[v]);
  }
  if (x.empty()) return {0.5, 0.5};
  return {WeightedMedian(std::move(x)), WeightedMedian(std::move(y))};
}

/// Boundary vertices beyond chords share the arc of the disk about `start` as their edges share the
/// length. They become points of the chart, so that every later map treats them alike.
void DiskPlacement::PlaceOverhangingBoundary(Complex start) {
  const std::vector<Index>& loop = chart_.disk.loop;
  std::vector<double> angles = {0};
  for (std::size_t k = 1; k < loop.size(); ++k) {
    const double x = chart_.position[loop[k]].real() - start.real();
    angles.push_back(InCore(loop[k]) ? 2 * (kPi - std::atan2(start.imag(), x)) : kUnset);
  }
  FillAngles(chart_.disk.arc, &angles);
  for (std::size_t k = 1; k < loop.size(); ++k) {
    if (InCore(loop[k])) continue;
    chart_.position[loop[k]] = start.real() - start.imag() / std::tan(0.5 * angles[k]);
  }
}

WeightedPoints DiskPlacement::PointsOf(const std::string& normalization) const {
  WeightedPoints points;
  for (Index v = 0; v < t_.num_vertices; ++v) {
    if (normalization == "boundary" ? !on_boundary_[v] : !on_boundary_[v] && !InCore(v)) continue;
    points.point.push_back(InChart(v));
    points.weight.push_back(normalization == "boundary" ? length_[v] : area_[v]);
  }
  return points;
}

Index DiskPlacement::NearestToCentre(Complex c) const {
  const Moebius to_disk = Moebius::Cayley(c);
  Index nearest = kNone;
  double least = std::numeric_limits<double>::infinity();
  for (const Index v : chart_.disk.rest.vertex) {
    if (on_boundary_[v] || numbers_[v] == kNone || !(chart_.position[v].imag() > 0)) continue;
    const double distance = std::abs(to_disk(chart_.position[v]).value);
    if (distance < least) nearest = v;
    least = std::min(least, distance);
  }
  return nearest;
}

/// The point of the chart that goes to 0.
Complex DiskPlacement::ChooseCentre(Complex start) {
  centre_ = domain_.centre;
  if (PutsMassAtCentre(domain_)) {
    return BalancingPoint(PointsOf(domain_.normalization), start, control_);
  }
  if (centre_ == kNone) {
    centre_ = NearestToCentre(BalancingPoint(PointsOf("area"), start, control_));
  }
  if (centre_ == kNone) return start;
  return InCore(centre_) ? chart_.position[centre_] : Complex(0, 0);
}

std::vector<Index> DiskPlacement::Place(const HalfPlaneChart& chart) {
  chart_ = chart;
  const Complex start = AmidTheSurface();
  if (!(start.imag() > 0)) return AllFaces();
  PlaceOverhangingBoundary(start);
  const Complex c = ChooseCentre(start);
  if (!(c.imag() > 0)) return AllFaces();
  const Moebius to_disk = Moebius::Cayley(c);
  position_.assign(t_.num_vertices, 0);
  std::vector<bool> fixed(t_.num_vertices, false);
  for (Index v = 0; v < t_.num_vertices; ++v) {
    fixed[v] = on_boundary_[v] || InCore(v);
    if (fixed[v]) position_[v] = to_disk(InChart(v)).value;
  }
  for (const Index v : chart_.disk.loop) position_[v] = OnCircle(position_[v]);
  return Embed(fixed) ? Finish() : AllFaces();
}

/// Angles of the boundary loop seen from a point above its middle, from the chain's lengths alone:
/// coordinates might not tell its vertices apart.
std::vector<double> DiskPlacement::AnglesFromLengths() const {
  const PuncturedDisk& disk = chart_.disk;
  std::vector<double> angles(disk.loop.size(), kUnset);
  angles[0] = 0;
  if (disk.rest.face.empty()) return disk.arc;  // spread wholly
  std::vector<double> arc_of(t_.num_vertices, 0);
  for (std::size_t k = 0; k < disk.loop.size(); ++k) arc_of[disk.loop[k]] = disk.arc[k];
  const auto arc_at = [&](Index v) { return arc_of[disk.rest.vertex[v]]; };
  const auto middle = static_cast<std::size_t>(
      std::lower_bound(disk.chain.begin(), disk.chain.end() - 1, 0.5,
                       [&](Index v, double half) { return arc_at(v) < half; }) -
      disk.chain.begin());
  std::vector<double> x(disk.chain.size(), 0);
  for (std::size_t k = middle + 1; k < x.size(); ++k) x[k] = x[k - 1] + chart_.chain_length[k - 1];
  for (std::size_t k = middle; k-- > 0;) x[k] = x[k + 1] - chart_.chain_length[k];
  std::vector<std::pair<double, double>> distances;
  for (std::size_t k = 0; k < x.size(); ++k) {
    if (k != middle)
      distances.emplace_back(std::abs(x[k]), length_[disk.rest.vertex[disk.chain[k]]]);
  }
  const double height = WeightedMedian(std::move(distances));
  std::vector<double> angle_of(t_.num_vertices, kUnset);
  for (std::size_t k = 0; k < x.size(); ++k) {
    angle_of[disk.rest.vertex[disk.chain[k]]] = 2 * (kPi - std::atan2(height, x[k]));
  }
  for (std::size_t k = 1; k < angles.size(); ++k) angles[k] = angle_of[disk.loop[k]];
  FillAngles(disk.arc, &angles);
  return angles;
}

std::vector<Index> DiskPlacement::Spread(const HalfPlaneChart& chart, double share) {
  chart_ = chart;
  centre_ = domain_.centre;
  const std::vector<Index>& loop = chart_.disk.loop;
  const std::vector<double> angles = AnglesFromLengths();
  position_.assign(t_.num_vertices, 0);
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const double angle = (1 - share) * angles[k] + share * 2 * kPi * chart_.disk.arc[k];
    position_[loop[k]] = OnCircle(std::polar(1.0, angle));
  }
  return RecentreAndEmbed() ? Finish() : AllFaces();
}

/// Embeds the interior convexly, moving the boundary by disk automorphisms until the centre is at
/// 0.
bool DiskPlacement::RecentreAndEmbed() {
  for (int i = 0; i < kMaxRecentrings; ++i) {
    if (!Embed(on_boundary_)) return false;
    if (centre_ == kNone || std::abs(position_[centre_]) <= kCentred) return true;
    const Moebius recentre = Moebius::DiskAutomorphism(position_[centre_]);
    for (const Index v : chart_.disk.loop) position_[v] = OnCircle(recentre(position_[v]).value);
  }
  return true;
}

bool DiskPlacement::Embed(const std::vector<bool>& fixed) {
  if (std::find(fixed.begin(), fixed.end(), false) == fixed.end()) return true;
  std::vector<Eigen::Vector2d> points;
  for (const Complex w : position_) points.emplace_back(w.real(), w.imag());
  if (!EmbedConvexly(t_, weights_, fixed, &points).ok()) return false;
  for (Index v = 0; v < t_.num_vertices; ++v) position_[v] = {points[v].x(), points[v].y()};
  return true;
}

/// Turns the disk, puts what is prescribed exactly there, and looks for flipped faces.
std::vector<Index> DiskPlacement::Finish() {
  const Complex turn = std::conj(position_[angle_zero_]);
  for (Complex& w : position_) w *= turn;
  for (const Index v : chart_.disk.loop) position_[v] = OnCircle(position_[v]);
  position_[angle_zero_] = 1;
  if (centre_ != kNone && std::abs(position_[centre_]) <= kCentred) position_[centre_] = 0;
  for (const Complex w : position_) {
    if (!std::isfinite(w.real()) || !std::isfinite(w.imag())) return AllFaces();
  }
  return FlippedFaces(t_, Uv());
}

std::vector<Index> DiskPlacement::AllFaces() const {
  std::vector<Index> all(t_.num_faces());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void DiskPlacement::TakePositions(const Triangulation& t, const CornerUv& uv) {
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    position_[t.vertex[h]] = {uv.value[h].x(), uv.value[h].y()};
  }
}

void DiskPlacement::TakePlaces(const DiskPlacement& other) {
  chart_ = other.chart_;
  position_ = other.position_;
  centre_ = other.centre_;
  angle_zero_ = other.angle_zero_;
}

CornerUv DiskPlacement::UvOf(const Triangulation& t) const {
  CornerUv uv;
  for (const Index v : t.vertex) uv.value.emplace_back(position_[v].real(), position_[v].imag());
  return uv;
}

double DiskPlacement::BoundaryCentreOfMass() const {
  std::vector<Complex> points;
  std::vector<double> weights;
  for (const Index v : chart_.disk.loop) {
    points.push_back(position_[v]);
    weights.push_back(length_[v]);
  }
  return CentreOfMass(points, weights);
}

double DiskPlacement::AreaCentreOfMass() const { return CentreOfMass(position_, area_); }

}  // namespace cirque
