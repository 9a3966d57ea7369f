#include "cirque/layout/opened_map.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numeric>
#include <utility>

#include "cirque/core/parallel.h"
#include "cirque/math/elementary.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

/// Of the image's diameter: an opened edge this long can be held congruent to nine digits.
constexpr double kShortestSeamEdge = 1e-7;

constexpr double kSameScale = 1e-12;  ///< what differs by less is left as it is

/// Vertices in increasing order, each with its gradient.
BeltramiFace Ordered(BeltramiFace face) {
  const auto order = [&](int k, int l) {
    if (face.vertex[k] <= face.vertex[l]) return;
    std::swap(face.vertex[k], face.vertex[l]);
    std::swap(face.hat[k], face.hat[l]);
  };
  order(0, 1), order(1, 2), order(0, 1);
  return face;
}

double Diameter(const Eigen::VectorXcd& z) {
  const auto span = [](const Eigen::VectorXd& x) { return x.maxCoeff() - x.minCoeff(); };
  return z.size() == 0 ? 0 : std::hypot(span(z.real()), span(z.imag()));
}

}  // namespace

std::vector<SeamConstraint> SeamConstraints(const Triangulation& t, const Triangulation& open,
                                            const std::vector<Seam>& seams) {
  std::vector<SeamConstraint> constraints;
  for (const Seam& seam : seams) {
    const Complex rotation = std::polar(1.0, seam.rotation);
    for (const Index h : seam.halfedges) {
      const Index twin = t.twin[h];
      // The twin runs the other way: its tail lies across from h's tip.
      constraints.push_back({{open.Tail(twin), open.Tip(twin), open.Tip(h), open.Tail(h)},
                             {1.0, -1.0, -rotation, rotation},
                             Triangulation::Face(h),
                             Triangulation::Face(twin)});
    }
  }
  return constraints;
}

OpenedMap::OpenedMap(const SeamedSurface& of, const CornerUv& uv, double least_area)
    : open_(CutOpen(of.surface.triangulation, of.cut)),
      seams_(SeamConstraints(of.surface.triangulation, open_, of.seams)),
      z_(open_.num_vertices),
      injective_(of.injective),
      number_(open_.num_vertices, kNone) {
  for (Index c = 0; c < open_.num_halfedges(); ++c) {
    z_[open_.vertex[c]] = {uv.value[c].x(), uv.value[c].y()};
  }
  area_before_ = ImageArea();
  MeasureFaces(of.surface, least_area);
  Hold(of);
  LayRails(of);
}

void OpenedMap::MeasureFaces(const IntrinsicSurface& surface, double least_area) {
  const Eigen::VectorXd& angle = surface.angles.value;
  const auto length = [&](Index h) { return surface.lengths.value[surface.triangulation.edge[h]]; };
  faces_.resize(open_.num_faces());
  area_.resize(faces_.size(), 0);
  ParallelFor(open_.num_faces(), [&](Index f) {
    const Index h = 3 * f;
    const double sine = SineToPi(angle[h]), across = SineToPi(angle[h + 2]);
    const double area = length(h + 1) * length(h + 2) * sine / 2;
    BeltramiFace& face = faces_[f];
    face.vertex = {open_.vertex[h], open_.vertex[h + 1], open_.vertex[h + 2]};
    if (!(area > 0 && across > 0)) return;
    // The face with its first edge from 0 to 1.
    const Complex apex = SineToPi(angle[h + 1]) / across * Complex(std::cos(angle[h]), sine);
    const Complex i(0, 1);
    face.hat = {i * (apex - 1.0), -i * apex, i};
    face.scale = length(h + 2) / (4 * area);
    if (SquaredBeltrami(face, z_) < 1) area_[f] = area;
  });
  const double total = std::accumulate(area_.begin(), area_.end(), 0.0);
  double weights = 0;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    area_[f] /= total;
    faces_[f].scale *= std::sqrt(total);
    const double least = least_area / static_cast<double>(faces_.size());
    faces_[f].weight = area_[f] > 0 ? std::max(area_[f], least) : 0;
    weights += faces_[f].weight;
  }
  for (BeltramiFace& face : faces_) face.weight /= weights;
}

void OpenedMap::Hold(const SeamedSurface& of) {
  const Triangulation& t = of.surface.triangulation;
  std::vector<bool> held = of.held;
  has_place_ = of.has_place || std::find(held.begin(), held.end(), true) != held.end();
  held.resize(t.num_vertices, false);
  const double shortest = kShortestSeamEdge * Diameter(z_);
  for (const Seam& seam : of.seams) {
    for (const Index h : seam.halfedges) {
      if (std::abs(z_[open_.Tip(h)] - z_[open_.Tail(h)]) >= shortest) continue;
      held[t.Tip(h)] = held[t.Tail(h)] = short_seams_ = true;
    }
  }
  held_.resize(open_.num_vertices);
  for (Index c = 0; c < t.num_halfedges(); ++c) held_[open_.vertex[c]] = held[t.vertex[c]];
}

/// Vertices without seams are those of the surface. One that does not lie on its rail as the
/// boundary runs there stays.
void OpenedMap::LayRails(const SeamedSurface& of) {
  rail_of_.assign(open_.num_vertices, kNone);
  const std::vector<bool>& slides = of.sliding.slides;
  if (std::find(slides.begin(), slides.end(), true) == slides.end()) return;
  has_place_ = true;
  std::vector<bool> wanted(open_.num_vertices, false);
  for (Index c = 0; c < open_.num_halfedges(); ++c) {
    const Index v = of.surface.triangulation.vertex[c];
    wanted[open_.vertex[c]] = slides[v] && !held_[open_.vertex[c]];
  }
  const auto rail = [&](Index v) {
    return Rail{v, of.sliding.direction.empty() ? Complex(0) : of.sliding.direction[v]};
  };
  std::vector<bool> runs = wanted;
  for (Index h = 0; h < open_.num_halfedges(); ++h) {
    if (open_.twin[h] != kNone) continue;
    for (const Index v : {open_.Tail(h), open_.Tip(h)}) {
      if (!wanted[v]) continue;
      const RimEdge edge{open_.Tail(h), open_.Tip(h), rail(v).direction};
      if (!of.seams.empty() || !edge.RunsBetween(z_[edge.tail], z_[edge.tip])) runs[v] = false;
    }
  }
  for (Index v = 0; v < open_.num_vertices; ++v) {
    if (wanted[v] && !runs[v]) held_[v] = true;
    if (!runs[v]) continue;
    rail_of_[v] = static_cast<Index>(rails_.size());
    rails_.push_back(rail(v));
  }
}

std::vector<double> OpenedMap::Energies(const MapObjective& objective) const {
  std::vector<double> energies(faces_.size(), 0);
  ParallelFor(open_.num_faces(), [&](Index f) {
    if (!(faces_[f].weight > 0)) return;
    const double m_squared = SquaredBeltrami(faces_[f], z_);
    energies[f] =
        m_squared < 1 ? objective.value(m_squared) : std::numeric_limits<double>::infinity();
  });
  return energies;
}

double OpenedMap::Mean(const std::vector<double>& energies) const {
  double sum = 0;
  for (std::size_t f = 0; f < faces_.size(); ++f) sum += faces_[f].weight * energies[f];
  return sum;
}

MapPart OpenedMap::PartOf(const std::vector<bool>& moves, const std::vector<Index>& faces,
                          const std::vector<Index>& seams) {
  MapPart part;
  NumberVertices(moves, faces, &part);
  AddFaces(faces, &part);
  AddSeams(faces, seams, &part);
  AddRails(faces, &part);
  for (const Index v : part.vertex) number_[v] = kNone;
  return part;
}

MapPart OpenedMap::Whole() {
  std::vector<bool> moves = held_;
  moves.flip();
  std::vector<Index> faces, seams;
  const auto some = [&](const auto& vertex) {
    return std::any_of(vertex.begin(), vertex.end(), [&](Index v) { return moves[v]; });
  };
  for (Index f = 0; f < open_.num_faces(); ++f) {
    if (injective_ || some(faces_[f].vertex)) faces.push_back(f);
  }
  for (std::size_t c = 0; c < seams_.size(); ++c) {
    if (some(seams_[c].vertex)) seams.push_back(static_cast<Index>(c));
  }
  MapPart part = PartOf(moves, faces, seams);
  if (injective_) {
    for (std::size_t i = 0; i < part.vertex.size(); ++i) {
      number_[part.vertex[i]] = static_cast<Index>(i);
    }
    part.fence = FenceOf(number_);
    for (const Index v : part.vertex) number_[v] = kNone;
  }
  return part;
}

/// In the map's order, those that move first.
void OpenedMap::NumberVertices(const std::vector<bool>& moves, const std::vector<Index>& faces,
                               MapPart* part) {
  constexpr Index kSeen = 0;
  std::vector<Index> held;
  for (const Index f : faces) {
    for (const Index v : faces_[f].vertex) {
      if (number_[v] != kNone) continue;
      number_[v] = kSeen;
      (moves[v] ? part->vertex : held).push_back(v);
    }
  }
  part->unknowns = static_cast<Index>(part->vertex.size());
  std::sort(part->vertex.begin(), part->vertex.end());
  std::sort(held.begin(), held.end());
  part->vertex.insert(part->vertex.end(), held.begin(), held.end());
  for (std::size_t i = 0; i < part->vertex.size(); ++i) {
    number_[part->vertex[i]] = static_cast<Index>(i);
  }
}

void OpenedMap::AddFaces(const std::vector<Index>& faces, MapPart* part) const {
  part->triangles.reserve(faces.size());
  part->faces.reserve(faces.size());
  for (const Index f : faces) {
    BeltramiFace face = faces_[f];
    for (Index& v : face.vertex) v = number_[v];
    part->triangles.push_back(face.vertex);
    if (face.weight > 0) part->faces.push_back(Ordered(face));
  }
}

void OpenedMap::AddSeams(const std::vector<Index>& faces, const std::vector<Index>& seams,
                         MapPart* part) const {
  if (seams.empty()) return;
  std::vector<Index> weighted;
  for (const Index f : faces) {
    if (faces_[f].weight > 0) weighted.push_back(f);
  }
  const auto place = [&](Index face) {
    const auto at = std::lower_bound(weighted.begin(), weighted.end(), face);
    return at == weighted.end() || *at != face ? kNone : static_cast<Index>(at - weighted.begin());
  };
  for (const Index c : seams) {
    SeamConstraint seam = seams_[c];
    for (Index& v : seam.vertex) v = number_[v];
    seam.left_face = place(seam.left_face), seam.right_face = place(seam.right_face);
    part->seams.push_back(seam);
  }
}

void OpenedMap::AddRails(const std::vector<Index>& faces, MapPart* part) const {
  if (rails_.empty()) return;
  const auto slides = [&](Index v) { return number_[v] < part->unknowns && rail_of_[v] != kNone; };
  const auto direction = [&](Index v) { return rails_[rail_of_[v]].direction; };
  for (Index i = 0; i < part->unknowns; ++i) {
    const Index rail = rail_of_[part->vertex[i]];
    if (rail != kNone) part->rails.push_back({i, rails_[rail].direction});
  }
  for (const Index f : faces) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index tail = open_.Tail(h), tip = open_.Tip(h);
      if (open_.twin[h] != kNone || !(slides(tail) || slides(tip))) continue;
      part->rim.push_back({number_[tail], number_[tip], direction(slides(tail) ? tail : tip)});
    }
  }
}

/// The boundary with its vertices numbered so.
Fence OpenedMap::FenceOf(const std::vector<Index>& number) const {
  Fence fence;
  for (Index h = 0; h < open_.num_halfedges(); ++h) {
    if (open_.twin[h] != kNone) continue;
    fence.sides.push_back({number[open_.Tail(h)], number[open_.Tip(h)]});
  }
  return fence;
}

double OpenedMap::ImageArea() const {
  double twice = 0;
  for (Index h = 0; h < open_.num_halfedges(); h += 3) {
    const Complex origin = z_[open_.vertex[h]];
    twice +=
        std::imag(std::conj(z_[open_.vertex[h + 1]] - origin) * (z_[open_.vertex[h + 2]] - origin));
  }
  return twice / 2;
}

bool OpenedMap::KeepsOrientation(double scale) const {
  const auto at = [&](Index v) {
    return Eigen::Vector2d(scale * z_[v].real(), scale * z_[v].imag());
  };
  return std::all_of(faces_.begin(), faces_.end(), [&](const BeltramiFace& face) {
    return OrientationSign(at(face.vertex[0]), at(face.vertex[1]), at(face.vertex[2])) > 0;
  });
}

bool OpenedMap::KeepsApart(double scale) const {
  if (!injective_) return true;
  std::vector<Index> number(open_.num_vertices);
  std::iota(number.begin(), number.end(), 0);
  return !FenceOf(number).IsCrossed(scale * z_);
}

double OpenedMap::ScaleBack() const {
  const double scale = std::sqrt(area_before_ / ImageArea());
  if (has_place_ || !std::isfinite(scale) || std::abs(scale - 1) < kSameScale) return 1;
  if (!short_seams_ && KeepsOrientation(scale) && KeepsApart(scale)) return scale;
  return std::exp2(std::round(std::log2(scale)));
}

void OpenedMap::WriteTo(CornerUv* uv) const {
  const double scale = ScaleBack();
  for (Index c = 0; c < open_.num_halfedges(); ++c) {
    const Complex& p = z_[open_.vertex[c]];
    uv->value[c] = {scale * p.real(), scale * p.imag()};
  }
}

}  // namespace cirque
