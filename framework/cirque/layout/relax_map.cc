#include "cirque/layout/relax_map.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

#include "cirque/core/grouping.h"
#include "cirque/core/parallel.h"
#include "cirque/layout/beltrami_system.h"
#include "cirque/layout/map_objective.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr double kOverrelaxation = 1.6;
constexpr int kHalvings = 4;         ///< of a vertex's step
constexpr double kLeastArea = 0.1;   ///< weight of a face in mean areas, as RefinePatchesOptions
constexpr double kLeadsBack = 1e-6;  ///< by how much the motions around a vertex may miss 1
constexpr Index kMostColours = 64;

Complex ToComplex(const Eigen::Vector2d& p) { return {p.x(), p.y()}; }

/// A face of the mesh with the given corners in space, its hats as BeltramiFace has them. Its weight
/// is its area.
BeltramiFace FlatFace(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                      const Eigen::Vector3d& c) {
  BeltramiFace face;
  const Eigen::Vector3d side = b - a, other = c - a;
  const double squared = side.squaredNorm(), doubled_area = side.cross(other).norm();
  face.weight = squared > 0 ? doubled_area / 2 : 0;
  if (!(face.weight > 0)) return face;
  const Complex apex = Complex(side.dot(other), doubled_area) / squared, i(0, 1);
  face.hat = {i * (apex - 1.0), -i * apex, i};
  return face;
}

/// The faces that are there, with a complex number for every image of a vertex. Vertices and faces
/// are numbered among those that are there.
class Relaxation {
 public:
  Relaxation(const std::vector<Eigen::Vector3d>& position, CollapsedMap* map) : map_(map) {
    NumberVertices(static_cast<Index>(position.size()));
    MeasureFaces(position);
    FindImages();
    Colour();
  }

  void Sweep() {
    for (Index colour = 0; colour + 1 < static_cast<Index>(coloured_.first.size()); ++colour) {
      const Index* const first = &coloured_.item[coloured_.first[colour]];
      ParallelFor(coloured_.first[colour + 1] - coloured_.first[colour],
                  [&](Index i) { Move(first[i]); });
    }
  }

  void Write() {
    ParallelFor(static_cast<Index>(id_.size()), [&](Index f) {
      for (Index k = 0; k < 3; ++k) {
        const Complex& z = z_[face_[f].vertex[k]];
        map_->uv.value[3 * id_[f] + k] = {z.real(), z.imag()};
      }
    });
  }

 private:
  void NumberVertices(Index count);
  void MeasureFaces(const std::vector<Eigen::Vector3d>& position);
  void FindImages();
  bool IsOnCut(Index vertex) const;
  void GoAround(Index vertex);
  std::vector<Index> CornersInOrder(Index vertex) const;
  void Colour();
  void Move(Index vertex);
  Complex Step(Index vertex) const;
  double Energy(Index vertex) const;
  bool KeepsOrientation(Index vertex) const;
  void Shift(Index vertex, Complex by);

  // Of a corner c = 3 f + k: its number in the map, the others of the face, and its edges to them.
  Index InMap(Index c) const { return 3 * id_[c / 3] + c % 3; }
  static Index Next(Index c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static Index Prev(Index c) { return c % 3 == 0 ? c + 2 : c - 1; }
  Complex Image(Index c) const { return ToComplex(map_->uv.value[InMap(c)]); }
  bool IsCutAfter(Index c) const { return map_->cut[InMap(Next(c))]; }   ///< the edge to Prev(c)
  bool IsCutBefore(Index c) const { return map_->cut[InMap(Prev(c))]; }  ///< the edge to Next(c)

  CollapsedMap* map_;
  const MapObjective objective_ = *MapObjectives().Find("mips");
  std::vector<Index> id_;           ///< of each face in the map
  std::vector<Index> vertex_;       ///< 3 per face
  Buckets corners_;                 ///< of each vertex
  std::vector<BeltramiFace> face_;  ///< `vertex`: images
  std::vector<Index> first_image_;  ///< of each vertex, and one more
  Eigen::VectorXcd z_;              ///< of each image
  std::vector<Complex> turn_;       ///< of each image, how it moves with the vertex's first
  std::vector<bool> held_;
  Buckets coloured_;  ///< vertices that move; no face has two of one colour
};

void Relaxation::NumberVertices(Index count) {
  std::vector<Index> number(count, kNone);
  Index vertices = 0;
  for (std::size_t f = 0; f < map_->there.size(); ++f) {
    if (!map_->there[f]) continue;
    id_.push_back(static_cast<Index>(f));
    for (const Index v : map_->corner[f]) {
      if (number[v] == kNone) number[v] = vertices++;
      vertex_.push_back(number[v]);
    }
  }
  corners_ = SortIntoBuckets(vertex_, vertices);
  held_.assign(vertices, false);
}

void Relaxation::MeasureFaces(const std::vector<Eigen::Vector3d>& position) {
  face_.resize(id_.size());
  ParallelFor(static_cast<Index>(id_.size()), [&](Index f) {
    const auto& corner = map_->corner[id_[f]];
    face_[f] = FlatFace(position[corner[0]], position[corner[1]], position[corner[2]]);
  });
  double area = 0;
  for (const BeltramiFace& face : face_) area += face.weight;
  const double mean = area / static_cast<double>(face_.size());
  for (BeltramiFace& face : face_) {
    if (face.weight > 0) face.weight = std::max(face.weight / mean, kLeastArea);
  }
}

bool Relaxation::IsOnCut(Index vertex) const {
  for (Index i = corners_.first[vertex]; i < corners_.first[vertex + 1]; ++i) {
    if (IsCutAfter(corners_.item[i]) || IsCutBefore(corners_.item[i])) return true;
  }
  return false;
}

/// The corners at a vertex counter-clockwise, of one on the boundary from side to side, else from a
/// cut edge on.
std::vector<Index> Relaxation::CornersInOrder(Index vertex) const {
  std::vector<std::pair<Index, Index>> before;  // each with the vertex before it
  for (Index i = corners_.first[vertex]; i < corners_.first[vertex + 1]; ++i) {
    before.emplace_back(vertex_[Next(corners_.item[i])], corners_.item[i]);
  }
  std::sort(before.begin(), before.end());
  const auto from = [&](Index v) {
    const auto at = std::lower_bound(before.begin(), before.end(), std::pair(v, Index{0}));
    return at == before.end() || at->first != v ? kNone : at->second;
  };
  std::vector<bool> follows(before.size(), false);
  Index first = kNone;
  for (const auto& entry : before) {
    const Index after = from(vertex_[Prev(entry.second)]);
    if (after == kNone) continue;
    const auto at =
        std::lower_bound(before.begin(), before.end(), std::pair(vertex_[Next(after)], Index{0}));
    follows[at - before.begin()] = true;
    if (IsCutBefore(after)) first = after;
  }
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (!follows[k]) first = before[k].second;
  }
  std::vector<Index> order;
  for (Index c = first; c != kNone && order.size() < before.size(); c = from(vertex_[Prev(c)])) {
    order.push_back(c);
  }
  return order;
}

/// A new image behind every cut edge.
void Relaxation::GoAround(Index vertex) {
  const std::vector<Index> corners = CornersInOrder(vertex);
  const auto across = [&](Index c, Index d) {
    return (Image(Next(d)) - Image(d)) / (Image(Prev(c)) - Image(c));
  };
  Complex turn = 1;
  turn_.push_back(turn);
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (k > 0 && IsCutAfter(corners[k - 1])) {
      turn *= across(corners[k - 1], corners[k]);
      turn_.push_back(turn);
    }
    face_[corners[k] / 3].vertex[corners[k] % 3] = static_cast<Index>(turn_.size()) - 1;
  }
  const bool closed = vertex_[Prev(corners.back())] == vertex_[Next(corners.front())];
  held_[vertex] =
      closed && !(std::abs(turn * across(corners.back(), corners.front()) - 1.0) < kLeadsBack);
}

void Relaxation::FindImages() {
  std::vector<Complex> z;
  const auto vertices = static_cast<Index>(held_.size());
  for (Index v = 0; v < vertices; ++v) {
    first_image_.push_back(static_cast<Index>(turn_.size()));
    if (IsOnCut(v)) {
      GoAround(v);
    } else {
      turn_.push_back(1);
      for (Index i = corners_.first[v]; i < corners_.first[v + 1]; ++i) {
        face_[corners_.item[i] / 3].vertex[corners_.item[i] % 3] = first_image_[v];
      }
    }
  }
  first_image_.push_back(static_cast<Index>(turn_.size()));
  z_.resize(static_cast<Eigen::Index>(turn_.size()));
  for (Index c = 0; c < static_cast<Index>(vertex_.size()); ++c) {
    z_[face_[c / 3].vertex[c % 3]] = Image(c);
  }
}

/// Each vertex gets the least colour that no neighbour has; those that stay get none.
void Relaxation::Colour() {
  const auto vertices = static_cast<Index>(held_.size());
  std::vector<Index> colour(vertices, kMostColours);
  std::vector<Index> moving;
  Index most = 0;
  for (Index v = 0; v < vertices; ++v) {
    std::uint64_t taken = 0;
    for (Index i = corners_.first[v]; i < corners_.first[v + 1]; ++i) {
      for (const Index c : {Next(corners_.item[i]), Prev(corners_.item[i])}) {
        const Index of = colour[vertex_[c]];
        if (of < kMostColours) taken |= std::uint64_t{1} << of;
      }
    }
    const auto least = static_cast<Index>(std::countr_one(taken));
    if (held_[v] || least == kMostColours) continue;
    colour[v] = least;
    most = std::max(most, least + 1);
    moving.push_back(v);
  }
  coloured_ = SortIntoBuckets(colour, most, moving);
}

/// Infinite where a face is none any more.
double Relaxation::Energy(Index vertex) const {
  double energy = 0;
  for (Index i = corners_.first[vertex]; i < corners_.first[vertex + 1]; ++i) {
    const BeltramiFace& face = face_[corners_.item[i] / 3];
    if (!(face.weight > 0)) continue;
    const double m_squared = SquaredBeltrami(face, z_);
    if (!(m_squared < 1)) return std::numeric_limits<double>::infinity();
    energy += face.weight * objective_.value(m_squared);
  }
  return energy;
}

bool Relaxation::KeepsOrientation(Index vertex) const {
  const auto at = [&](Index image) { return Eigen::Vector2d(z_[image].real(), z_[image].imag()); };
  for (Index i = corners_.first[vertex]; i < corners_.first[vertex + 1]; ++i) {
    const auto& v = face_[corners_.item[i] / 3].vertex;
    if (OrientationSign(at(v[0]), at(v[1]), at(v[2])) <= 0) return false;
  }
  return true;
}

/// The Gauss-Newton step of the star, of the vertex's first image.
Complex Relaxation::Step(Index vertex) const {
  Complex force = 0;
  double stiffness = 0;
  for (Index i = corners_.first[vertex]; i < corners_.first[vertex + 1]; ++i) {
    const Index k = corners_.item[i] % 3;
    const BeltramiFace& face = face_[corners_.item[i] / 3];
    if (!(face.weight > 0)) continue;
    const Complex origin = z_[face.vertex[k]];
    const Complex p = z_[face.vertex[Next(k)]] - origin, q = z_[face.vertex[Prev(k)]] - origin;
    const Complex &hat_p = face.hat[Next(k)], &hat_q = face.hat[Prev(k)];
    const Complex f_z = p * std::conj(hat_p) + q * std::conj(hat_q);
    const Complex inverse = std::conj(f_z) / std::norm(f_z);
    const Complex mu = (p * hat_p + q * hat_q) * inverse;
    const Complex slope =
        (face.hat[k] - mu * std::conj(face.hat[k])) * inverse * turn_[face.vertex[k]];
    const double weight = face.weight * objective_.weight(std::norm(mu));
    force += weight * std::conj(slope) * mu;
    stiffness += weight * std::norm(slope);
  }
  return -force / stiffness;
}

void Relaxation::Shift(Index vertex, Complex by) {
  for (Index i = first_image_[vertex]; i < first_image_[vertex + 1]; ++i) z_[i] += turn_[i] * by;
}

void Relaxation::Move(Index vertex) {
  Complex step = kOverrelaxation * Step(vertex);
  const Index first = first_image_[vertex], count = first_image_[vertex + 1] - first;
  const double before = Energy(vertex);
  const Complex kept = z_[first];
  const Eigen::VectorXcd others = count > 1 ? z_.segment(first, count) : Eigen::VectorXcd();
  for (int halving = 0; halving <= kHalvings && std::isfinite(std::norm(step)); ++halving) {
    Shift(vertex, step);
    if (Energy(vertex) < before && KeepsOrientation(vertex)) return;
    z_[first] = kept;
    if (count > 1) z_.segment(first, count) = others;
    step /= 2;
  }
}

}  // namespace

void RelaxMap(const std::vector<Eigen::Vector3d>& position, int sweeps,
              const std::atomic<bool>* cancelled, CollapsedMap* map) {
  if (sweeps == 0) return;
  Relaxation relaxation(position, map);
  for (int sweep = 0; sweep < sweeps && !(cancelled && *cancelled); ++sweep) relaxation.Sweep();
  relaxation.Write();
}

}  // namespace cirque
