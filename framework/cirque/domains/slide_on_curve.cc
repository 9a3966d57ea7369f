#include "cirque/domains/slide_on_curve.h"

#include <algorithm>
#include <complex>
#include <utility>
#include <vector>

#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

constexpr int kMostRounds = 20;
constexpr double kGain = 0.99;  ///< of the objective, that a round must leave at most
constexpr double kNear =
    0.25;  ///< of the way to the nearer neighbour: what a tangent is taken over
constexpr double kFarthest = 0.499;      ///< of the arc to a neighbour, that a vertex may slide
constexpr double kShortest = 1.0 / 128;  ///< of the way

class SlidingRounds {
 public:
  SlidingRounds(const IntrinsicSurface& surface, const ClosedCurve& curve,
                const std::string& refine_map, const std::atomic<bool>* cancelled)
      : surface_(surface), curve_(curve), refine_map_(refine_map), cancelled_(cancelled) {}

  Status Run(VerticesOnCurve* on, CornerUv* uv, std::optional<MapRefinementSummary>* summary) {
    Status status = Refine({surface_.boundary}, uv, summary);
    for (int round = 0; status.ok() && *summary && round < kMostRounds; ++round) {
      VerticesOnCurve moved = *on;
      CornerUv next = *uv;
      std::optional<MapRefinementSummary> after;
      bool slides = false;
      status = Slide(&moved, &next, &slides);
      if (!status.ok() || !slides) break;
      status = Refine({surface_.boundary}, &next, &after);
      const bool gains = status.ok() && after &&
                         after->map_refinement_after < kGain * (*summary)->map_refinement_after;
      if (!gains) break;
      *on = std::move(moved), *uv = std::move(next);
      (*summary)->map_refinement_after = after->map_refinement_after;
    }
    return status;
  }

 private:
  Status Refine(KeptVertices kept, CornerUv* uv,
                std::optional<MapRefinementSummary>* summary) const {
    return RefineHeldMap(surface_, std::move(kept), refine_map_, cancelled_, uv, summary);
  }

  /// The arc to the next vertex, round the curve.
  double Gap(const VerticesOnCurve& on, std::size_t k) const {
    return k + 1 < on.arcs.size() ? on.arcs[k + 1] - on.arcs[k] : curve_.length() - on.arcs[k];
  }

  Complex Tangent(const VerticesOnCurve& on, std::size_t k) const {
    const std::size_t before = (k + on.arcs.size() - 1) % on.arcs.size();
    const double near = kNear * std::min(Gap(on, before), Gap(on, k));
    const Eigen::Vector2d way = curve_.At(on.arcs[k] + near) - curve_.At(on.arcs[k] - near);
    return Complex(way.x(), way.y()) / way.norm();
  }

  /// `slides`: whether some share of the way, of which the largest is taken, flips nothing. Error:
  /// cancelled.
  Status Slide(VerticesOnCurve* on, CornerUv* uv, bool* slides) const {
    const Triangulation& t = surface_.triangulation;
    KeptVertices kept{surface_.boundary};
    kept.sliding.slides.assign(t.num_vertices, false);
    kept.sliding.direction.assign(t.num_vertices, 1.0);
    for (std::size_t k = 1; k < on->vertex.size(); ++k) {
      if (on->at_corner[k]) continue;
      const Index v = on->vertex[k];
      kept.held[v] = false, kept.sliding.slides[v] = true;
      kept.sliding.direction[v] = Tangent(*on, k);
    }
    const std::vector<Complex> direction = kept.sliding.direction;
    CornerUv slid = *uv;
    std::optional<MapRefinementSummary> unused;
    Status status = Refine(std::move(kept), &slid, &unused);
    const VerticesOnCurve before = *on;
    const CornerUv from = *uv;
    for (double share = 1; status.ok() && !*slides && share >= kShortest; share /= 2) {
      *on = before;
      MoveArcs(slid, direction, share, on);
      for (std::size_t c = 0; c < from.value.size(); ++c) {
        uv->value[c] = from.value[c] + share * (slid.value[c] - from.value[c]);
      }
      PutBack(*on, uv);
      *slides = FlippedFaces(t, *uv).empty();
    }
    return status;
  }

  /// As far along the curve as along its tangents, no vertex past half of the way to another.
  void MoveArcs(const CornerUv& slid, const std::vector<Complex>& direction, double share,
                VerticesOnCurve* on) const {
    const Triangulation& t = surface_.triangulation;
    std::vector<Eigen::Vector2d> place(t.num_vertices);
    for (Index h = 0; h < t.num_halfedges(); ++h) place[t.vertex[h]] = slid.value[h];
    const VerticesOnCurve before = *on;
    for (std::size_t k = 1; k < before.vertex.size(); ++k) {
      if (before.at_corner[k]) continue;
      const Eigen::Vector2d way = place[before.vertex[k]] - curve_.At(before.arcs[k]);
      const Complex along = direction[before.vertex[k]];
      const double distance = share * (way.x() * along.real() + way.y() * along.imag());
      on->arcs[k] +=
          std::clamp(distance, -kFarthest * Gap(before, k - 1), kFarthest * Gap(before, k));
    }
  }

  void PutBack(const VerticesOnCurve& on, CornerUv* uv) const {
    const Triangulation& t = surface_.triangulation;
    std::vector<std::size_t> number(t.num_vertices, on.vertex.size());
    for (std::size_t k = 0; k < on.vertex.size(); ++k) number[on.vertex[k]] = k;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      const std::size_t k = number[t.vertex[h]];
      if (k < on.vertex.size()) uv->value[h] = curve_.At(on.arcs[k]);
    }
  }

  const IntrinsicSurface& surface_;
  const ClosedCurve& curve_;
  const std::string& refine_map_;
  const std::atomic<bool>* cancelled_;
};

}  // namespace

Status RefineOnCurve(const IntrinsicSurface& surface, const ClosedCurve& curve,
                     const std::string& refine_map, const std::atomic<bool>* cancelled,
                     VerticesOnCurve* on, CornerUv* uv,
                     std::optional<MapRefinementSummary>* summary) {
  return SlidingRounds(surface, curve, refine_map, cancelled).Run(on, uv, summary);
}

}  // namespace cirque
