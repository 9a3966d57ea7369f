#include "cirque/domains/exact_disk.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/intrinsic/overlay.h"
#include "cirque/intrinsic/straight_lines.h"
#include "cirque/math/predicates.h"
#include "cirque/mesh/split_chords.h"
#include "cirque/metrics/injectivity.h"
#include "cirque/pipeline/exact_layout.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

bool AreNumbers(const CornerUv& uv) {
  return std::all_of(uv.value.begin(), uv.value.end(),
                     [](const Eigen::Vector2d& x) { return x.allFinite(); });
}

/// A point of a face of a split surface, in the face that this was cut from.
class PointsBeforeSplit {
 public:
  PointsBeforeSplit(const Triangulation& t, const std::vector<bool>& edges,
                    const Triangulation& split)
      : t_(t), split_(split), before_(FacesBeforeSplit(t, edges)) {
    for (Index e = 0; e < t.num_edges(); ++e) {
      if (edges[e]) edge_of_middle_.push_back(e);
    }
  }

  Index Face(Index split_face) const { return before_[split_face]; }

  SurfacePoint Of(const SurfacePoint& point) const {
    SurfacePoint whole{Face(point.face), Eigen::Vector3d::Zero()};
    for (Index k = 0; k < 3; ++k) {
      AddCorner(split_.vertex[3 * point.face + k], point.barycentric[k], &whole);
    }
    return whole;
  }

 private:
  void AddCorner(Index vertex, double weight, SurfacePoint* point) const {
    if (weight == 0) return;
    for (Index h = 3 * point->face; h < 3 * point->face + 3; ++h) {
      if (t_.vertex[h] == vertex) point->barycentric[h % 3] += weight;
      const bool is_middle =
          vertex >= t_.num_vertices && edge_of_middle_[vertex - t_.num_vertices] == t_.edge[h];
      if (!is_middle) continue;
      point->barycentric[Triangulation::Next(h) % 3] += 0.5 * weight;
      point->barycentric[Triangulation::Prev(h) % 3] += 0.5 * weight;
    }
  }

  const Triangulation &t_, &split_;
  const std::vector<Index> before_;
  std::vector<Index> edge_of_middle_;
};

Status CheckTriangles(const Triangulation& t, const ExactMap& map) {
  for (Index p = 0; p < map.num_triangles(); ++p) {
    Eigen::Vector2d at[3];
    for (Index k = 0; k < 3; ++k) {
      const Eigen::Vector3d weight =
          InFace(t, map.point[map.corner[3 * p + k]], map.face_of_input[p]);
      at[k] = {weight[1], weight[2]};
    }
    if (OrientationSign(at[0], at[1], at[2]) > 0) continue;
    return Status(StatusCode::kUnrepresentable,
                  fmt::format("the exact map has triangles so thin that rounding turns them over "
                              "in face {} (0-based)",
                              map.face_of_input[p]));
  }
  return Status();
}

}  // namespace

Status CheckSolvedNotFlipped(const Triangulation& solved, const CornerUv& uv,
                             const char* elsewhere) {
  const auto refuse = [&](const std::string& why) {
    return Status(StatusCode::kUnrepresentable,
                  fmt::format("the exact map: {}; {} may hold it", why, elsewhere));
  };
  if (!AreNumbers(uv)) return refuse("doubles do not hold its vertices");
  const std::size_t flipped = FlippedFaces(solved, uv).size();
  if (flipped == 0) return Status();
  return refuse(
      fmt::format("{} of the triangulation that was solved on {} flipped where their corners go",
                  Count(flipped, "triangle"), flipped == 1 ? "is" : "are"));
}

Status DrawExactDisk(const Triangulation& disk, const IntrinsicTriangulation& solved,
                     const CornerUv& uv, const CutFrom& from, int limit, SurfaceMap* map) {
  if (Status s = CheckSolvedNotFlipped(solved.triangulation, uv, "a rectangle or the plane");
      !s.ok()) {
    return s;
  }
  const IntrinsicSurface surface = MeasureSurface(solved.triangulation, solved.lengths);
  const StatusOr<Overlay> overlay =
      MakeOverlay(disk, solved.flips, StraightLines(surface.triangulation, surface.lengths), limit);
  if (!overlay.ok()) return overlay.status().In("exact_limit");
  const Cut none{std::vector<bool>(solved.triangulation.num_edges(), false)};
  SolvedMap drawn = {disk, surface, none, uv};
  if (!from.face.empty()) drawn.part_of = &from.face, drawn.num_wholes = from.num_faces;
  ExactMapSummary& summary = Fill(&map->certificate.exact_map);
  ExactMap exact;
  if (Status s = DrawExactMap(drawn, *overlay, &summary, &exact); !s.ok()) return s;
  Summarize(DistortionOf(surface.triangulation, surface.lengths, uv), &summary);
  map->exact_map = std::move(exact);
  return Status();
}

StatusOr<ExactMap> BeforeSplit(const Triangulation& t, const std::vector<bool>& edges,
                               const Triangulation& split, ExactMap map) {
  const PointsBeforeSplit points(t, edges, split);
  for (SurfacePoint& point : map.point) point = points.Of(point);
  for (Index& face : map.face_of_input) face = points.Face(face);
  if (Status s = CheckTriangles(t, map); !s.ok()) return s;
  return map;
}

Status TakeExactMap(const Triangulation& t, const std::vector<bool>& edges,
                    const Triangulation& split, SurfaceMap* from, SurfaceMap* map) {
  StatusOr<ExactMap> whole = *std::move(from->exact_map);
  if (std::find(edges.begin(), edges.end(), true) != edges.end()) {
    whole = BeforeSplit(t, edges, split, *std::move(whole));
  }
  if (!whole.ok()) return whole.status();
  map->exact_map = *std::move(whole);
  map->certificate.exact_map = from->certificate.exact_map;
  return Status();
}

}  // namespace cirque
