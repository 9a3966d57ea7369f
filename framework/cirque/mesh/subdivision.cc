#include "cirque/mesh/subdivision.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <glog/logging.h>

namespace cirque {
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
