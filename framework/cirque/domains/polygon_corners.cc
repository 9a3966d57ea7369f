#include "cirque/domains/polygon_corners.h"

#include <algorithm>
#include <complex>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/intrinsic/intrinsic_surface.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

/// The pieces into which the chords cut the disk.
Patches PiecesBetweenChords(const Triangulation& t, const std::vector<bool>& boundary) {
  Triangulation cut = t;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (boundary[t.Tail(h)] && boundary[t.Tip(h)]) cut.twin[h] = kNone;
  }
  return ConnectedPatches(cut);
}

}  // namespace

std::vector<Index> BoundaryInOrder(const Triangulation& t) {
  std::vector<Index> vertices = BoundaryLoops(t).front();
  for (Index& h : vertices) h = t.Tail(h);
  return vertices;
}

Status SortCorners(const Triangulation& t, std::vector<Index>* corners) {
  const std::vector<Index> loop = BoundaryInOrder(t);
  std::vector<Index> sorted;
  const auto first = std::find(loop.begin(), loop.end(), corners->front());
  for (std::size_t i = 0; first != loop.end() && i < loop.size(); ++i) {
    const Index v = loop[(static_cast<std::size_t>(first - loop.begin()) + i) % loop.size()];
    if (std::count(corners->begin(), corners->end(), v) == 1) sorted.push_back(v);
  }
  if (sorted.size() == corners->size()) {
    *corners = sorted;
    return Status();
  }
  return Status::InvalidInput(fmt::format(
      "corners {} (0-based) must be different vertices of the boundary", IdList(*corners)));
}

std::vector<Index> CornersBeyondChords(const Triangulation& t) {
  const Patches pieces = PiecesBetweenChords(t, BoundaryVertices(t));
  std::vector<int> chords(pieces.count, 0);
  const auto piece = [&](Index h) { return pieces.of_face[Triangulation::Face(h)]; };
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (t.twin[h] != kNone && piece(h) != piece(t.twin[h])) ++chords[piece(h)];
  }
  std::vector<Index> loop = BoundaryLoops(t).front();
  const auto turns = [&](Index h) { return piece(h) != piece(loop.front()); };
  const auto start = std::find_if(loop.begin(), loop.end(), turns);
  if (start == loop.end()) return {};
  std::rotate(loop.begin(), start, loop.end());
  std::vector<Index> corners;
  for (std::size_t begin = 0, end = 0; begin < loop.size(); begin = end) {
    while (end < loop.size() && piece(loop[end]) == piece(loop[begin])) ++end;
    if (chords[piece(loop[begin])] == 1) corners.push_back(t.Tip(loop[(begin + end - 1) / 2]));
  }
  return corners;
}

std::vector<Index> NearlyRegularCorners(const Triangulation& t, const CornerUv& in_disk,
                                        int sides) {
  std::vector<Complex> place(t.num_vertices);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    place[t.vertex[h]] = {in_disk.value[h].x(), in_disk.value[h].y()};
  }
  const std::vector<Index> loop = BoundaryInOrder(t);
  const std::vector<Index> needed = CornersBeyondChords(t);
  std::vector<Complex> wanted;
  for (int k = 0; k < sides; ++k) {
    wanted.push_back(std::polar(1.0, 2 * kPi * k / sides) *
                     place[needed.empty() ? loop[0] : needed[0]]);
  }
  std::vector<Index> corners;
  const auto take = [&](auto vertex, auto place_of) {
    corners.push_back(*vertex);
    wanted.erase(place_of);
  };
  for (auto v = needed.begin(); v != needed.end() && !wanted.empty(); ++v) {
    take(v, std::min_element(wanted.begin(), wanted.end(), [&](Complex a, Complex b) {
           return std::abs(place[*v] - a) < std::abs(place[*v] - b);
         }));
  }
  while (!wanted.empty()) {
    const auto distance = [&](Index v) {
      const bool taken = std::find(corners.begin(), corners.end(), v) != corners.end();
      return taken ? std::numeric_limits<double>::infinity() : std::abs(place[v] - wanted.front());
    };
    take(std::min_element(loop.begin(), loop.end(),
                          [&](Index a, Index b) { return distance(a) < distance(b); }),
         wanted.begin());
  }
  return corners;
}

}  // namespace cirque
