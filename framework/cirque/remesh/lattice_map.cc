#include "cirque/remesh/lattice_map.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <fmt/format.h>

#include "cirque/cuts/cut_graph.h"
#include "cirque/layout/planar_layout.h"
#include "cirque/layout/seams.h"
#include "cirque/linear/hermitian_cholesky.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;
using Point = Eigen::Vector2d;

constexpr double kRotationTolerance = 1e-6;  ///< [rad]
constexpr int kDirections = 24;
constexpr double kLeastHeight = 1e-6;  ///< of triangles, as a part of their longest side

Complex ToComplex(const Point& p) { return {p.x(), p.y()}; }

Complex NearestOf(LatticeKind kind, Complex z) {
  const Point nearest = NearestInLattice(kind, {z.real(), z.imag()});
  return {nearest.x(), nearest.y()};
}

/// exp(i multiple 2 pi / order), right angles without rounding.
Complex TurnBy(int multiple, int order) {
  const int k = ((multiple % order) + order) % order;
  if (4 * k % order == 0) {
    constexpr Complex kQuarters[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    return kQuarters[4 * k / order];
  }
  return std::polar(1., 2 * kPi * k / order);
}

CornerAngles AnglesOf(const FlatDomain& domain) {
  CornerAngles angles{Eigen::VectorXd(domain.triangulation().num_halfedges())};
  for (Index c = 0; c < domain.triangulation().num_halfedges(); ++c) {
    const Point a = domain.Corner(Triangulation::Next(c)) - domain.Corner(c);
    const Point b = domain.Corner(Triangulation::Prev(c)) - domain.Corner(c);
    angles.value[c] = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return angles;
}

EdgeLengths LengthsOf(const FlatDomain& domain) {
  const Triangulation& t = domain.triangulation();
  EdgeLengths lengths{Eigen::VectorXd(t.num_edges())};
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    lengths.value[e] =
        (domain.Corner(Triangulation::Next(h)) - domain.Corner(Triangulation::Prev(h))).norm();
  }
  return lengths;
}

/// A flat domain opened to a disk, with what displacements across its seams obey.
class OpenedDomain {
 public:
  OpenedDomain(const FlatDomain& domain, LatticeKind kind)
      : domain_(domain), t_(domain.triangulation()), kind_(kind) {}

  Status Open(double cell) {
    std::vector<Index> cones;
    for (Index v = 0; v < t_.num_vertices; ++v) {
      if (domain_.IsCone(v)) cones.push_back(v);
    }
    const EdgeLengths lengths = LengthsOf(domain_);
    const CornerAngles angles = AnglesOf(domain_);
    const StatusOr<Cut> cut = CutGraph(t_, lengths.value, cones);
    if (!cut.ok()) return cut.status();
    open_ = CutOpen(t_, *cut);
    uv_ = LayOutPatches(t_, angles, lengths, *cut).uv;
    for (Point& p : uv_.value) p /= cell;
    const SeamReport report = MeasureSeams(t_, *cut, cones, angles, uv_);
    const auto multiples = IntegerRotations(t_, report, OrderOf(kind_), kRotationTolerance);
    if (!multiples.ok()) return multiples.status();
    SnapSeams(t_, *cut, report, *multiples, OrderOf(kind_), &uv_);
    seams_ = report.seams;
    for (const int multiple : *multiples) turn_.push_back(TurnBy(multiple, OrderOf(kind_)));
    WalkRound();
    NumberUnknowns();
    stiffness_.setOnes(t_.num_faces());
    return Factorize();
  }

  /// Makes faces stiffer, each by its factor.
  Status Stiffen(const Eigen::VectorXd& factors) {
    stiffness_.array() *= factors.array();
    return Factorize();
  }

  /// How far a displacement is from a translation on every face, the sum of the moduli of its complex
  /// derivatives: below 1 the face is not flipped.
  Eigen::VectorXd Strain(Complex turn, const Eigen::VectorXcd& shift) const {
    Eigen::VectorXd strain(t_.num_faces());
    for (Index c = 0; c < t_.num_halfedges(); c += 3) {
      const auto edge = [&](Index k) {
        return turn * (ToComplex(uv_.value[c + k]) - ToComplex(uv_.value[c]));
      };
      const auto change = [&](Index k) {
        return shift[open_.vertex[c + k]] - shift[open_.vertex[c]];
      };
      // d = a z + b conj(z) on both sides.
      const Complex z = edge(1), w = edge(2), dz = change(1), dw = change(2);
      const Complex area = z * std::conj(w) - w * std::conj(z);
      const Complex a = (dz * std::conj(w) - dw * std::conj(z)) / area;
      const Complex b = (z * dw - w * dz) / area;
      strain[c / 3] = std::abs(a) + std::abs(b);
    }
    return strain;
  }

  Index num_sides() const { return static_cast<Index>(seams_.size()); }
  const Complex& Turn(Index side) const { return turn_[side]; }

  /// The side of the cut graph as it lies in the plane.
  Complex Side(Index p) const {
    const std::vector<Index>& path = seams_[p].halfedges;
    return ToComplex(uv_.value[Triangulation::Prev(path.back())]) -
           ToComplex(uv_.value[Triangulation::Next(path.front())]);
  }

  /// How the sides change with the places of nodes that are no cones (nor the first, where there are
  /// no cones), a column each; `reached` gets, for each of these nodes, the side by which a tree from
  /// the cones comes to it.
  Eigen::MatrixXcd FreeNodes(std::vector<bool>* reached) const {
    std::vector<bool> is_root(t_.num_vertices, false);
    for (Index v = 0; v < t_.num_vertices; ++v) is_root[v] = domain_.IsCone(v);
    is_root[t_.vertex[first_corner_]] = true;
    const std::vector<Index> nodes = ReachNodes(is_root, reached);
    const std::vector<Complex> turned = TurnsOfCopies();
    std::vector<Index> column(t_.num_vertices, kNone);
    for (std::size_t i = 0; i < nodes.size(); ++i) column[nodes[i]] = static_cast<Index>(i);
    Eigen::MatrixXcd changes =
        Eigen::MatrixXcd::Zero(num_sides(), static_cast<Eigen::Index>(nodes.size()));
    for (Index p = 0; p < num_sides(); ++p) {
      const Index from = seams_[p].halfedges.front(), to = seams_[p].halfedges.back();
      if (column[t_.Tail(from)] != kNone)
        changes(p, column[t_.Tail(from)]) -= turned[open_.Tail(from)];
      if (column[t_.Tip(to)] != kNone) changes(p, column[t_.Tip(to)]) += turned[open_.Tip(to)];
    }
    return changes;
  }

  /// The displacement of least energy of all copies of vertices whose sides are displaced by these,
  /// which close.
  Eigen::VectorXcd Displace(const Eigen::VectorXcd& sides) const {
    Eigen::VectorXcd given = Eigen::VectorXcd::Zero(open_.num_vertices);
    SetNodes(sides, &given);
    SetTranslations(&given);
    const auto unknowns = static_cast<Eigen::Index>(num_unknowns_);
    Eigen::VectorXcd right = Eigen::VectorXcd::Zero(unknowns);
    ForEachSide([&](Index a, Index b, double weight) {
      const Complex jump = weight * (given[a] - given[b]);
      if (unknown_[a] != kNone) right[unknown_[a]] -= std::conj(factor_[a]) * jump;
      if (unknown_[b] != kNone) right[unknown_[b]] += std::conj(factor_[b]) * jump;
    });
    if (num_unknowns_ == 0) return given;
    const Eigen::VectorXcd found = cholesky_.Solve(right);
    for (Index c = 0; c < open_.num_vertices; ++c) {
      if (unknown_[c] != kNone) given[c] += factor_[c] * found[unknown_[c]];
    }
    return given;
  }

  /// The Hermitian product whose square is the Dirichlet energy: L b, of which it is a' L b.
  Eigen::VectorXcd Laplacian(const Eigen::VectorXcd& b) const {
    Eigen::VectorXcd product = Eigen::VectorXcd::Zero(b.size());
    ForEachSide([&](Index i, Index j, double weight) {
      const Complex flow = weight * (b[i] - b[j]);
      product[i] += flow;
      product[j] -= flow;
    });
    return product;
  }

  /// The layout turned, with a node at 0, and displaced.
  CornerUv Displaced(Complex turn, const Eigen::VectorXcd& shift) const {
    CornerUv uv = uv_;
    const Complex origin = ToComplex(uv_.value[first_corner_]);
    for (Index c = 0; c < t_.num_halfedges(); ++c) {
      const Complex z = turn * (ToComplex(uv_.value[c]) - origin) + shift[open_.vertex[c]];
      uv.value[c] = {z.real(), z.imag()};
    }
    return uv;
  }

 private:
  /// A run of halfedges of the disk's boundary: a side of the cut graph, forwards on its left,
  /// backwards on its right.
  struct Run {
    Index side;
    bool is_left;
    Index from, to;  ///< copies of vertices
  };

  /// Calls visit(tail, tip, weight), copies of vertices, for every halfedge: E = sum of weight
  /// |difference|^2.
  template <class Visit>
  void ForEachSide(const Visit& visit) const {
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      const Point a = domain_.Corner(Triangulation::Next(h)) - domain_.Corner(h);
      const Point b = domain_.Corner(Triangulation::Prev(h)) - domain_.Corner(h);
      const double cotangent = a.dot(b) / (a.x() * b.y() - a.y() * b.x());
      visit(open_.Tail(h), open_.Tip(h), stiffness_[h / 3] * cotangent / 2);
    }
  }

  /// The nodes that are not there yet, in the order in which sides come to them.
  std::vector<Index> ReachNodes(std::vector<bool> is_there, std::vector<bool>* reached) const {
    reached->assign(num_sides(), false);
    std::vector<Index> nodes;
    for (bool again = true; again;) {
      again = false;
      for (Index p = 0; p < num_sides(); ++p) {
        const Index a = t_.Tail(seams_[p].halfedges.front()),
                    b = t_.Tip(seams_[p].halfedges.back());
        if (is_there[a] == is_there[b]) continue;
        nodes.push_back(is_there[a] ? b : a);
        is_there[nodes.back()] = again = true;
        (*reached)[p] = true;
      }
    }
    return nodes;
  }

  /// By how much the frame at a copy of a node is turned against that at its first one. (About cones
  /// they do not agree, and are not asked for.)
  std::vector<Complex> TurnsOfCopies() const {
    std::vector<Complex> turned(open_.num_vertices, 0);
    std::vector<bool> has_first(t_.num_vertices, false);
    for (bool again = true; again;) {
      again = false;
      const auto join = [&](Index left, Index right, Complex turn) {
        if ((turned[left] == 0.) == (turned[right] == 0.)) return;
        if (turned[right] == 0.) turned[right] = turn * turned[left];
        if (turned[left] == 0.) turned[left] = std::conj(turn) * turned[right];
        again = true;
      };
      for (Index p = 0; p < num_sides(); ++p) {
        const Index from = seams_[p].halfedges.front(), to = seams_[p].halfedges.back();
        for (const auto& [node, copy] :
             {std::pair(t_.Tail(from), open_.Tail(from)), std::pair(t_.Tip(to), open_.Tip(to))}) {
          if (has_first[node]) continue;
          has_first[node] = again = true;
          turned[copy] = 1;
        }
        join(open_.Tail(from), open_.Tip(t_.twin[from]), turn_[p]);
        join(open_.Tip(to), open_.Tail(t_.twin[to]), turn_[p]);
      }
    }
    return turned;
  }

  void WalkRound() {
    std::vector<Index> begins(t_.num_halfedges(), kNone);
    std::vector<bool> is_left(t_.num_halfedges(), false);
    for (Index p = 0; p < num_sides(); ++p) {
      begins[seams_[p].halfedges.front()] = p;
      is_left[seams_[p].halfedges.front()] = true;
      begins[t_.twin[seams_[p].halfedges.back()]] = p;
    }
    const std::vector<std::vector<Index>> loops = BoundaryLoops(open_);
    if (loops.empty()) return;
    const std::vector<Index>& loop = loops[0];
    const auto is_begin = [&](Index h) { return begins[h] != kNone; };
    const auto is_at_cone = [&](Index h) { return is_begin(h) && domain_.IsCone(t_.Tail(h)); };
    auto start = std::find_if(loop.begin(), loop.end(), is_at_cone);
    if (start == loop.end()) start = std::find_if(loop.begin(), loop.end(), is_begin);
    const std::ptrdiff_t first = start - loop.begin();
    first_corner_ = Triangulation::Next(loop[first]);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index h = loop[(first + i) % loop.size()];
      if (is_begin(h)) runs_.push_back({begins[h], is_left[h], open_.Tail(h), kNone});
      runs_.back().to = open_.Tip(h);
    }
  }

  void SetNodes(const Eigen::VectorXcd& sides, Eigen::VectorXcd* given) const {
    Complex at = 0;
    for (const Run& run : runs_) {
      (*given)[run.from] = at;
      at += run.is_left ? sides[run.side] : -turn_[run.side] * sides[run.side];
    }
  }

  /// Of the copies on the right of seams, which are where their left ones are taken.
  void SetTranslations(Eigen::VectorXcd* given) const {
    for (Index p = 0; p < num_sides(); ++p) {
      const std::vector<Index>& path = seams_[p].halfedges;
      const Index begin = path.front();
      const Complex translation =
          (*given)[open_.Tip(t_.twin[begin])] - turn_[p] * (*given)[open_.Tail(begin)];
      for (std::size_t i = 0; i + 1 < path.size(); ++i)
        (*given)[open_.Tail(t_.twin[path[i]])] = translation;
    }
  }

  void NumberUnknowns() {
    unknown_.assign(open_.num_vertices, kNone);
    factor_.assign(open_.num_vertices, 1);
    std::vector<bool> is_given(open_.num_vertices, false);
    for (const Run& run : runs_) is_given[run.from] = true;
    for (const Seam& seam : seams_) {
      for (std::size_t i = 0; i + 1 < seam.halfedges.size(); ++i)
        is_given[open_.Tail(t_.twin[seam.halfedges[i]])] = true;  // for now: by its left copy
    }
    for (Index c = 0; c < open_.num_vertices; ++c) {
      if (!is_given[c]) unknown_[c] = num_unknowns_++;
    }
    for (Index p = 0; p < num_sides(); ++p) {
      const std::vector<Index>& path = seams_[p].halfedges;
      for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const Index right = open_.Tail(t_.twin[path[i]]);
        unknown_[right] = unknown_[open_.Tip(path[i])];
        factor_[right] = turn_[p];
      }
    }
  }

  Status Factorize() {
    if (num_unknowns_ == 0 || cholesky_.Factorize(Matrix())) return Status();
    return {StatusCode::kNotConverged, "the lattice map's Laplacian is not positive"};
  }

  ComplexSparseMatrix Matrix() const {
    std::vector<Eigen::Triplet<Complex>> entries;
    const auto add = [&entries](Index row, Index column, Complex value) {
      if (row >= column) entries.emplace_back(row, column, value);
    };
    ForEachSide([&](Index a, Index b, double weight) {
      const Index i = unknown_[a], j = unknown_[b];
      if (i != kNone) add(i, i, weight);
      if (j != kNone) add(j, j, weight);
      if (i == kNone || j == kNone) return;
      const Complex coupling = -weight * std::conj(factor_[a]) * factor_[b];
      if (i == j) {
        add(i, i, 2 * coupling.real());
      } else {
        add(i, j, coupling);
        add(j, i, std::conj(coupling));
      }
    });
    ComplexSparseMatrix matrix(num_unknowns_, num_unknowns_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  const FlatDomain& domain_;
  const Triangulation& t_;
  LatticeKind kind_;
  Triangulation open_;
  CornerUv uv_;  ///< in cells
  std::vector<Seam> seams_;
  std::vector<Complex> turn_;  ///< of every seam
  std::vector<Run> runs_;
  Index first_corner_ = 0;
  // The displacement of a copy c is factor[c] times that of unknown[c], and what is given.
  std::vector<Index> unknown_;
  std::vector<Complex> factor_;
  Index num_unknowns_ = 0;
  HermitianCholesky cholesky_;
  Eigen::VectorXd stiffness_;  ///< F: factors on the energy
};

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

/// Vectors near x in the Hermitian form of this factor, R' R, whose entries are of the lattice...
/// But for the first `whole` entries, which are, all are as is best.
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

int OrderOf(LatticeKind kind) { return kind == LatticeKind::kSquares ? 4 : 6; }

Point NearestInLattice(LatticeKind kind, const Point& point) {
  if (kind == LatticeKind::kSquares) return {std::round(point.x()), std::round(point.y())};
  const double height = std::sqrt(3.) / 2;
  const double row = std::floor(point.y() / height);
  Point nearest(0, 0);
  double least = std::numeric_limits<double>::infinity();
  for (const double j : {row, row + 1}) {
    const double shift = j / 2;
    const Point near(std::round(point.x() - shift) + shift, j * height);
    if ((near - point).squaredNorm() >= least) continue;
    least = (near - point).squaredNorm();
    nearest = near;
  }
  return nearest;
}

StatusOr<LatticeMap> MakeLatticeMap(const FlatDomain& domain, LatticeKind kind, double cell) {
  if (!domain.loops().empty()) {
    return Status::InvalidInput(
        "lattices: a surface with a boundary, which no lattice is made to follow; leave it out");
  }
  OpenedDomain open(domain, kind);
  if (Status s = open.Open(cell); !s.ok()) return s;
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
        fmt::format("the lattice map: {} triangles would be flipped by bringing cones and "
                    "seams onto the lattice; ask for shorter edges",
                    flipped));
  }
  return map;
}

}  // namespace cirque
