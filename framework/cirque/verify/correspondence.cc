#include "cirque/verify/correspondence.h"

#include <algorithm>
#include <set>
#include <utility>

namespace cirque::verify {
namespace {

/// The names of a face's corners from one corner on, forwards or backwards.
struct Cycle {
  const NamedFaces* faces;
  Index face;
  Index start = 0;
  bool backwards = false;

  Index size() const { return faces->NumCorners(face); }
  Index operator[](Index k) const {
    const Index n = size();
    const Index ahead = start + k < n ? start + k : start + k - n;
    return faces->Name(face, backwards ? n - 1 - ahead : ahead);
  }
};

/// -1, 0, +1 as a comes before b, has the same names, comes after b.
int Compare(const Cycle& a, const Cycle& b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  for (Index k = 0; k < a.size(); ++k) {
    if (a[k] != b[k]) return a[k] < b[k] ? -1 : 1;
  }
  return 0;
}

/// From the corner from which it comes first.
Cycle Normalized(const NamedFaces& faces, Index face, bool backwards) {
  Cycle best{&faces, face, 0, backwards}, other = best;
  for (other.start = 1; other.start < best.size(); ++other.start) {
    if (other[0] <= best[0] && Compare(other, best) < 0) best = other;
  }
  return best;
}

bool IsNamed(const NamedFaces& faces, Index face) {
  for (Index k = 0; k < faces.NumCorners(face); ++k) {
    if (faces.Name(face, k) == kNone) return false;
  }
  return true;
}

std::vector<Cycle> SortedCycles(const NamedFaces& faces, const std::vector<char>& taken,
                                bool backwards) {
  std::vector<Cycle> cycles;
  for (Index f = 0; f < faces.num_faces(); ++f) {
    if (!taken[f] && IsNamed(faces, f)) cycles.push_back(Normalized(faces, f, backwards));
  }
  std::sort(cycles.begin(), cycles.end(), [](const Cycle& a, const Cycle& b) {
    const int order = Compare(a, b);
    return order != 0 ? order < 0 : a.face < b.face;
  });
  return cycles;
}

using NamedEdge = std::pair<Index, Index>;

/// Those between two names: pieces of a polygon know nothing of corners that repeat the one before.
void AppendEdges(const NamedFaces& faces, Index f, bool backwards, std::vector<NamedEdge>* edges) {
  const Cycle cycle{&faces, f, 0, backwards};
  for (Index k = 0; k < cycle.size(); ++k) {
    const NamedEdge edge(cycle[k], cycle[k + 1 < cycle.size() ? k + 1 : 0]);
    if (edge.first != edge.second) edges->push_back(edge);
  }
}

/// How many triangles fill a polygon, corners that repeat the one before counted once; of one with
/// less than three others, as if they were not counted so.
Index NumTriangles(const NamedFaces& faces, Index f) {
  const Index n = faces.NumCorners(f);
  Index sides = 0;
  for (Index k = 0; k < n; ++k) sides += faces.Name(f, k) != faces.Name(f, k + 1 < n ? k + 1 : 0);
  return (sides < 3 ? n : sides) - 2;
}

class Matcher {
 public:
  Matcher(const NamedFaces& in, const NamedFaces& out)
      : in_(in), out_(out), in_taken_(in.num_faces()), out_taken_(out.num_faces()) {}

  Correspondence Match() {
    if (!MatchInOrder()) {
      Forget();
      MatchWholeFaces(false);
      MatchWholeFaces(true);
      MatchPieces();
    }
    return Finish();
  }

 private:
  void Forget() {
    result_ = {};
    std::fill(in_taken_.begin(), in_taken_.end(), false);
    std::fill(out_taken_.begin(), out_taken_.end(), false);
    result_.out_face.assign(in_.num_faces(), kNone);
  }

  bool IsWhole(Index f, const std::vector<Index>& faces_of_out) const {
    return faces_of_out.size() == 1 && out_.NumCorners(faces_of_out[0]) == in_.NumCorners(f);
  }

  void Take(Index f, const std::vector<Index>& faces_of_out, bool backwards) {
    in_taken_[f] = true;
    for (const Index g : faces_of_out) out_taken_[g] = true;
    if (IsWhole(f, faces_of_out)) {
      result_.out_face[f] = faces_of_out[0];
    } else {
      result_.pieces[f] = faces_of_out;
    }
    if (backwards) result_.reversed.push_back(f);
  }

  /// Whether OUT lists the faces, or their pieces, as IN does; if so, takes them all.
  bool MatchInOrder() {
    Forget();
    Index g = 0;
    for (Index f = 0; f < in_.num_faces(); ++f) {
      std::vector<Index> faces_of_out;
      for (Index missing = NumTriangles(in_, f); missing > 0 && g < out_.num_faces(); ++g) {
        faces_of_out.push_back(g);
        missing -= out_.NumCorners(g) - 2;
      }
      if (!IsBorder(f, faces_of_out, false)) return false;
      Take(f, faces_of_out, false);
    }
    return g == out_.num_faces();
  }

  void MatchWholeFaces(bool backwards) {
    const std::vector<Cycle> a = SortedCycles(in_, in_taken_, false);
    const std::vector<Cycle> b = SortedCycles(out_, out_taken_, backwards);
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
      const int order = Compare(a[i], b[j]);
      if (order == 0) Take(a[i].face, {b[j].face}, backwards);
      if (order <= 0) ++i;
      if (order >= 0) ++j;
    }
  }

  /// Whether the faces of OUT, glued where two have an edge in opposite directions, have the border
  /// of face f of IN, and as many corners as such pieces have. Loops that hang together at a vertex
  /// or by a bridge have less, each for itself.
  bool IsBorder(Index f, const std::vector<Index>& faces_of_out, bool backwards) const {
    if (IsWhole(f, faces_of_out)) {
      const Index g = faces_of_out[0];
      return IsNamed(out_, g) &&
             Compare(Normalized(in_, f, false), Normalized(out_, g, backwards)) == 0;
    }
    Index missing = NumTriangles(in_, f);
    for (const Index g : faces_of_out) {
      missing -= out_.NumCorners(g) - 2;
      if (missing < 0 || !IsNamed(out_, g)) return false;
    }
    std::vector<NamedEdge> border, edges, other_sides;
    AppendEdges(in_, f, false, &border);
    std::set<Index> names;
    for (const NamedEdge& edge : border) names.insert(edge.first);
    const bool has_loops = names.size() < border.size() && missing % 2 == 0;
    if (faces_of_out.empty() || (missing != 0 && !has_loops)) return false;
    for (const Index g : faces_of_out) {
      if (!HasOnly(g, names)) return false;
    }
    // With the border's other side all edges have another side.
    for (const Index g : faces_of_out) AppendEdges(out_, g, backwards, &edges);
    for (const auto& [tail, tip] : border) edges.emplace_back(tip, tail);
    for (const auto& [tail, tip] : edges) other_sides.emplace_back(tip, tail);
    std::sort(edges.begin(), edges.end());
    std::sort(other_sides.begin(), other_sides.end());
    return edges == other_sides;
  }

  /// An edge of a face of OUT in the direction in which a face of IN would have it.
  struct PieceEdge {
    NamedEdge edge;
    Index face;

    bool operator<(const PieceEdge& other) const {
      return edge != other.edge ? edge < other.edge : face < other.face;
    }
  };

  void MatchPieces() {
    for (const bool backwards : {false, true}) {
      std::vector<PieceEdge> edges;
      for (Index g = 0; g < out_.num_faces(); ++g) {
        if (out_taken_[g] || !IsNamed(out_, g)) continue;
        std::vector<NamedEdge> of_face;
        AppendEdges(out_, g, backwards, &of_face);
        for (const NamedEdge& edge : of_face) edges.push_back({edge, g});
      }
      std::sort(edges.begin(), edges.end());
      for (Index f = 0; f < in_.num_faces(); ++f) {
        if (in_taken_[f] || in_.NumCorners(f) == 3) continue;
        const std::vector<Index> found = CollectPieces(f, edges, backwards);
        if (IsBorder(f, found, backwards)) Take(f, found, backwards);
      }
    }
  }

  /// From the border inwards: the faces with corners of f alone that have the edges wanted, then
  /// those that have the other sides of their edges.
  std::vector<Index> CollectPieces(Index f, const std::vector<PieceEdge>& edges,
                                   bool backwards) const {
    std::vector<NamedEdge> wanted;
    AppendEdges(in_, f, false, &wanted);
    std::set<Index> names;
    for (const NamedEdge& edge : wanted) names.insert(edge.first);
    // A bridge or spur has pieces of the face on both sides or on none.
    const std::set<NamedEdge> border(wanted.begin(), wanted.end());
    std::erase_if(wanted, [&](const NamedEdge& edge) {
      return border.contains({edge.second, edge.first});
    });
    std::set<NamedEdge> had;
    std::set<Index> found;
    Index missing = NumTriangles(in_, f);
    for (std::size_t i = 0; i < wanted.size() && missing > 0; ++i) {
      if (had.contains(wanted[i])) continue;
      const Index g = PieceWith(wanted[i], names, edges);
      if (g == kNone || !found.insert(g).second) continue;
      missing -= out_.NumCorners(g) - 2;
      std::vector<NamedEdge> of_piece;
      AppendEdges(out_, g, backwards, &of_piece);
      for (const auto& [tail, tip] : of_piece) {
        had.emplace(tail, tip);
        if (!border.contains({tail, tip})) wanted.emplace_back(tip, tail);
      }
    }
    return {found.begin(), found.end()};
  }

  Index PieceWith(const NamedEdge& edge, const std::set<Index>& names,
                  const std::vector<PieceEdge>& edges) const {
    for (auto it = std::lower_bound(edges.begin(), edges.end(), PieceEdge{edge, 0});
         it != edges.end() && it->edge == edge; ++it) {
      if (!out_taken_[it->face] && HasOnly(it->face, names)) return it->face;
    }
    return kNone;
  }

  bool HasOnly(Index g, const std::set<Index>& names) const {
    for (Index k = 0; k < out_.NumCorners(g); ++k) {
      if (!names.contains(out_.Name(g, k))) return false;
    }
    return true;
  }

  Correspondence Finish() {
    Index last = -1;
    result_.same_order = true;
    for (Index f = 0; f < in_.num_faces(); ++f) {
      if (!in_taken_[f]) result_.missing.push_back(f);
      const auto cut = result_.pieces.find(f);
      const Index first = cut != result_.pieces.end() ? cut->second.front() : result_.out_face[f];
      result_.same_order = result_.same_order && first > last;
      last = cut != result_.pieces.end() ? cut->second.back() : first;
    }
    for (Index g = 0; g < out_.num_faces(); ++g) {
      if (!out_taken_[g]) result_.extra.push_back(g);
    }
    std::sort(result_.reversed.begin(), result_.reversed.end());
    return std::move(result_);
  }

  const NamedFaces& in_;
  const NamedFaces& out_;
  std::vector<char> in_taken_, out_taken_;
  Correspondence result_;
};

}  // namespace

NamedFaces NameCorners(const PolygonSoup& soup, const std::vector<Index>& vertex_name) {
  NamedFaces faces{soup.first_corner, {}};
  faces.name.reserve(soup.corner.size());
  for (const Index v : soup.corner) faces.name.push_back(vertex_name[v]);
  return faces;
}

Correspondence MatchFaces(const NamedFaces& in, const NamedFaces& out) {
  return Matcher(in, out).Match();
}

}  // namespace cirque::verify
