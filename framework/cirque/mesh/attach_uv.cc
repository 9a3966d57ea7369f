// AttachUv and UvOfCorners of surface.h.
#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include <glog/logging.h>

#include "cirque/core/grouping.h"
#include "cirque/math/image_overlap.h"
#include "cirque/mesh/surface.h"

namespace cirque {
namespace {

using Uv = Eigen::Vector2d;

/// Whether the triangles [first, last) of a polygon cover some points of the image twice, as those of a
/// polygon that is far from flat may: its border alone would not say what it covers.
bool CoversItself(const MappedSurface& mapped, Index first, Index last) {
  const Triangulation& t = mapped.surface.triangulation;
  const auto begin = mapped.uv.value.begin();
  const std::vector<Uv> uv(begin + 3 * first, begin + 3 * last);
  std::vector<Index> twin;
  for (Index h = 3 * first; h < 3 * last; ++h) {
    const Index g = t.twin[Triangulation::Prev(h)];
    const Index side = g == kNone ? kNone : Triangulation::Next(g);
    // Where a polygon touches itself along a bridge the image may be open.
    const bool inside = g != kNone && g >= 3 * first && g < 3 * last &&
                        begin[h] == begin[Triangulation::Next(side)] &&
                        begin[Triangulation::Next(h)] == begin[side];
    twin.push_back(inside ? side - 3 * first : kNone);
  }
  return FindImageOverlap({uv, twin}).overlaps();
}

/// How many triangles fill a polygon that comes to no vertex twice but in a row.
Index NumTriangles(const PolygonSoup& input, Index p) {
  Index sides = 0, before = input.corner[input.first_corner[p + 1] - 1];
  for (Index c = input.first_corner[p]; c < input.first_corner[p + 1]; ++c) {
    sides += input.corner[c] != before;
    before = input.corner[c];
  }
  return sides - 2;
}

/// Polygons that have fewer triangles than fill their border: loops that are apart in the image.
void FindLoops(const PolygonSoup& input, const std::vector<Index>& num_triangles,
               std::vector<bool>* torn) {
  for (Index p = 0; p < input.num_polygons(); ++p) {
    if (num_triangles[p] > 0 && num_triangles[p] < NumTriangles(input, p)) (*torn)[p] = true;
  }
}

/// The UV of every corner of the input, null where no surface has it, and the polygons that cannot
/// stand as they are: their triangles do not agree on one, cover each other, or are loops.
struct CornerSources {
  std::vector<const Uv*> uv;
  std::vector<bool> torn;
};

CornerSources FindSources(const PolygonSoup& input, const std::vector<MappedSurface>& surfaces) {
  CornerSources sources{std::vector<const Uv*>(input.corner.size(), nullptr),
                        std::vector<bool>(input.num_polygons(), false)};
  std::vector<Index> num_triangles(input.num_polygons(), 0);
  for (const auto& [surface, uv] : surfaces) {
    CHECK_EQ(uv.value.size(), surface.triangulation.vertex.size());
    for (std::size_t h = 0; h < uv.value.size(); ++h) {
      const Uv*& source = sources.uv[surface.soup_corner[h]];
      if (source == nullptr) source = &uv.value[h];
      if (*source != uv.value[h]) sources.torn[surface.soup_polygon[h / 3]] = true;
    }
    // A polygon's triangles follow one another; a quadrilateral's two cannot cover each other.
    const auto num_faces = static_cast<Index>(surface.soup_polygon.size());
    for (Index first = 0, last = 0; first < num_faces; first = last) {
      const Index p = surface.soup_polygon[first];
      while (last < num_faces && surface.soup_polygon[last] == p) ++last;
      if (p == kNone) continue;
      num_triangles[p] += last - first;
      if (last - first < 3 || sources.torn[p]) continue;
      sources.torn[p] = CoversItself({surface, uv}, first, last);
    }
  }
  FindLoops(input, num_triangles, &sources.torn);
  return sources;
}

/// What the corners of a polygon get that has them in part: that of its corner at the same vertex,
/// else of the one before.
void CompletePolygon(const PolygonSoup& input, Index p, std::vector<const Uv*>* uv) {
  const Index first = input.first_corner[p], size = input.first_corner[p + 1] - first;
  const auto begin = uv->begin() + first;
  const std::vector<const Uv*> known(begin, begin + size);
  for (Index i = 0; i < size; ++i) {
    if (known[i] != nullptr) continue;
    for (Index back = 1; back < size && begin[i] == nullptr; ++back) {
      begin[i] = known[(i + size - back) % size];
    }
    for (Index j = 0; j < size; ++j) {
      const bool same = input.corner[first + i] == input.corner[first + j];
      if (same && known[j] != nullptr) begin[i] = known[j];
    }
  }
}

/// What the corners that no surface has get; `nowhere` where nothing is near.
void Complete(const PolygonSoup& input, const Uv* nowhere, std::vector<const Uv*>* uv) {
  std::vector<const Uv*> at_vertex(input.position.size(), nullptr);
  for (std::size_t c = 0; c < uv->size(); ++c) {
    const Uv*& known = at_vertex[input.corner[c]];
    if (known == nullptr) known = (*uv)[c];
  }
  const auto is_null = [](const auto* known) { return known == nullptr; };
  for (Index p = 0; p < input.num_polygons(); ++p) {
    const auto begin = uv->begin() + input.first_corner[p];
    const auto end = uv->begin() + input.first_corner[p + 1];
    if (std::none_of(begin, end, is_null)) continue;
    if (!std::all_of(begin, end, is_null)) {
      CompletePolygon(input, p, uv);
      continue;
    }
    const Uv* place = nowhere;
    for (Index c = input.first_corner[p]; c < input.first_corner[p + 1]; ++c) {
      if (place == nowhere && !is_null(at_vertex[input.corner[c]])) {
        place = at_vertex[input.corner[c]];
      }
    }
    std::fill(begin, end, place);
  }
}

/// A soup that grows, with the UV that each of its corners gets.
struct GrowingSoup {
  PolygonSoup soup;
  std::vector<const Uv*> uv;

  void AddCorner(Index vertex, const Uv* at) {
    soup.corner.push_back(vertex);
    uv.push_back(at);
  }
  void EndPolygon() { soup.first_corner.push_back(static_cast<Index>(soup.corner.size())); }
};

using TornFaces = std::map<Index, std::vector<std::pair<const MappedSurface*, Index>>>;

/// The triangles of every polygon that is torn.
TornFaces CollectTorn(const std::vector<MappedSurface>& surfaces, const std::vector<bool>& torn) {
  TornFaces faces;
  if (std::find(torn.begin(), torn.end(), true) == torn.end()) return faces;
  for (const MappedSurface& mapped : surfaces) {
    for (Index f = 0; f < mapped.surface.triangulation.num_faces(); ++f) {
      const Index p = mapped.surface.soup_polygon[f];
      if (torn[p]) faces[p].emplace_back(&mapped, f);
    }
  }
  return faces;
}

GrowingSoup WithoutTexture(const PolygonSoup& input, const std::vector<MappedSurface>& surfaces,
                           const CornerSources& sources) {
  GrowingSoup grown;
  grown.soup.position = input.position;
  grown.soup.corner.reserve(input.corner.size());
  grown.uv.reserve(input.corner.size());
  const TornFaces torn = CollectTorn(surfaces, sources.torn);
  for (Index p = 0; p < input.num_polygons(); ++p) {
    if (const auto found = torn.find(p); found != torn.end()) {
      for (const auto& [mapped, f] : found->second) {
        for (Index h = 3 * f; h < 3 * f + 3; ++h) {
          grown.AddCorner(input.corner[mapped->surface.soup_corner[h]], &mapped->uv.value[h]);
        }
        grown.EndPolygon();
      }
      continue;
    }
    for (Index c = input.first_corner[p]; c < input.first_corner[p + 1]; ++c) {
      grown.AddCorner(input.corner[c], sources.uv[c]);
    }
    grown.EndPolygon();
  }
  return grown;
}

/// Gives the corners [first, last) of one vertex their texture coordinates, one for each different
/// UV.
void AttachAtVertex(std::vector<Index>::iterator first, std::vector<Index>::iterator last,
                    GrowingSoup* grown) {
  const auto at = [&](Index corner) -> const Uv& { return *grown->uv[corner]; };
  const auto key = [&](Index corner) { return std::tuple(at(corner).x(), at(corner).y(), corner); };
  std::sort(first, last, [&](Index a, Index b) { return key(a) < key(b); });
  PolygonSoup& soup = grown->soup;
  for (auto corner = first; corner != last; ++corner) {
    if (corner == first || at(*corner) != at(*(corner - 1))) soup.texture.push_back(at(*corner));
    soup.corner_texture[*corner] = static_cast<Index>(soup.texture.size()) - 1;
  }
}

}  // namespace

PolygonSoup AttachUv(const PolygonSoup& input, const std::vector<MappedSurface>& surfaces) {
  const Uv nowhere = Uv::Zero();
  CornerSources sources = FindSources(input, surfaces);
  Complete(input, &nowhere, &sources.uv);
  GrowingSoup grown = WithoutTexture(input, surfaces, sources);
  PolygonSoup& soup = grown.soup;
  soup.corner_texture.resize(soup.corner.size());
  Buckets corners_at = SortIntoBuckets(soup.corner, static_cast<Index>(soup.position.size()));
  for (std::size_t v = 0; v < soup.position.size(); ++v) {
    AttachAtVertex(corners_at.item.begin() + corners_at.first[v],
                   corners_at.item.begin() + corners_at.first[v + 1], &grown);
  }
  return std::move(grown.soup);
}

std::vector<Eigen::Vector2d> UvOfCorners(const PolygonSoup& input,
                                         const std::vector<MappedSurface>& surfaces) {
  const Uv nowhere = Uv::Zero();
  CornerSources sources = FindSources(input, surfaces);
  Complete(input, &nowhere, &sources.uv);
  std::vector<Eigen::Vector2d> uv;
  uv.reserve(sources.uv.size());
  for (const Uv* const source : sources.uv) uv.push_back(*source);
  return uv;
}

PolygonSoup AttachUv(const PolygonSoup& input, const Surface& surface, const CornerUv& uv) {
  return AttachUv(input, {{surface, uv}});
}

}  // namespace cirque
