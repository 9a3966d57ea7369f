#include "cirque/intrinsic/ptolemy_complex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "cirque/core/metric.h"
#include "cirque/core/parallel.h"

namespace cirque {
namespace {

constexpr std::int64_t kMaxFlipsPerHalfedge = 50;
constexpr double kExtendedTolerance = 1e-41;  ///< of logarithms with three times a double's digits

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }
Index Face(Index h) { return Triangulation::Face(h); }

/// Whose angles are others if a side changes by the square of kPtolemyTolerance, relatively, which is
/// what Ptolemy's theorem is off by on quadrilaterals that are as far from a circle.
bool IsNeedle(const LogTriangle& triangle) {
  const auto& tangent = triangle.half_tangent;
  return *std::min_element(tangent.begin(), tangent.end()) < kPtolemyTolerance;
}

}  // namespace

PtolemyComplex::PtolemyComplex(const Triangulation& t, const Eigen::VectorXd& log_lengths,
                               const std::vector<TripleDouble>& scaled_by)
    : complex_(t, EdgeLengths{log_lengths}), lower_(t.num_halfedges()) {
  if (scaled_by.empty()) return;
  std::vector<TripleDouble> length(t.num_edges());
  EdgeLengths high{log_lengths};
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const TripleDouble scale = Half(scaled_by[t.Tail(h)] + scaled_by[t.Tip(h)]);
    length[e] = TripleDouble(log_lengths[e]) + scale;
    high.value[e] = length[e].high;
  }
  complex_ = FlipComplex(t, high);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const TripleDouble& of = length[t.edge[h]];
    lower_[h] = {of.middle, of.low};
  }
}

TripleDouble PtolemyComplex::LogLength(Index h) const {
  return lower_[h].Below(complex_.length(h));
}

double PtolemyComplex::ScaledLogLength(Index h, const Eigen::VectorXd& scale) const {
  return complex_.length(h) + 0.5 * (scale[vertex(Next(h))] + scale[vertex(Prev(h))]);
}

TripleDouble PtolemyComplex::ExtendedLogLength(Index h, const Eigen::VectorXd& scale) const {
  return LogLength(h) + Half(SumOf(scale[vertex(Next(h))], scale[vertex(Prev(h))]));
}

LogTriangle PtolemyComplex::ScaledTriangle(Index face, const Eigen::VectorXd& scale) const {
  // The scale of one corner more or less changes no angle: a constant is taken off all three.
  const Index h = 3 * face;
  const double u0 = scale[vertex(h)];
  const TripleDouble first = Half(SumOf(scale[vertex(h + 1)], -u0));
  const TripleDouble second = Half(SumOf(scale[vertex(h + 2)], -u0));
  return SolveExtendedLogTriangle(
      {LogLength(h) + (first + second), LogLength(h + 1) + second, LogLength(h + 2) + first});
}

bool PtolemyComplex::ViolatesByCosines(Index h, const Eigen::VectorXd& scale) const {
  // 2 cos = b / c + c / b - a^2 / (b c): what is added is compared with what is taken off. Needles have
  // cosines that differ from 1 by less than a double shows.
  std::array<TripleDouble, 2> above{}, below{};
  const Index sides[] = {h, complex_.twin(h)};
  for (int k = 0; k < 2; ++k) {
    const TripleDouble a = ExtendedLogLength(sides[k], scale);
    const TripleDouble b = ExtendedLogLength(Next(sides[k]), scale);
    const TripleDouble c = ExtendedLogLength(Prev(sides[k]), scale);
    above[k] = LogAddExp(b - c, c - b);
    below[k] = (a - b) + (a - c);
  }
  const TripleDouble excess = LogAddExp(below[0], below[1]) - LogAddExp(above[0], above[1]);
  return excess.high > kExtendedTolerance;
}

bool PtolemyComplex::Violates(Index h, const LogTriangle& left, const LogTriangle& right,
                              const Eigen::VectorXd& scale) const {
  // Beside an angle of 0 or pi any other decides, to which cosines are blind where it is tiny.
  if (!left.proper && !right.proper) return ViolatesByCosines(h, scale);
  const double product = left.half_tangent[h % 3] * right.half_tangent[complex_.twin(h) % 3];
  const bool is_tie = std::abs(product - 1) <= kPtolemyTolerance;
  if (is_tie && (IsNeedle(left) || IsNeedle(right))) return ViolatesByCosines(h, scale);
  return product > 1 + kPtolemyTolerance;
}

bool PtolemyComplex::ViolatesDelaunay(Index h, const Eigen::VectorXd& scale) const {
  const Index g = complex_.twin(h);
  if (g == kNone || Face(g) == Face(h)) return false;
  return Violates(h, ScaledTriangle(Face(h), scale), ScaledTriangle(Face(g), scale), scale);
}

void PtolemyComplex::Flip(Index h) {
  const Index g = complex_.twin(h);
  const TripleDouble one = LogLength(Next(h)) + LogLength(Next(g));
  const TripleDouble other = LogLength(Prev(h)) + LogLength(Prev(g));
  const TripleDouble length = LogAddExp(one, other) - LogLength(h);
  FlipTriple(h, length, &complex_, &lower_);
  flips_.push_back(h);
}

bool PtolemyComplex::MakeDelaunay(const Eigen::VectorXd& scale,
                                  std::vector<LogTriangle>* triangles) {
  std::vector<LogTriangle> own;
  std::vector<LogTriangle>& triangle = triangles ? *triangles : own;
  triangle.resize(static_cast<std::size_t>(num_faces()));
  ParallelFor(num_faces(), [&](Index f) { triangle[f] = ScaledTriangle(f, scale); });
  const auto violates = [&](Index h) {
    const Index g = complex_.twin(h);
    return g != kNone && Face(g) != Face(h) &&
           Violates(h, triangle[Face(h)], triangle[Face(g)], scale);
  };
  std::vector<Index> awaiting;
  for (Index h = 0; h < num_halfedges(); ++h) {
    if (complex_.twin(h) > h && violates(h)) awaiting.push_back(h);
  }
  std::int64_t flips_left = kMaxFlipsPerHalfedge * num_halfedges();
  while (!awaiting.empty()) {
    const Index h = awaiting.back();
    awaiting.pop_back();
    if (!violates(h)) continue;
    if (flips_left-- == 0) return false;
    Flip(h);
    for (const Index side : {h, complex_.twin(h)}) {
      triangle[Face(side)] = ScaledTriangle(Face(side), scale);
      awaiting.push_back(Next(side));
      awaiting.push_back(Prev(side));
    }
  }
  return true;
}

Triangulation PtolemyComplex::MakeTriangulation(Index num_vertices) const {
  return complex_.MakeTriangulation(num_vertices);
}

Eigen::VectorXd PtolemyComplex::MakeLogLengths(const Triangulation& t) const {
  return complex_.MakeLengths(t).value;
}

std::vector<TripleDouble> PtolemyComplex::MakeExtendedLogLengths(const Triangulation& t) const {
  std::vector<TripleDouble> lengths;
  for (const Index h : t.edge_halfedge) lengths.push_back(LogLength(h));
  return lengths;
}

}  // namespace cirque
