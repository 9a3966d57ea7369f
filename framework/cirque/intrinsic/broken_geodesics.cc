#include "cirque/intrinsic/broken_geodesics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "cirque/intrinsic/ideal_geodesic.h"
#include "cirque/intrinsic/normal_coordinates.h"
#include "cirque/intrinsic/straight_lines.h"
#include "cirque/math/log_triangle.h"

namespace cirque {
namespace {

using Point = Eigen::Vector2d;  ///< barycentric coordinates of a face's corners 1 and 2

Index Next(Index h) { return Triangulation::Next(h); }
Index Prev(Index h) { return Triangulation::Prev(h); }

double Cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

Point AtCorner(Index corner) {
  return corner % 3 == 0 ? Point(0, 0) : corner % 3 == 1 ? Point(1, 0) : Point(0, 1);
}

/// At a fraction along a halfedge of its face.
Point Along(Index h, double fraction) {
  return (1 - fraction) * AtCorner(Next(h)) + fraction * AtCorner(Prev(h));
}

/// A part of an edge of the scaled triangulation in a face of the Delaunay one.
struct Chord {
  Index edge;  ///< its halfedge (Triangulation::edge_halfedge), from `from` to `to`
  Point from, to;
  double at_from, at_to;          ///< fractions along the halfedge
  double weight_from, weight_to;  ///< logarithms (Crossing::log_weight)
};

/// A point between two others of the Delaunay face, as it is between the scaled plane's.
struct Between {
  double fraction, log_weight;
};

Between Project(double fraction, double weight_from, double weight_to) {
  const double from = std::log1p(-fraction) + weight_from, to = std::log(fraction) + weight_to;
  const double log_weight = LogAddExp(from, to);
  return {std::exp(to - log_weight), log_weight};
}

/// The chords in every face of `delaunay`, out of its overlay with `scaled`; none where `shared` says
/// that an edge of it is one of `delaunay` itself.
std::vector<std::vector<Chord>> ChordsOf(const Overlay& overlay, const Triangulation& delaunay,
                                         const ScaledTriangulation& of,
                                         const std::vector<bool>& shared) {
  const Triangulation& scaled = of.scaled.triangulation;
  std::vector<std::vector<Chord>> chords(delaunay.num_faces());
  const auto is_vertex = [&](const Overlay::Corner& c) { return c.vertex < overlay.num_vertices; };
  const auto crossing = [&](const Overlay::Corner& c) -> const Crossing& {
    return overlay.crossing[c.vertex - overlay.num_vertices];
  };
  const auto place = [&](const Overlay::Corner& c) {
    if (is_vertex(c)) return AtCorner(c.input);
    const Crossing& x = crossing(c);
    return Along(c.input, c.input == x.input ? x.along_input : 1 - x.along_input);
  };
  const auto weight = [&](const Overlay::Corner& c) {
    return is_vertex(c) ? -of.log_scale[c.vertex] : crossing(c).log_weight;
  };
  // The halfedge of the scaled triangulation that a polygon's side runs along, seen from one end.
  const auto begins_on = [&](const Overlay::Corner& c, Index h) {
    return is_vertex(c) ? c.other == Next(h) : c.other == h;
  };
  const auto ends_on = [&](const Overlay::Corner& c, Index h) {
    return is_vertex(c) ? c.other == Prev(h) : c.other == h;
  };
  for (Index p = 0; p < overlay.num_faces(); ++p) {
    const Index first = overlay.first_corner[p], end = overlay.first_corner[p + 1];
    for (Index c = first; c < end; ++c) {
      const Overlay::Corner &a = overlay.corner[c],
                            &b = overlay.corner[c + 1 == end ? first : c + 1];
      for (Index h = 3 * overlay.other_face[p]; h < 3 * overlay.other_face[p] + 3; ++h) {
        if (scaled.edge_halfedge[scaled.edge[h]] != h || shared[scaled.edge[h]]) continue;
        if (!begins_on(a, h) || !ends_on(b, h)) continue;
        chords[overlay.input_face[p]].push_back(
            {h, place(a), place(b), is_vertex(a) ? 0 : crossing(a).along_other,
             is_vertex(b) ? 1 : crossing(b).along_other, weight(a), weight(b)});
      }
    }
  }
  return chords;
}

/// A crossing of a line with edges of the scaled triangulation.
struct Meeting {
  Index out;  ///< the halfedge of the face that it leaves
  double along_line, along_edge, log_weight;
};

class ThroughDelaunay {
 public:
  ThroughDelaunay(const ScaledTriangulation& of, const std::vector<Index>& ptolemy_flips,
                  const Overlay& of_delaunay)
      : of_(of),
        t_(of.delaunay.triangulation),
        straight_(StraightLines(t_, of.delaunay.lengths)),
        ideal_(IdealGeodesics(of.scaled.triangulation, of.scaled.lengths, of.log_scale)),
        line_(of.input.num_halfedges()),
        shared_(t_.num_halfedges(), kNone) {
    TraceLines();
    NormalCoordinates normal(t_);
    for (const Index h : ptolemy_flips) normal.Flip(h);
    std::vector<bool> shared(of.scaled.triangulation.num_edges(), false);
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      if (!normal.IsShared(h)) continue;
      shared_[normal.SharedHalfedge(h)] = h;
      shared[of.scaled.triangulation.edge[h]] = true;
    }
    chords_ = ChordsOf(of_delaunay, t_, of, shared);
  }

  /// Where an edge of the input crosses what it is said to.
  PathPositions Place(const EdgePath& path) const {
    const Line& line = line_[path.input];
    if (line.crossed.empty()) return ideal_(path);  // an edge of the Delaunay triangulation
    const std::vector<Meeting> met = Meet(line);
    const bool as_said =
        std::equal(met.begin(), met.end(), path.crossed.begin(), path.crossed.end(),
                   [](const Meeting& a, Index h) { return a.out == h; });
    if (!as_said) return ideal_(path);
    PathPositions positions;
    for (const Meeting& meeting : met) {
      positions.along_input.push_back(meeting.along_line);
      positions.along_crossed.push_back(meeting.along_edge);
      positions.log_weight.push_back(meeting.log_weight);
    }
    return positions;
  }

 private:
  /// An edge of the input over the Delaunay triangulation.
  struct Line {
    Index corner = kNone;  ///< where it begins
    std::vector<Index> crossed;
  };

  void TraceLines() {
    NormalCoordinates normal(of_.input);
    for (const Index h : of_.delaunay.flips) normal.Flip(h);
    for (Index corner = 0; corner < t_.num_halfedges(); ++corner) {
      for (std::int64_t i = 0; i < normal.Emanating(corner); ++i) {
        line_[Prev(normal.InputCorner(corner, i))] = {corner, normal.Crossed(corner, i)};
      }
    }
  }

  std::vector<Meeting> Meet(const Line& line) const {
    std::vector<Meeting> met;
    const PathPositions at = straight_({line.corner, line.crossed});
    Point from = AtCorner(line.corner);
    double along = 0;
    for (std::size_t i = 0;; ++i) {
      const bool last = i == line.crossed.size();
      const Index in = i == 0 ? kNone : t_.twin[line.crossed[i - 1]];
      const Point to = last ? AtCorner(in) : Along(line.crossed[i], at.along_crossed[i]);
      const Index face = Triangulation::Face(last ? in : line.crossed[i]);
      const double along_to = last ? 1 : at.along_input[i];
      MeetChords(face, from, to, along, along_to, &met);
      if (last) return met;
      MeetShared(line.crossed[i], at.along_crossed[i], along_to, &met);
      const Index next = t_.twin[line.crossed[i]];
      from = Along(next, 1 - at.along_crossed[i]);
      along = along_to;
    }
  }

  void MeetChords(Index face, const Point& from, const Point& to, double along, double along_to,
                  std::vector<Meeting>* met) const {
    std::vector<Meeting> here;
    for (const Chord& chord : chords_[face]) {
      const Point side = chord.to - chord.from, way = to - from;
      const double before = Cross(side, from - chord.from), after = Cross(side, to - chord.from);
      const double tail = Cross(way, chord.from - from), tip = Cross(way, chord.to - from);
      if (!(before * after < 0) || !(tail * tip < 0)) continue;
      const double share = before / (before - after), s = tail / (tail - tip);
      const Between at = Project(s, chord.weight_from, chord.weight_to);
      here.push_back({before > 0 ? chord.edge : of_.scaled.triangulation.twin[chord.edge],
                      along + share * (along_to - along),
                      chord.at_from + at.fraction * (chord.at_to - chord.at_from), at.log_weight});
      if (!(before > 0)) here.back().along_edge = 1 - here.back().along_edge;
    }
    std::sort(here.begin(), here.end(),
              [](const Meeting& a, const Meeting& b) { return a.along_line < b.along_line; });
    for (const Meeting& meeting : here) Add(meeting, met);
  }

  void MeetShared(Index h, double fraction, double along, std::vector<Meeting>* met) const {
    if (shared_[h] == kNone) return;
    const Between at = Project(fraction, -of_.log_scale[t_.Tail(h)], -of_.log_scale[t_.Tip(h)]);
    Add({shared_[h], along, at.fraction, at.log_weight}, met);
  }

  /// Crossing back takes both away.
  void Add(const Meeting& meeting, std::vector<Meeting>* met) const {
    if (!met->empty() && met->back().out == of_.scaled.triangulation.twin[meeting.out]) {
      met->pop_back();
    } else {
      met->push_back(meeting);
    }
  }

  const ScaledTriangulation& of_;
  const Triangulation& t_;
  const PositionRule straight_, ideal_;
  std::vector<Line> line_;     ///< of every halfedge of the input
  std::vector<Index> shared_;  ///< of the Delaunay triangulation's halfedges: the scaled one's
  std::vector<std::vector<Chord>> chords_;  ///< of its faces
};

}  // namespace

StatusOr<Overlay> OverlayThroughDelaunay(const ScaledTriangulation& of, std::int64_t most_faces) {
  const std::vector<Index>& flips = of.scaled.flips;
  const auto first = static_cast<std::ptrdiff_t>(of.delaunay.flips.size());
  const std::vector<Index> ptolemy_flips(flips.begin() + first, flips.end());
  const PositionRule ideal =
      IdealGeodesics(of.scaled.triangulation, of.scaled.lengths, of.log_scale);
  if (first == 0) return MakeOverlay(of.input, flips, ideal, most_faces);
  const StatusOr<Overlay> of_delaunay = MakeOverlay(of.delaunay.triangulation, ptolemy_flips, ideal,
                                                    std::numeric_limits<std::int64_t>::max());
  if (!of_delaunay.ok()) return of_delaunay.status();
  const ThroughDelaunay through(of, ptolemy_flips, *of_delaunay);
  return MakeOverlay(
      of.input, flips, [&through](const EdgePath& path) { return through.Place(path); },
      most_faces);
}

}  // namespace cirque
