#include "cirque/mesh/surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

#include <glog/logging.h>

#include "cirque/core/grouping.h"

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

/// Gives the corners [first, last) of one vertex their texture coordinates, one for each different
/// UV.
void AttachAtVertex(const CornerUv& uv, std::vector<Index>::iterator first,
                    std::vector<Index>::iterator last, PolygonSoup* soup) {
  const auto key = [&](Index corner) {
    return std::tuple(uv.value[corner].x(), uv.value[corner].y(), corner);
  };
  std::sort(first, last, [&](Index a, Index b) { return key(a) < key(b); });
  for (auto corner = first; corner != last; ++corner) {
    if (corner == first || uv.value[*corner] != uv.value[*(corner - 1)]) {
      soup->texture.push_back(uv.value[*corner]);
    }
    soup->corner_texture[*corner] = static_cast<Index>(soup->texture.size()) - 1;
  }
}

}  // namespace

PolygonSoup AttachUv(const PolygonSoup& input, const Surface& surface, const CornerUv& uv) {
  const Triangulation& t = surface.triangulation;
  CHECK_EQ(uv.value.size(), t.vertex.size());
  PolygonSoup soup;
  soup.position = input.position;
  soup.first_corner.resize(t.num_faces() + 1);
  for (Index f = 0; f <= t.num_faces(); ++f) soup.first_corner[f] = 3 * f;
  soup.corner.reserve(t.vertex.size());
  for (const Index v : t.vertex) soup.corner.push_back(surface.soup_vertex[v]);
  soup.corner_texture.resize(t.vertex.size());
  Buckets corners_at = SortIntoBuckets(t.vertex, t.num_vertices);
  for (Index v = 0; v < t.num_vertices; ++v) {
    AttachAtVertex(uv, corners_at.item.begin() + corners_at.first[v],
                   corners_at.item.begin() + corners_at.first[v + 1], &soup);
  }
  return soup;
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
