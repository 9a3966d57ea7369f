#include "cirque/mesh/surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>
#include <glog/logging.h>

#include "cirque/core/grouping.h"
#include "cirque/math/image_overlap.h"

namespace cirque {

EdgeLengths MeasureEdgeLengths(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  EdgeLengths lengths;
  lengths.value.resize(t.num_edges());
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    const Eigen::Vector3d edge = surface.position[t.Tip(h)] - surface.position[t.Tail(h)];
    lengths.value[e] = std::hypot(edge.x(), edge.y(), edge.z());
  }
  return lengths;
}

namespace {

constexpr double kNeedle = 1e-6;  ///< [rad]

/// The angle at p between q and r.
double AngleAt(const Eigen::Vector3d& p, const Eigen::Vector3d& q, const Eigen::Vector3d& r) {
  const Eigen::Vector3d a = q - p, b = r - p;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

void MeasureNeedles(const Surface& surface, CornerAngles* angles) {
  const Triangulation& t = surface.triangulation;
  for (Index f = 0; f < t.num_faces(); ++f) {
    auto corner = angles->value.segment<3>(3 * f);
    Eigen::Index widest = 0;
    if (corner.minCoeff() >= kNeedle) continue;
    corner.maxCoeff(&widest);
    const auto point = [&](Eigen::Index k) -> const Eigen::Vector3d& {
      return surface.position[t.vertex[3 * f + k % 3]];
    };
    // Of long sides the differences are exact enough, of short ones the cross product.
    for (const Eigen::Index k : {(widest + 1) % 3, (widest + 2) % 3}) {
      corner[k] = AngleAt(point(k), point(k + 1), point(k + 2));
    }
    corner[widest] = kPi - corner[(widest + 1) % 3] - corner[(widest + 2) % 3];
  }
}

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
void FindLoops(const PolygonSoup& input, const std::vector<MappedSurface>& surfaces,
               std::vector<bool>* torn) {
  std::vector<Index> count(input.num_polygons(), 0);
  for (const MappedSurface& mapped : surfaces) {
    for (const Index p : mapped.surface.soup_polygon) {
      if (p != kNone) ++count[p];
    }
  }
  for (Index p = 0; p < input.num_polygons(); ++p) {
    if (count[p] > 0 && count[p] < NumTriangles(input, p)) (*torn)[p] = true;
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
      if (last - first < 3 || p == kNone || sources.torn[p]) continue;
      sources.torn[p] = CoversItself({surface, uv}, first, last);
    }
  }
  FindLoops(input, surfaces, &sources.torn);
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

std::vector<bool> EdgesInsidePolygons(const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  const std::vector<Index>& corner = surface.soup_corner;
  std::vector<bool> inside(t.num_edges(), false);
  if (corner.empty()) return inside;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e], g = t.twin[h];
    if (g == kNone || corner[h] == kNone) continue;
    inside[e] = corner[Triangulation::Next(h)] == corner[Triangulation::Prev(g)] &&
                corner[Triangulation::Prev(h)] == corner[Triangulation::Next(g)];
  }
  return inside;
}

PolygonSoup TrianglesOf(const Surface& surface) {
  PolygonSoup soup;
  soup.position = surface.position;
  soup.corner = surface.triangulation.vertex;
  for (Index f = 1; f <= surface.triangulation.num_faces(); ++f) {
    soup.first_corner.push_back(3 * f);
  }
  return soup;
}

namespace {

using Ends = std::pair<Index, Index>;

Ends EndsOfSide(const std::vector<Index>& corner, Index h) {
  const Index from = corner[h % 3 == 2 ? h - 2 : h + 1], to = corner[h % 3 == 0 ? h + 2 : h - 1];
  return std::minmax(from, to);
}

/// The sides opposite the corners, numbered so that equal ends have equal numbers, in the order in
/// which they first appear.
std::vector<Index> NumberSides(const std::vector<Index>& corner, std::vector<Ends>* ends) {
  std::vector<Index> order(corner.size()), number(corner.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return EndsOfSide(corner, a) < EndsOfSide(corner, b); });
  std::vector<Index> first(corner.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && EndsOfSide(corner, order[i]) == EndsOfSide(corner, order[i - 1]);
    first[order[i]] = same ? first[order[i - 1]] : order[i];
  }
  for (Index h = 0; h < static_cast<Index>(corner.size()); ++h) {
    if (first[h] == h) {
      number[h] = static_cast<Index>(ends->size());
      ends->push_back(EndsOfSide(corner, h));
    } else {
      number[h] = number[first[h]];
    }
  }
  return number;
}

PolygonSoup SubdivideOnce(const PolygonSoup& soup) {
  std::vector<Ends> ends;
  const std::vector<Index> side = NumberSides(soup.corner, &ends);
  PolygonSoup fine;
  fine.position = soup.position;
  for (const auto& [a, b] : ends) {
    fine.position.push_back(0.5 * (soup.position[a] + soup.position[b]));
  }
  const auto old_count = static_cast<Index>(soup.position.size());
  fine.corner.reserve(4 * soup.corner.size());
  for (std::size_t c = 0; c < soup.corner.size(); c += 3) {
    const Index* v = &soup.corner[c];
    const Index m[3] = {old_count + side[c], old_count + side[c + 1], old_count + side[c + 2]};
    const Index corners[] = {v[0], m[2], m[1], m[2], v[1], m[0],
                             m[1], m[0], v[2], m[0], m[1], m[2]};
    fine.corner.insert(fine.corner.end(), std::begin(corners), std::end(corners));
  }
  for (std::size_t c = 3; c <= fine.corner.size(); c += 3) {
    fine.first_corner.push_back(static_cast<Index>(c));
  }
  return fine;
}

}  // namespace

PolygonSoup MidpointSubdivision(const PolygonSoup& soup, int levels) {
  CHECK_EQ(soup.corner.size(), 3 * static_cast<std::size_t>(soup.num_polygons()));
  PolygonSoup result = soup;
  for (int level = 0; level < levels; ++level) result = SubdivideOnce(result);
  return result;
}

}  // namespace cirque
