#include "cirque/mesh/coarsen.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "cirque/core/triangulation.h"
#include "cirque/mesh/vertex_star.h"

namespace cirque {
namespace {

constexpr std::size_t kMostFaces = 8;  ///< at a vertex that goes
constexpr Index kMostKept = 10;        ///< at the one that it goes to, afterwards
constexpr Index kLeastFaces = 5;       ///< at an inner vertex that loses one
constexpr double kThin = 0.2;          ///< triangles of less score only in place of others
constexpr std::size_t kSample = 4000;  ///< vertices that a round's limit is made from
constexpr double kSteepShare = 0.3;    ///< of them, that a round leaves
constexpr double kSameCosine = 1e-9;
constexpr double kLeastShare = 0.01;  ///< of the vertices that a round must take for another one

class Coarsener {
 public:
  Coarsener(const Surface& surface, Index wanted)
      : position_(surface.position),
        wanted_(wanted),
        left_(surface.triangulation.num_faces()),
        boundary_(BoundaryVertices(surface.triangulation)),
        first_(surface.position.size(), kNone),
        next_(surface.triangulation.vertex.size(), kNone),
        count_(CornersPerVertex(surface.triangulation)),
        gone_(surface.triangulation.num_faces(), false),
        taken_part_(surface.position.size(), 0),
        stamp_(surface.position.size(), 0) {
    const std::vector<Index>& vertex = surface.triangulation.vertex;
    corner_.resize(vertex.size() / 3);
    for (Index c = surface.triangulation.num_halfedges(); c-- > 0;) {
      corner_[c / 3][c % 3] = vertex[c];
      PutCorner(c, vertex[c]);
    }
  }

  CoarseSurface Run() {
    auto vertices = static_cast<double>(position_.size());
    for (Index round = 1; left_ > wanted_; ++round) {
      const std::size_t before = log_.size();
      LimitTurn();
      for (Index v = 0; v < static_cast<Index>(position_.size()) && left_ > wanted_; ++v) {
        if (taken_part_[v] < round && first_[v] != kNone) TryToRemove(v, round);
      }
      const auto gone = static_cast<double>(log_.size() - before);
      if (gone < kLeastShare * vertices) break;
      vertices -= gone;
    }
    return Rest();
  }

 private:
  void PutCorner(Index c, Index v) {
    next_[c] = first_[v];
    first_[v] = c;
  }

  /// Takes the corner of a face that vanishes off its vertex.
  void DropCorner(Index c, Index v) {
    Index* link = &first_[v];
    while (*link != c) link = &next_[*link];
    *link = next_[c];
    --count_[v];
  }

  /// False where there are too many faces or too few.
  bool FindStar(Index v) {
    const auto size = static_cast<std::size_t>(count_[v]);
    if (size > kMostFaces || size < (boundary_[v] ? 2 : 3)) return false;
    struct Side {
      Index from, to, face;
    };
    std::array<Side, kMostFaces> sides;
    auto end = sides.begin();
    for (Index c = first_[v]; c != kNone; c = next_[c]) {
      const auto& f = corner_[c / 3];
      *end++ = {f[(c + 1) % 3], f[(c + 2) % 3], c / 3};
    }
    // The first has no face before it, at an inner vertex any will do.
    Index at = sides[0].from;
    for (auto s = sides.begin(); boundary_[v] && s != end; ++s) {
      if (std::none_of(sides.begin(), end, [&](const Side& other) { return other.to == s->from; }))
        at = s->from;
    }
    star_.closed = !boundary_[v];
    star_.ring.assign(1, at);
    star_.face.clear();
    for (std::size_t k = 0; k < size; ++k) {
      const auto side =
          std::find_if(sides.begin(), end, [&](const Side& s) { return s.from == at; });
      if (side == end) return false;
      at = side->to;
      star_.ring.push_back(at);
      star_.face.push_back(side->face);
    }
    if (boundary_[v]) return true;
    star_.ring.pop_back();
    return at == star_.ring.front();
  }

  /// Vertices in flat surroundings go first: a round takes those alone whose triangles turn no more
  /// than those of most, to judge by a sample.
  void LimitTurn() {
    least_cosine_ = -1;
    std::vector<double> cosines;
    const std::size_t step = std::max<std::size_t>(1, (position_.size() - log_.size()) / kSample);
    std::size_t seen = 0;
    for (std::size_t v = 0; v < position_.size(); ++v) {
      if (first_[v] == kNone || seen++ % step != 0) continue;
      const std::optional<CollapseChoice> choice = Choose(static_cast<Index>(v));
      if (choice) cosines.push_back(choice->cosine);
    }
    if (cosines.empty()) return;
    const auto at = cosines.begin() +
                    static_cast<std::ptrdiff_t>(kSteepShare * static_cast<double>(cosines.size()));
    std::nth_element(cosines.begin(), at, cosines.end());
    least_cosine_ = *at - kSameCosine;
  }

  /// That of the best score, among those of a turn that may be.
  std::optional<CollapseChoice> Choose(Index v) {
    if (!FindStar(v)) return std::nullopt;
    // Thin triangles may come in place of others.
    const double least = std::min(kThin, star_.Measure(position_, v));
    std::optional<CollapseChoice> best;
    const double straight = star_.closed ? 1 : star_.BoundaryCosine(position_, v);
    if (straight < least_cosine_) return std::nullopt;
    const std::size_t step = star_.closed ? 1 : star_.ring.size() - 1;
    for (std::size_t k = 0; k < star_.ring.size(); k += step) {
      CollapseChoice choice{k, 0, straight};
      const bool good = star_.Score(position_, std::max(best ? best->score : 0, least), &choice);
      if (good && choice.cosine >= least_cosine_ && IsAllowed(v, k)) best = choice;
    }
    return best;
  }

  void TryToRemove(Index v, Index round) {
    const std::optional<CollapseChoice> choice = Choose(v);
    if (!choice) return;
    for (const Index u : star_.ring) taken_part_[u] = round;
    Collapse(v, choice->at);
  }

  /// Whether the surface stays a manifold of good valences: the only common neighbours of both are
  /// those across their edge.
  bool IsAllowed(Index v, std::size_t at) {
    const std::vector<Index>& ring = star_.ring;
    const Index kept = ring[at], across = star_.closed ? 2 : 1;
    if (count_[kept] + count_[v] > kMostKept + 2 * across) return false;
    const std::size_t size = ring.size();
    for (const std::size_t k : {at + 1, at + size - 1}) {
      const Index u = ring[k % size];
      if (u == kept || (!star_.closed && k != (at == 0 ? at + 1 : at + size - 1))) continue;
      if (count_[u] < (boundary_[u] ? 2 : kLeastFaces)) return false;
    }
    ++now_;
    for (const Index u : ring) stamp_[u] = now_;
    Index common = 0;
    for (Index c = first_[kept]; c != kNone; c = next_[c]) {
      for (const Index u : corner_[c / 3]) {
        if (u == kept || stamp_[u] != now_) continue;
        stamp_[u] = 0;  // counted
        ++common;
      }
    }
    return common == across;
  }

  void Collapse(Index v, std::size_t at) {
    const Index kept = star_.ring[at];
    log_.removed.push_back(v);
    log_.kept.push_back(kept);
    if (star_.closed) {
      std::rotate(star_.face.begin(), star_.face.begin() + static_cast<std::ptrdiff_t>(at),
                  star_.face.end());
    }
    log_.face.insert(log_.face.end(), star_.face.begin(), star_.face.end());
    log_.first_face.push_back(log_.face.size());
    for (const Index f : star_.face) {
      auto& corners = corner_[f];
      const auto of = [&](Index u) {
        return static_cast<Index>(std::find(corners.begin(), corners.end(), u) - corners.begin());
      };
      if (of(kept) == 3) {
        const Index k = of(v);
        corners[k] = kept;
        PutCorner(3 * f + k, kept);
        ++count_[kept];
        continue;
      }
      for (Index k = 0; k < 3; ++k) {
        if (corners[k] != v) DropCorner(3 * f + k, corners[k]);
      }
      gone_[f] = true;
      --left_;
    }
    first_[v] = kNone;
  }

  CoarseSurface Rest() {
    CoarseSurface rest;
    std::vector<Index> number(position_.size(), kNone);
    for (std::size_t v = 0; v < position_.size(); ++v) {
      if (first_[v] == kNone) continue;
      number[v] = static_cast<Index>(rest.vertex.size());
      rest.vertex.push_back(static_cast<Index>(v));
      rest.soup.position.push_back(position_[v]);
    }
    for (std::size_t f = 0; f < corner_.size(); ++f) {
      if (gone_[f]) continue;
      rest.face.push_back(static_cast<Index>(f));
      for (const Index v : corner_[f]) rest.soup.corner.push_back(number[v]);
      rest.soup.first_corner.push_back(static_cast<Index>(rest.soup.corner.size()));
    }
    log_.corner = std::move(corner_);
    rest.collapses = std::move(log_);
    return rest;
  }

  const std::vector<Eigen::Vector3d>& position_;
  const Index wanted_;
  Index left_;  ///< faces
  const std::vector<bool> boundary_;
  std::vector<std::array<Index, 3>> corner_;  ///< F
  /// The corners at each vertex as a list: its first, and after each corner the next.
  std::vector<Index> first_, next_;
  std::vector<Index> count_;       ///< V: corners there
  std::vector<bool> gone_;         ///< F
  std::vector<Index> taken_part_;  ///< per vertex, the last round in which it or a neighbour went
  std::vector<Index> stamp_;
  Index now_ = 0;
  VertexStar star_;  ///< that is looked at
  double least_cosine_ = -1;
  CollapseLog log_;
};

}  // namespace

CoarseSurface Coarsen(const Surface& surface, Index faces) {
  return Coarsener(surface, faces).Run();
}

}  // namespace cirque
