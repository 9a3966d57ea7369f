#include "cirque/domains/atlas.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "cirque/core/grouping.h"
#include "cirque/layout/packing.h"
#include "cirque/math/predicates.h"

namespace cirque {

double AreaOf(const Surface& surface) {
  double area = 0;
  for (Index f = 0; f < surface.triangulation.num_faces(); ++f) {
    const Index* v = &surface.triangulation.vertex[3 * f];
    const Eigen::Vector3d a = surface.position[v[1]] - surface.position[v[0]];
    area += 0.5 * a.cross(surface.position[v[2]] - surface.position[v[0]]).norm();
  }
  return area;
}

namespace {

Patches PatchesOf(const Triangulation& t, const Cut& cut) {
  const bool opened = static_cast<Index>(cut.edge.size()) == t.num_edges();
  return ConnectedPatches(opened ? CutOpen(t, cut) : t);
}

/// By what each piece is multiplied before they are packed.
std::vector<double> ScalesOf(PieceScale scale, const std::vector<PlanarPiece>& pieces) {
  std::vector<double> areas, scales;
  for (const PlanarPiece& piece : pieces) areas.push_back(piece.surface_area);
  const double mean =
      std::accumulate(areas.begin(), areas.end(), 0.) / static_cast<double>(areas.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double own = AreaOf(*pieces[i].uv);
    const double wanted = scale == PieceScale::kTrue ? areas[i] : mean;
    const double factor = std::sqrt(wanted / own);
    scales.push_back(std::isfinite(factor) && factor > 0 ? factor : 1);
  }
  return scales;
}

/// Several pieces side by side, at the size that they are to have to each other. Returns the number
/// of patches.
int PackPieces(const UvFrame& frame, const std::vector<PlanarPiece>& pieces) {
  const std::vector<double> scales = ScalesOf(frame.pieces, pieces);
  CornerUv all;
  Patches patches;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Patches& own = pieces[i].patches;
    for (const Index patch : own.of_face) patches.of_face.push_back(patches.count + patch);
    patches.count += own.count;
    for (const Eigen::Vector2d& p : pieces[i].uv->value) all.value.push_back(scales[i] * p);
  }
  PackingOptions options;
  options.gap = std::max(frame.margin, 1e-6);
  options.to_unit_square = false;
  const Packing packing = PackPatches(all, patches, options);
  auto next = packing.uv.value.begin();
  for (const PlanarPiece& piece : pieces) {
    for (Eigen::Vector2d& p : piece.uv->value) p = *next++;
  }
  return patches.count;
}

Eigen::AlignedBox2d BoxOf(const std::vector<PlanarPiece>& pieces) {
  Eigen::AlignedBox2d box;
  for (const PlanarPiece& piece : pieces) {
    for (const Eigen::Vector2d& p : piece.uv->value) box.extend(p);
  }
  return box;
}

/// Scales all pieces, and moves them into the unit square where that is asked for.
void PutIntoFrame(const UvFrame& frame, const Eigen::AlignedBox2d& box,
                  const std::vector<PlanarPiece>& pieces) {
  if (frame.size == UvSize::kAsIs) return;
  const double side = box.sizes().maxCoeff();
  const bool unit = frame.size == UvSize::kUnit && side > 0;
  // A little less than all of the square, so that rounding leads nothing out of it.
  const double free = 1 - 2 * std::max(frame.margin, 1e-12);
  const double scale = unit ? free / side : frame.scale;
  const Eigen::Vector2d from = unit ? Eigen::Vector2d(box.min()) : Eigen::Vector2d(0, 0);
  const double margin = unit ? frame.margin : 0;
  for (const PlanarPiece& piece : pieces) {
    for (Eigen::Vector2d& p : piece.uv->value) {
      p = (scale * (p - from)).array() + margin;
    }
  }
}

/// Triangles are of one patch where they share a UV.
Patches PatchesOf(const ExactMap& map) {
  DisjointSets sets(static_cast<Index>(map.uv.size()));
  for (std::size_t c = 0; c < map.corner_uv.size(); c += 3) {
    sets.Unite(map.corner_uv[c], map.corner_uv[c + 1]);
    sets.Unite(map.corner_uv[c], map.corner_uv[c + 2]);
  }
  Patches patches;
  std::vector<Index> number(map.uv.size(), kNone);
  for (std::size_t c = 0; c < map.corner_uv.size(); c += 3) {
    Index& patch = number[sets.Find(map.corner_uv[c])];
    if (patch == kNone) patch = patches.count++;
    patches.of_face.push_back(patch);
  }
  return patches;
}

CornerUv CornersOf(const ExactMap& map) {
  CornerUv corners;
  for (const Index uv : map.corner_uv) corners.value.push_back(map.uv[uv]);
  return corners;
}

bool IsPositive(const CornerUv& uv) {
  for (std::size_t c = 0; c < uv.value.size(); c += 3) {
    if (OrientationSign(uv.value[c], uv.value[c + 1], uv.value[c + 2]) <= 0) return false;
  }
  return true;
}

}  // namespace

PlanarPiece::PlanarPiece(const Surface& surface, const Cut& cut, CornerUv* corners)
    : PlanarPiece(AreaOf(surface), PatchesOf(surface.triangulation, cut), corners) {}

bool LeavesInPlace(const UvFrame& frame, std::size_t num_pieces) {
  return num_pieces <= 1 && frame.size == UvSize::kAsIs;
}

ArrangedAtlas ArrangeAtlas(const UvFrame& frame, const std::vector<PlanarPiece>& pieces) {
  ArrangedAtlas arranged;
  if (pieces.empty()) return arranged;
  const bool moves = !LeavesInPlace(frame, pieces.size());
  std::vector<bool> sound;
  for (const PlanarPiece& piece : pieces) sound.push_back(moves && IsPositive(*piece.uv));
  arranged.patches =
      pieces.size() > 1 ? PackPieces(frame, pieces) : static_cast<int>(pieces[0].patches.count);
  const Eigen::AlignedBox2d box = BoxOf(pieces);
  double area = 0;
  for (const PlanarPiece& piece : pieces) area += AreaOf(*piece.uv);
  const double side = box.sizes().maxCoeff();
  arranged.area_used = area / (side * side);
  PutIntoFrame(frame, box, pieces);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (sound[i] && !IsPositive(*pieces[i].uv)) arranged.lost.push_back(i);
  }
  return arranged;
}

Status ArrangeAtlas(const UvFrame& frame, const std::vector<ExactPiece>& pieces) {
  std::vector<CornerUv> corners;
  for (const ExactPiece& piece : pieces) corners.push_back(CornersOf(*piece.map));
  std::vector<PlanarPiece> planar;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    planar.emplace_back(AreaOf(pieces[i].surface), PatchesOf(*pieces[i].map), &corners[i]);
  }
  ArrangeAtlas(frame, planar);
  if (!std::all_of(corners.begin(), corners.end(), IsPositive)) {
    return Status(StatusCode::kUnrepresentable,
                  "the exact map has triangles so thin that rounding turns them over where the "
                  "frame has them; map one component, as_is");
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ExactMap& map = *pieces[i].map;
    for (std::size_t c = 0; c < map.corner_uv.size(); ++c) {
      map.uv[map.corner_uv[c]] = corners[i].value[c];
    }
  }
  return Status();
}

Surface Joined(const std::vector<const Surface*>& surfaces) {
  Surface joined;
  std::vector<Index> vertex, twin;
  for (const Surface* part : surfaces) {
    const auto first_vertex = static_cast<Index>(joined.position.size());
    const auto first_halfedge = static_cast<Index>(vertex.size());
    const Triangulation& t = part->triangulation;
    for (const Index v : t.vertex) vertex.push_back(first_vertex + v);
    for (const Index g : t.twin) twin.push_back(g == kNone ? kNone : first_halfedge + g);
    const auto append = [](const auto& from, auto* to) {
      to->insert(to->end(), from.begin(), from.end());
    };
    append(part->position, &joined.position);
    append(part->soup_vertex, &joined.soup_vertex);
    append(part->soup_polygon, &joined.soup_polygon);
    append(part->soup_corner, &joined.soup_corner);
  }
  joined.triangulation =
      NumberEdges(static_cast<Index>(joined.position.size()), std::move(vertex), std::move(twin));
  return joined;
}

CornerUv Joined(const std::vector<const CornerUv*>& uvs) {
  CornerUv joined;
  for (const CornerUv* uv : uvs) {
    joined.value.insert(joined.value.end(), uv->value.begin(), uv->value.end());
  }
  return joined;
}

ExactMap Joined(const std::vector<ExactPiece>& pieces) {
  ExactMap joined;
  bool projective = false;
  Index first_face = 0;
  const auto append = [](const std::vector<Index>& from, Index shift, std::vector<Index>* to) {
    for (const Index i : from) to->push_back(shift + i);
  };
  for (const ExactPiece& piece : pieces) {
    const ExactMap& map = *piece.map;
    append(map.corner, static_cast<Index>(joined.point.size()), &joined.corner);
    append(map.corner_uv, static_cast<Index>(joined.uv.size()), &joined.corner_uv);
    append(map.face_of_input, first_face, &joined.face_of_input);
    append(map.face_of_solved, first_face, &joined.face_of_solved);
    for (SurfacePoint point : map.point) {
      point.face += first_face;
      joined.point.push_back(point);
    }
    joined.uv.insert(joined.uv.end(), map.uv.begin(), map.uv.end());
    // All weights equal is linear, too.
    joined.log_weight.insert(joined.log_weight.end(), map.log_weight.begin(), map.log_weight.end());
    joined.log_weight.resize(joined.point.size(), 0);
    projective = projective || !map.log_weight.empty();
    first_face += piece.surface.triangulation.num_faces();
  }
  if (!projective) joined.log_weight.clear();
  return joined;
}

}  // namespace cirque
