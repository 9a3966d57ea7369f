#pragma once

#include "cirque/io/polygon_soup.h"

#include "tests/common/surfaces.h"

namespace cirque {

/// A grid of quads around and across, each cut in two, at point(angle, part of the way across);
/// `wrap`: across is closed too.
template <class Point>
Surface Grid(int around, int across, bool wrap, const Point& point) {
  PolygonSoup soup;
  const int rows = wrap ? across : across + 1;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < around; ++i) {
      soup.position.push_back(point(2 * kPi * i / around, static_cast<double>(j) / across));
    }
  }
  const auto number = [&](int i, int j) { return (j % rows) * around + i % around; };
  for (int j = 0; j < across; ++j) {
    for (int i = 0; i < around; ++i) {
      const int a = number(i, j), b = number(i + 1, j), c = number(i + 1, j + 1),
                d = number(i, j + 1);
      for (const int v : {a, b, c, a, c, d}) soup.corner.push_back(v);
      for (int k = 1; k <= 2; ++k) {
        soup.first_corner.push_back(static_cast<Index>(soup.corner.size()) - 6 + 3 * k);
      }
    }
  }
  return SurfaceOf(soup);
}

}  // namespace cirque
