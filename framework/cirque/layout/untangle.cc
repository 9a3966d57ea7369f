#include "cirque/layout/untangle.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>
#include <utility>

#include "cirque/layout/map_objective.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr int kRelaxations = 400;       ///< projections onto the kernel's sides
constexpr int kSteps = 20;              ///< of Gauss-Newton
constexpr double kShortestStep = 1e-4;  ///< of a line search
constexpr double kFar = 100;            ///< of a kernel, over the star's radius

double Cross(Complex a, Complex b) { return a.real() * b.imag() - a.imag() * b.real(); }

}  // namespace

DevelopedStar::DevelopedStar(const Triangulation& t, const CornerAngles& surface_angles,
                             const EdgeLengths& surface_lengths, const InputChart& flat,
                             Index corner)
    : t_(t) {
  double direction = 0;
  t.ForEachCornerAround(corner, [&](Index c) {
    const Index next = Triangulation::Next(c), prev = Triangulation::Prev(c);
    const Complex from = std::polar(flat.lengths.value[t.edge[prev]], direction);
    direction += flat.angles.value[c];
    const Complex to = std::polar(flat.lengths.value[t.edge[next]], direction);
    // The face on the surface, its vertex at 0 and the side to `from` along the x axis.
    const double a = surface_lengths.value[t.edge[prev]], b = surface_lengths.value[t.edge[next]];
    const Complex far = std::polar(b, surface_angles.value[c]), i(0, 1);
    faces_.push_back({c, from, to, a * far.imag() / 2, i * (far - a), -i * far, i * a});
    simple_ = simple_ && t.vertex[next] != t.vertex[corner] && t.vertex[prev] != t.vertex[corner];
  });
}

Complex DevelopedStar::Beltrami(const Face& face, Complex position, Complex* f_z) const {
  const Complex from = face.from - position, to = face.to - position;
  *f_z = from * std::conj(face.hat_from) + to * std::conj(face.hat_to);
  return (from * face.hat_from + to * face.hat_to) / *f_z;
}

double DevelopedStar::WorstDistortion(Complex position) const {
  double worst = 0;
  Complex f_z;
  for (const Face& face : faces_) {
    if (face.area > 0) worst = std::max(worst, std::abs(Beltrami(face, position, &f_z)));
  }
  return worst;
}

double DevelopedStar::Value(const MapObjective& objective, Complex position) const {
  double sum = 0;
  Complex f_z;
  for (const Face& face : faces_) {
    if (!(face.area > 0)) continue;
    const double m_squared = std::norm(Beltrami(face, position, &f_z));
    if (!(m_squared < 1)) return std::numeric_limits<double>::infinity();
    sum += face.area * objective.value(m_squared);
  }
  return sum;
}

std::optional<Complex> DevelopedStar::BestPosition(const MapObjective& objective) const {
  const std::optional<Complex> start = PositionInKernel();
  if (!start) return start;
  Complex position = *start;
  double value = Value(objective, position);
  for (int step = 0; step < kSteps; ++step) {
    Complex gradient = 0;
    double curvature = 0;
    for (const Face& face : faces_) {
      if (!(face.area > 0)) continue;
      Complex f_z;
      const Complex mu = Beltrami(face, position, &f_z);
      const Complex derivative = (face.hat - mu * std::conj(face.hat)) / f_z;
      const double weight = face.area * objective.weight(std::norm(mu));
      gradient += weight * std::conj(derivative) * mu;
      curvature += weight * std::norm(derivative);
    }
    double length = 1;
    while (length > kShortestStep) {
      const Complex next = position - length * gradient / curvature;
      const double at_next = Value(objective, next);
      if (at_next < value && SeesAll(next)) {
        position = next;
        value = at_next;
        break;
      }
      length /= 2;
    }
    if (!(length > kShortestStep)) break;
  }
  return position;
}

bool DevelopedStar::SeesAll(Complex position) const {
  return std::all_of(faces_.begin(), faces_.end(), [&](const Face& face) {
    return Cross(face.from - position, face.to - position) > 0;
  });
}

double DevelopedStar::Radius() const {
  double radius = 0;
  for (const Face& face : faces_) radius = std::max(radius, std::abs(face.from));
  return radius;
}

/// Whether no position lies that far inside all sides: a square about the star, cut along each.
bool DevelopedStar::KernelIsEmpty(double margin, double radius) const {
  const double far = kFar * radius;
  std::vector<Complex> region = {{-far, -far}, {far, -far}, {far, far}, {-far, far}}, cut;
  for (const Face& face : faces_) {
    const double length = std::abs(face.to - face.from);
    if (!(length > 0)) return true;  // lengths that doubles do not hold
    const auto depth = [&](Complex at) {
      return Cross(face.from - at, face.to - at) / length - margin;
    };
    cut.clear();
    for (std::size_t k = 0; k < region.size(); ++k) {
      const Complex a = region[k], b = region[(k + 1) % region.size()];
      const double of_a = depth(a), of_b = depth(b);
      if (of_a >= 0) cut.push_back(a);
      if ((of_a < 0) != (of_b < 0)) cut.push_back(a + of_a / (of_a - of_b) * (b - a));
    }
    region.swap(cut);
    if (region.empty()) return true;
  }
  return false;
}

/// Onto the side of the kernel that is missed most, again and again, with margins in proportion to
/// the star: wide ones first, since a kernel that has room for them lets the position lie well
/// inside.
std::optional<Complex> DevelopedStar::PositionInKernel() const {
  const double radius = Radius();
  for (const double share : {0.1, 0.01, 1e-3, 1e-4, 1e-5}) {
    const double margin = share * radius;
    if (KernelIsEmpty(margin, radius)) continue;
    Complex position = 0;
    for (int round = 0; round < kRelaxations; ++round) {
      double least = std::numeric_limits<double>::infinity();
      Complex inward = 0;
      for (const Face& face : faces_) {
        const Complex side = face.to - face.from;
        const double height = Cross(face.from - position, face.to - position) / std::abs(side);
        if (!(height < least)) continue;
        least = height;
        inward = Complex(0, 1) * side / std::abs(side);
      }
      if (least >= margin && SeesAll(position)) return position;
      position += 1.5 * (margin - least) * inward;
    }
  }
  return std::nullopt;
}

void DevelopedStar::MoveTo(Complex position, InputChart* flat) const {
  for (const Face& face : faces_) {
    const Index next = Triangulation::Next(face.corner), prev = Triangulation::Prev(face.corner);
    const Complex from = face.from - position, to = face.to - position, side = face.to - face.from;
    const auto angle = [](Complex a, Complex b) { return std::arg(std::conj(a) * b); };
    flat->angles.value[face.corner] = angle(from, to);
    flat->angles.value[next] = angle(side, -from);
    flat->angles.value[prev] = angle(-to, -side);
    flat->lengths.value[t_.edge[prev]] = std::abs(from);
  }
}

namespace {

/// One move can flip no face, so every sweep that moves anything leaves fewer of them.
bool IsFlipped(const InputChart& flat, Index face) {
  const auto& angle = flat.angles.value;
  return !(angle[3 * face] > 0 && angle[3 * face + 1] > 0 && angle[3 * face + 2] > 0);
}

/// Moves the best of the face's vertices, if any can right the whole star around it.
bool UntangleFace(const IntrinsicSurface& surface, const std::vector<bool>& movable,
                  const MapObjective& objective, Index face, InputChart* flat) {
  const Triangulation& t = surface.triangulation;
  std::optional<DevelopedStar> best;
  std::complex<double> best_position;
  double least = std::numeric_limits<double>::infinity();
  for (Index corner = 3 * face; corner < 3 * face + 3; ++corner) {
    if (!movable[t.vertex[corner]]) continue;
    const DevelopedStar star(t, surface.angles, surface.lengths, *flat, corner);
    const auto position = star.IsSimple() ? star.BestPosition(objective) : std::nullopt;
    if (!position || !(star.WorstDistortion(*position) < least)) continue;
    best.emplace(star);
    best_position = *position;
    least = star.WorstDistortion(best_position);
  }
  if (best) best->MoveTo(best_position, flat);
  return best.has_value();
}

}  // namespace

int UntangleFlippedTriangles(const IntrinsicSurface& surface, const std::vector<bool>& movable,
                             InputChart* flat) {
  const MapObjective objective = *MapObjectives().Find("mips");
  int moves = 0;
  for (bool moved = true; moved && !flat->flipped.empty();) {
    moved = false;
    std::vector<Index> left;
    for (const Index face : flat->flipped) {
      if (!IsFlipped(*flat, face)) continue;
      if (UntangleFace(surface, movable, objective, face, flat)) {
        moved = true;
        ++moves;
      } else {
        left.push_back(face);
      }
    }
    flat->flipped = std::move(left);
  }
  return moves;
}

}  // namespace cirque
