#include "cirque/layout/collapsed_map.h"

#include <algorithm>
#include <cstddef>

#include "cirque/math/predicates.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;
using Point = Eigen::Vector2d;

Complex ToComplex(const Point& p) { return {p.x(), p.y()}; }
Point ToPoint(const Complex& z) { return {z.real(), z.imag()}; }

}  // namespace

Point PlaneFrame::From(const Point& p) const {
  return own ? p : ToPoint(turn * ToComplex(p) + shift);
}

Point PlaneFrame::ToWhole(const Point& p) const {
  return own ? p : ToPoint((ToComplex(p) - shift) / turn);
}

PlaneFrame PlaneFrame::Across(const Point& a, const Point& b, const Point& c,
                              const Point& d) const {
  const Complex motion = (ToComplex(d) - ToComplex(c)) / (ToComplex(b) - ToComplex(a));
  return {motion * turn, motion * (shift - ToComplex(a)) + ToComplex(c), false};
}

CollapsedStar::CollapsedStar(const std::vector<Eigen::Vector3d>& position, const CollapseLog& log,
                             CollapsedMap* map)
    : map_(map), removed_(log.removed.back()), kept_(log.kept.back()) {
  const auto first = log.face.begin() + static_cast<std::ptrdiff_t>(*(log.first_face.end() - 2));
  for (auto f = first; f != log.face.end(); ++f) faces_.push_back({*f, !map->there[*f]});
  closed_ = faces_.front().returns && faces_.back().returns;
  LayOutOthers();
  LayOutReturning();
  Unroll(position);
}

bool CollapsedStar::IsSeenFrom(const Point& at) const {
  if (!at.allFinite()) return false;
  return std::all_of(faces_.begin(), faces_.end(), [&](const Face& face) {
    return OrientationSign(face.frame.From(at), face.p, face.q) > 0;
  });
}

void CollapsedStar::Place(const Point& at) {
  const bool cut = closed_ && std::any_of(faces_.begin(), faces_.end(),
                                          [](const Face& face) { return face.cut_before; });
  for (const Face& face : faces_) {
    if (!face.returns) {
      map_->corner[face.id][face.apex] = removed_;
      map_->uv.value[3 * face.id + face.apex] = face.frame.From(at);
    } else {
      PlaceReturning(face, at, cut);
    }
  }
}

Index CollapsedStar::CornerAt(Index face, Index vertex) const {
  const auto& corner = map_->corner[face];
  return static_cast<Index>(std::find(corner.begin(), corner.end(), vertex) - corner.begin());
}

/// The faces that are there, at the vertex kept.
void CollapsedStar::LayOutOthers() {
  const Face* before = nullptr;
  for (Face& face : faces_) {
    if (face.returns) continue;
    face.apex = CornerAt(face.id, kept_);
    for (const int k : {0, 1}) {
      const Index c = (face.apex + 1 + k) % 3;
      face.ring_vertex[k] = map_->corner[face.id][c];
      (k == 0 ? face.p : face.q) = map_->uv.value[3 * face.id + c];
    }
    if (before) {
      face.frame = before->frame;
      face.cut_before = map_->cut[3 * before->id + (before->apex + 1) % 3];
      if (face.cut_before) {
        face.frame = before->frame.Across(KeptIn(*before), before->q, KeptIn(face), face.p);
      }
    } else {
      kept_at_ = KeptIn(face);
    }
    before = &face;
  }
}

const Point& CollapsedStar::KeptIn(const Face& face) const {
  return map_->uv.value[3 * face.id + face.apex];
}

/// Those that vanished lie in the frames of their neighbours.
void CollapsedStar::LayOutReturning() {
  for (Face& face : faces_) {
    if (!face.returns) continue;
    face.apex = CornerAt(face.id, removed_);
    const bool is_first = &face == &faces_.front();
    const Face& beside = is_first ? faces_[1] : faces_[faces_.size() - 2];
    face.frame = beside.frame;
    face.p = is_first ? KeptIn(beside) : beside.q;
    face.q = is_first ? beside.p : KeptIn(beside);
    face.ring_vertex[0] = is_first ? kept_ : beside.ring_vertex[1];
    face.ring_vertex[1] = is_first ? beside.ring_vertex[0] : kept_;
  }
}

void CollapsedStar::Unroll(const std::vector<Eigen::Vector3d>& position) {
  const auto add = [&](Index v, const Point& at) {
    around_.push_back(position[v] - position[removed_]);
    ring_.push_back(v == kept_ ? kept_at_ : at);
  };
  for (const Face& face : faces_) add(face.ring_vertex[0], face.frame.ToWhole(face.p));
  const Face& last = faces_.back();
  if (!closed_) add(last.ring_vertex[1], last.frame.ToWhole(last.q));
}

/// Its edge to the vertex kept is cut if any was within the ring. That at the ring was a side of
/// the face beside it.
void CollapsedStar::PlaceReturning(const Face& face, const Point& at, bool cut) {
  const bool is_first = &face == &faces_.front();
  const Face& beside = is_first ? faces_[1] : faces_[faces_.size() - 2];
  map_->there[face.id] = true;
  const Index h = 3 * face.id, p = h + (face.apex + 1) % 3, q = h + (face.apex + 2) % 3;
  map_->uv.value[h + face.apex] = face.frame.From(at);
  map_->uv.value[p] = face.p;
  map_->uv.value[q] = face.q;
  const Index inner = 3 * beside.id + (beside.apex + (is_first ? 2 : 1)) % 3;
  map_->cut[h + face.apex] = map_->cut[inner];
  map_->cut[inner] = false;
  map_->cut[is_first ? q : p] = cut;
  map_->cut[is_first ? p : q] = false;
}

}  // namespace cirque
