#include "cirque/mesh/split_chords.h"

#include <algorithm>
#include <array>
#include <utility>

namespace cirque {
namespace {

/// A corner of a polygon with the label of the side that follows. Sides of one label are one edge.
struct Point {
  Index vertex;
  bool is_middle;
  Index side;
};

class EdgeSplitter {
 public:
  EdgeSplitter(const Surface& surface, const std::vector<bool>& edges)
      : old_(surface), t_(surface.triangulation), labels_(2 * t_.num_edges()) {
    split_.position = surface.position;
    split_.soup_vertex = surface.soup_vertex;
    middle_.assign(t_.num_edges(), kNone);
    for (Index e = 0; e < t_.num_edges(); ++e) {
      if (edges[e]) AddMiddle(e);
    }
  }

  Surface Run() && {
    for (Index f = 0; f < t_.num_faces(); ++f) CutFace(f);
    Glue();
    split_.triangulation = NumberEdges(static_cast<Index>(split_.position.size()),
                                       std::move(vertex_), std::move(twin_));
    return std::move(split_);
  }

 private:
  void AddMiddle(Index e) {
    const Index h = t_.edge_halfedge[e];
    middle_[e] = static_cast<Index>(split_.position.size());
    split_.position.push_back(old_.position[t_.Tail(h)] +
                              0.5 * (old_.position[t_.Tip(h)] - old_.position[t_.Tail(h)]));
    split_.soup_vertex.push_back(kNone);
  }

  /// The corners of a face with the middles between them.
  std::vector<Point> PolygonOf(Index f) const {
    std::vector<Point> polygon;
    for (Index k = 0; k < 3; ++k) {
      const Index h = 3 * f + (k + 2) % 3;  // from corner k to the next
      const Index e = t_.edge[h];
      // The halves of an edge by the order in which its smaller halfedge runs along them.
      const Index first = t_.edge_halfedge[e] == h ? 0 : 1;
      const bool is_split = middle_[e] != kNone;
      polygon.push_back({t_.vertex[3 * f + k], false, 2 * e + (is_split ? first : 0)});
      if (is_split) polygon.push_back({middle_[e], true, 2 * e + 1 - first});
    }
    return polygon;
  }

  /// Ears at corners between middles first, so that no triangle has all of its corners where it had
  /// them.
  void CutFace(Index f) {
    std::vector<Point> polygon = PolygonOf(f);
    while (polygon.size() > 3) {
      const std::size_t n = polygon.size();
      std::size_t ear = 0;
      int best = -1;
      for (std::size_t i = 0; i < n; ++i) {
        if (polygon[i].is_middle) continue;
        const int middles = polygon[(i + n - 1) % n].is_middle + polygon[(i + 1) % n].is_middle;
        if (middles > best) best = middles, ear = i;
      }
      std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>((ear + n - 1) % n),
                  polygon.end());
      const Index diagonal = labels_++;
      AddTriangle({polygon[0], polygon[1], {polygon[2].vertex, false, diagonal}}, f);
      polygon[0].side = diagonal;
      polygon.erase(polygon.begin() + 1);
    }
    AddTriangle({polygon[0], polygon[1], polygon[2]}, f);
  }

  void AddTriangle(const std::array<Point, 3>& corners, Index f) {
    for (int k = 0; k < 3; ++k) {
      vertex_.push_back(corners[k].vertex);
      label_.push_back(corners[(k + 1) % 3].side);
      split_.soup_corner.push_back(kNone);
    }
    split_.soup_polygon.push_back(old_.soup_polygon[f]);
  }

  void Glue() {
    std::vector<Index> holder(labels_, kNone);
    twin_.assign(label_.size(), kNone);
    for (Index h = 0; h < static_cast<Index>(label_.size()); ++h) {
      Index& other = holder[label_[h]];
      if (other == kNone) {
        other = h;
      } else {
        twin_[h] = other;
        twin_[other] = h;
      }
    }
  }

  const Surface& old_;
  const Triangulation& t_;
  Index labels_;
  std::vector<Index> middle_;  ///< per old edge
  Surface split_;
  std::vector<Index> vertex_, twin_, label_;  ///< per new halfedge
};

}  // namespace

std::vector<bool> ChordsOf(const Triangulation& t, const std::vector<Index>& loop) {
  std::vector<bool> on_loop(t.num_vertices, false), chords(t.num_edges(), false);
  for (const Index h : loop) on_loop[t.Tail(h)] = true;
  for (Index e = 0; e < t.num_edges(); ++e) {
    const Index h = t.edge_halfedge[e];
    chords[e] = !t.IsBoundaryEdge(e) && on_loop[t.Tail(h)] && on_loop[t.Tip(h)];
  }
  return chords;
}

Surface SplitEdges(const Surface& surface, const std::vector<bool>& edges) {
  return EdgeSplitter(surface, edges).Run();
}

std::vector<Index> FacesBeforeSplit(const Triangulation& t, const std::vector<bool>& edges) {
  std::vector<Index> before;
  for (Index f = 0; f < t.num_faces(); ++f) {
    before.push_back(f);
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (edges[t.edge[h]]) before.push_back(f);
    }
  }
  return before;
}

}  // namespace cirque
