#include "cirque/lattice/opened_domain.h"

#include <algorithm>
#include <cmath>

#include "cirque/cuts/cut_graph.h"
#include "cirque/layout/planar_layout.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;
using Point = Eigen::Vector2d;

constexpr double kRotationTolerance = 1e-6;  ///< [rad]

Complex ToComplex(const Point& p) { return {p.x(), p.y()}; }

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

}  // namespace

Status OpenedDomain::Open(double cell, const Cut* given) {
  std::vector<Index> cones;
  for (Index v = 0; v < t_.num_vertices; ++v) {
    if (domain_.IsCone(v)) cones.push_back(v);
  }
  const EdgeLengths lengths = LengthsOf(domain_);
  const CornerAngles angles = AnglesOf(domain_);
  const StatusOr<Cut> cut = given ? *given : CutGraph(t_, lengths.value, cones);
  if (!cut.ok()) return cut.status();
  open_ = CutOpen(t_, *cut);
  uv_ = LayOutPatches(t_, angles, lengths, *cut).uv;
  for (Point& p : uv_.value) p /= cell;
  const SeamReport report = MeasureSeams(t_, *cut, cones, angles, uv_);
  const auto multiples = IntegerRotations(t_, report, order_, kRotationTolerance);
  if (!multiples.ok()) return multiples.status();
  SnapSeams(t_, *cut, report, *multiples, order_, &uv_);
  seams_ = report.seams;
  for (const int multiple : *multiples) turn_.push_back(TurnBy(multiple, order_));
  WalkRound();
  NumberUnknowns();
  stiffness_.setOnes(t_.num_faces());
  return Factorize();
}

Status OpenedDomain::Stiffen(const Eigen::VectorXd& factors) {
  stiffness_.array() *= factors.array();
  return Factorize();
}

Eigen::VectorXd OpenedDomain::Strain(Complex turn, const Eigen::VectorXcd& shift) const {
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

std::complex<double> OpenedDomain::Side(Index p) const {
  const std::vector<Index>& path = seams_[p].halfedges;
  return ToComplex(uv_.value[Triangulation::Prev(path.back())]) -
         ToComplex(uv_.value[Triangulation::Next(path.front())]);
}

Eigen::MatrixXcd OpenedDomain::FreeNodes(std::vector<bool>* reached) const {
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

Eigen::VectorXcd OpenedDomain::Displace(const Eigen::VectorXcd& sides) const {
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

Eigen::VectorXcd OpenedDomain::Laplacian(const Eigen::VectorXcd& b) const {
  Eigen::VectorXcd product = Eigen::VectorXcd::Zero(b.size());
  ForEachSide([&](Index i, Index j, double weight) {
    const Complex flow = weight * (b[i] - b[j]);
    product[i] += flow;
    product[j] -= flow;
  });
  return product;
}

CornerUv OpenedDomain::Displaced(Complex turn, const Eigen::VectorXcd& shift) const {
  CornerUv uv = uv_;
  const Complex origin = ToComplex(uv_.value[first_corner_]);
  for (Index c = 0; c < t_.num_halfedges(); ++c) {
    const Complex z = turn * (ToComplex(uv_.value[c]) - origin) + shift[open_.vertex[c]];
    uv.value[c] = {z.real(), z.imag()};
  }
  return uv;
}

std::vector<Index> OpenedDomain::ReachNodes(std::vector<bool> is_there,
                                            std::vector<bool>* reached) const {
  reached->assign(num_sides(), false);
  std::vector<Index> nodes;
  for (bool again = true; again;) {
    again = false;
    for (Index p = 0; p < num_sides(); ++p) {
      const Index a = t_.Tail(seams_[p].halfedges.front()), b = t_.Tip(seams_[p].halfedges.back());
      if (is_there[a] == is_there[b]) continue;
      nodes.push_back(is_there[a] ? b : a);
      is_there[nodes.back()] = again = true;
      (*reached)[p] = true;
    }
  }
  return nodes;
}

std::vector<std::complex<double>> OpenedDomain::TurnsOfCopies() const {
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

void OpenedDomain::WalkRound() {
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

void OpenedDomain::SetNodes(const Eigen::VectorXcd& sides, Eigen::VectorXcd* given) const {
  Complex at = 0;
  for (const Run& run : runs_) {
    (*given)[run.from] = at;
    at += run.is_left ? sides[run.side] : -turn_[run.side] * sides[run.side];
  }
}

void OpenedDomain::SetTranslations(Eigen::VectorXcd* given) const {
  for (Index p = 0; p < num_sides(); ++p) {
    const std::vector<Index>& path = seams_[p].halfedges;
    const Index begin = path.front();
    const Complex translation =
        (*given)[open_.Tip(t_.twin[begin])] - turn_[p] * (*given)[open_.Tail(begin)];
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
      (*given)[open_.Tail(t_.twin[path[i]])] = translation;
  }
}

void OpenedDomain::NumberUnknowns() {
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

Status OpenedDomain::Factorize() {
  if (num_unknowns_ == 0 || cholesky_.Factorize(Matrix())) return Status();
  return {StatusCode::kNotConverged, "the lattice map's Laplacian is not positive"};
}

ComplexSparseMatrix OpenedDomain::Matrix() const {
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

}  // namespace cirque
