#include "cirque/lattice/lattice_map.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <fmt/format.h>

#include "cirque/lattice/opened_domain.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;
using Point = Eigen::Vector2d;

constexpr int kDirections = 24;
constexpr double kLeastHeight = 1e-6;  ///< of triangles, as a part of their longest side

Complex NearestOf(LatticeKind kind, Complex z) {
  const Point nearest = NearestInLattice(kind, {z.real(), z.imag()});
  return {nearest.x(), nearest.y()};
}

/// The sides of the cut graph by what is free: lattice vectors, which leave the boundary of the disk
/// closed, sum of (1 - turn) side = 0, and the places of nodes where the metric is flat, which may be
/// anywhere. These make up for what the sides that lead to them would be; those are 0 as lattice
/// vectors.
struct FreeSides {
  Eigen::Index whole = 0;  ///< columns that stand for lattice vectors; the others for nodes
  Eigen::MatrixXcd basis;
};

StatusOr<FreeSides> FindFreeSides(const OpenedDomain& open, LatticeKind kind) {
  std::vector<bool> reached;
  const Eigen::MatrixXcd nodes = open.FreeNodes(&reached);
  Index last = kNone;  // what the others decide
  for (Index p = 0; p < open.num_sides(); ++p) {
    const double size = std::abs(1. - open.Turn(p));
    if (reached[p] || size < 0.5) continue;
    if (last == kNone || size < std::abs(1. - open.Turn(last)) - 1e-9) last = p;
  }
  std::vector<Index> sides;
  for (Index p = 0; p < open.num_sides(); ++p) {
    if (p != last && !reached[p]) sides.push_back(p);
  }
  FreeSides free{static_cast<Eigen::Index>(sides.size()), {}};
  free.basis = Eigen::MatrixXcd::Zero(open.num_sides(), free.whole + nodes.cols());
  free.basis.rightCols(nodes.cols()) = nodes;
  for (Eigen::Index q = 0; q < free.whole; ++q) {
    free.basis(sides[q], q) = 1;
    if (last == kNone) continue;
    const Complex ratio = -(1. - open.Turn(sides[q])) / (1. - open.Turn(last));
    free.basis(last, q) = NearestOf(kind, ratio);
    if (std::abs(free.basis(last, q) - ratio) > 1e-9) {
      return Status(
          StatusCode::kNotConverged,
          "the lattice map: its cones are of thirds and halves of a turn only, and no side "
          "between them closes the others on the lattice; other cones will do");
    }
  }
  return free;
}

/// The energies of displacements by free sides, as a Hermitian form, and what it is about.
struct SideForm {
  std::vector<Eigen::VectorXcd> shift;  ///< of all copies of vertices, by a unit of each free side
  Eigen::VectorXcd free;                ///< what is free as it is in the plane
  Eigen::MatrixXcd upper;               ///< R of the form R' R
};

StatusOr<SideForm> FormOf(const OpenedDomain& open, const FreeSides& free) {
  const Eigen::Index n = free.basis.cols();
  Eigen::VectorXcd sides(open.num_sides());
  for (Index p = 0; p < open.num_sides(); ++p) sides[p] = open.Side(p);
  SideForm form{{}, free.basis.colPivHouseholderQr().solve(sides), {}};
  Eigen::MatrixXcd energy(n, n);
  for (Eigen::Index q = 0; q < n; ++q) {
    form.shift.push_back(open.Displace(free.basis.col(q)));
    const Eigen::VectorXcd product = open.Laplacian(form.shift.back());
    for (Eigen::Index r = 0; r <= q; ++r) {
      energy(r, q) = form.shift[r].dot(product);
      energy(q, r) = std::conj(energy(r, q));
    }
  }
  const Eigen::LLT<Eigen::MatrixXcd> factor(energy);
  if (factor.info() != Eigen::Success)
    return Status(StatusCode::kNotConverged, "the lattice map's energy is not positive");
  form.upper = factor.matrixU();
  return form;
}

/// A vector near x in the Hermitian form R' R of a factor R, whose first `whole` entries are points of the
/// lattice; the others are as is best for these.
Eigen::VectorXcd NearestPlanes(LatticeKind kind, Eigen::Index whole, const Eigen::MatrixXcd& r,
                               const Eigen::VectorXcd& x) {
  Eigen::VectorXcd nearest = x;
  for (Eigen::Index i = x.size() - 1; i >= 0; --i) {
    Complex wanted = x[i];
    for (Eigen::Index j = i + 1; j < x.size(); ++j)
      wanted += r(i, j) / r(i, i) * (x[j] - nearest[j]);
    nearest[i] = i < whole ? NearestOf(kind, wanted) : wanted;
  }
  return nearest;
}

/// The direction of the lattice, and the displacements of all sides onto it.
std::pair<Complex, Eigen::VectorXcd> NearestSides(LatticeKind kind, const FreeSides& free,
                                                  const SideForm& form) {
  double least = std::numeric_limits<double>::infinity();
  std::pair<Complex, Eigen::VectorXcd> best;
  for (int i = 0; i < kDirections; ++i) {
    const Complex turn = std::polar(1., 2 * kPi * i / (OrderOf(kind) * kDirections));
    const Eigen::VectorXcd wanted = turn * form.free;
    const Eigen::VectorXcd change = NearestPlanes(kind, free.whole, form.upper, wanted) - wanted;
    const double energy = (form.upper * change).squaredNorm();
    if (energy >= least) continue;
    least = energy;
    best = {turn, free.basis * change};
  }
  return best;
}

/// A harmonic displacement that is given at a point is steep around it. Faces that it strains much are
/// made stiffer until none is strained to a flip (D. Bommes, H. Zimmer, L. Kobbelt, "Mixed-integer
/// quadrangulation", 2009, Local Stiffening).
Status RelaxStrain(Complex turn, const Eigen::VectorXcd& sides, OpenedDomain* open,
                   Eigen::VectorXcd* shift) {
  constexpr int kMostRounds = 60;
  constexpr double kEnough = 0.9, kMuch = 0.3;
  for (int round = 0; round < kMostRounds; ++round) {
    const Eigen::VectorXd strain = open->Strain(turn, *shift);
    if (strain.maxCoeff() < kEnough) return Status();
    const Eigen::VectorXd factors =
        (strain.array() > kMuch).select(1 + strain.array().min(3.), 1.).matrix();
    if (Status s = open->Stiffen(factors); !s.ok()) return s;
    *shift = open->Displace(sides);
  }
  return Status();
}

Index FlippedFaces(const CornerUv& uv) {
  Index flipped = 0;
  for (std::size_t c = 0; c < uv.value.size(); c += 3) {
    const Point &p = uv.value[c], &q = uv.value[c + 1], &r = uv.value[c + 2];
    const double longest =
        std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
    flipped += Cross(p, q, r) > kLeastHeight * longest ? 0 : 1;
  }
  return flipped;
}

}  // namespace

StatusOr<LatticeMap> MakeLatticeMap(const FlatDomain& domain, LatticeKind kind, double cell,
                                    const Cut* cut) {
  if (!domain.loops().empty()) {
    return Status::InvalidInput(
        "lattices: a surface with a boundary, which no lattice is made to follow; leave it out");
  }
  OpenedDomain open(domain, OrderOf(kind));
  if (Status s = open.Open(cell, cut); !s.ok()) return s;
  const StatusOr<FreeSides> free = FindFreeSides(open, kind);
  if (!free.ok()) return free.status();
  const StatusOr<SideForm> form = FormOf(open, *free);
  if (!form.ok()) return form.status();
  const auto [turn, sides] = NearestSides(kind, *free, *form);
  Eigen::VectorXcd shift = open.Displace(sides);
  if (Status s = RelaxStrain(turn, sides, &open, &shift); !s.ok()) return s;
  LatticeMap map{open.Displaced(turn, shift), shift.cwiseAbs().maxCoeff()};
  if (const Index flipped = FlippedFaces(map.uv); flipped > 0) {
    return Status(
        StatusCode::kNotConverged,
        fmt::format("the lattice map: triangles would be flipped ({}) by bringing cones and "
                    "seams onto the lattice; ask for smaller cells, of shorter edges",
                    flipped));
  }
  return map;
}

}  // namespace cirque
