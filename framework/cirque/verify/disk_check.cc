#include "cirque/verify/disk_check.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/verify/report_words.h"

namespace cirque::verify {
namespace {

/// The boundary halfedge that begins where the boundary halfedge h ends.
Index Follow(const UvComplex& complex, Index h) {
  Index next = TriangleMesh::Next(h);
  while (complex.surface.twin[next] != kNone) next = TriangleMesh::Next(complex.surface.twin[next]);
  return next;
}

double EnclosedArea(const UvComplex& complex, const std::vector<Index>& loop) {
  double twice = 0;
  for (const Index h : loop) {
    const Point &a = complex.Tail(h), &b = complex.Tip(h);
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

/// The halfedges of every boundary loop, that which encloses the largest area first.
std::vector<std::vector<Index>> LoopsOutermostFirst(const UvComplex& complex) {
  std::vector<bool> seen(complex.uv.size(), false);
  std::vector<std::vector<Index>> loops;
  double largest = -HUGE_VAL;
  for (Index start = 0; start < static_cast<Index>(seen.size()); ++start) {
    if (complex.surface.twin[start] != kNone || seen[start]) continue;
    std::vector<Index> loop;
    for (Index h = start; !seen[h]; h = Follow(complex, h)) {
      seen[h] = true;
      loop.push_back(h);
    }
    const double area = EnclosedArea(complex, loop);
    loops.push_back(std::move(loop));
    if (area > largest) std::swap(loops.front(), loops.back());
    largest = std::max(largest, area);
  }
  return loops;
}

/// The centre of the circle through three points; not finite where they lie on a line.
Point CentreOf(const Point& a, const Point& b, const Point& c) {
  const Point u = b - a, v = c - a;
  const double twice = 2 * (u.x() * v.y() - u.y() * v.x());
  return a + Point(v.y() * u.squaredNorm() - u.y() * v.squaredNorm(),
                   u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) /
                 twice;
}

/// x^2 + y^2 - 1 from exact products, halved: | |p| - 1 | to rounding of its own size.
double CircleError(const Point& p) {
  const double x2 = p.x() * p.x(), y2 = p.y() * p.y();
  const double rest = std::fma(p.x(), p.x(), -x2) + std::fma(p.y(), p.y(), -y2);
  const double larger = std::max(x2, y2), smaller = std::min(x2, y2);
  return std::abs(((larger - 1) + smaller + rest) / (1 + p.norm()));
}

constexpr std::size_t kTriples = 3;  ///< that a hole's circle is sought through

/// One hole, by the circle through three vertices from that one on.
HoleFit FitHole(const UvComplex& complex, const std::vector<Index>& loop, std::size_t begin,
                double tolerance) {
  HoleFit fit;
  const auto at = [&](std::size_t third) {
    return complex.Tail(loop[(begin + third * loop.size() / 3) % loop.size()]);
  };
  const Point first = at(0), centre = CentreOf(first, at(1), at(2));
  for (const Index h : loop) {
    const double error = std::abs((complex.Tail(h) - centre).norm() - (first - centre).norm());
    // Not a number: no circle.
    if (!(error <= tolerance)) {
      fit.off_circle.push_back(complex.mesh().Origin(complex.mesh().Tail(h)));
    }
    if (!(error <= fit.largest_error)) fit.largest_error = error;
  }
  return fit;
}

bool IsLowerHalf(const Point& p) { return p.y() < 0 || (p.y() == 0 && p.x() < 0); }

/// Whether a has a smaller angle in [0, 2 pi) than b, exactly.
bool Precedes(const Point& a, const Point& b) {
  if (IsLowerHalf(a) != IsLowerHalf(b)) return IsLowerHalf(b);
  return Orientation(Point(0, 0), a, b) > 0;
}

}  // namespace

DiskFit FitDisk(const UvComplex& complex, double tolerance) {
  DiskFit fit;
  const std::vector<std::vector<Index>> loops = LoopsOutermostFirst(complex);
  if (loops.empty()) return fit;
  for (const Index h : loops.front()) {
    ++fit.num_vertices;
    const Point &a = complex.Tail(h), &b = complex.Tip(h);
    const double error = CircleError(a);
    if (error > tolerance) fit.off_circle.push_back(complex.mesh().Origin(complex.mesh().Tail(h)));
    if (fit.farthest == kNone || error > fit.largest_error) {
      fit.largest_error = error;
      fit.farthest = complex.mesh().Origin(complex.mesh().Tail(h));
    }
    if (Precedes(a, b)) continue;
    ++fit.turns;
    if (Orientation(Point(0, 0), b, a) >= 0)
      fit.out_of_order.push_back(complex.mesh().Origin(complex.mesh().Tip(h)));
  }
  return fit;
}

std::vector<std::string> DiskErrors(const UvComplex& complex, const DiskFit& fit,
                                    double tolerance) {
  std::vector<std::string> errors;
  if (fit.num_vertices == 0) return {"no boundary: the surface is no disk"};
  if (complex.num_patches != 1) errors.push_back("seams cut the disk into several pieces");
  if (!fit.off_circle.empty()) {
    errors.push_back(fmt::format(
        "{} of the boundary off the unit circle ({}): by up to {:.3g} at {}, {:.3g} allowed",
        Count(fit.off_circle.size(), "vertex"), IdList(fit.off_circle), fit.largest_error,
        fit.farthest, tolerance));
  }
  if (fit.turns != 1) {
    errors.push_back(
        fmt::format("the boundary does not go round the circle once, in order: {} turns; not after "
                    "the one before: {}",
                    fit.turns, IdList(fit.out_of_order)));
  }
  return errors;
}

HoleFit FitHoles(const UvComplex& complex, double tolerance) {
  HoleFit fit;
  const std::vector<std::vector<Index>> loops = LoopsOutermostFirst(complex);
  for (std::size_t k = 1; k < loops.size(); ++k) {
    HoleFit best = FitHole(complex, loops[k], 0, tolerance);
    for (std::size_t begin = 1; begin < kTriples && !best.off_circle.empty(); ++begin) {
      HoleFit other = FitHole(complex, loops[k], begin, tolerance);
      if (other.off_circle.size() < best.off_circle.size()) best = std::move(other);
    }
    ++fit.holes;
    if (!(best.largest_error <= fit.largest_error)) fit.largest_error = best.largest_error;
    fit.off_circle.insert(fit.off_circle.end(), best.off_circle.begin(), best.off_circle.end());
  }
  return fit;
}

std::vector<std::string> HoleErrors(const HoleFit& fit, double tolerance) {
  if (fit.holes == 0) return {"one boundary loop: the map has no holes"};
  if (fit.off_circle.empty()) return {};
  return {fmt::format("{} of holes off their circles ({}): by up to {:.3g}, {:.3g} allowed",
                      Count(fit.off_circle.size(), "vertex"), IdList(fit.off_circle),
                      fit.largest_error, tolerance)};
}

}  // namespace cirque::verify
