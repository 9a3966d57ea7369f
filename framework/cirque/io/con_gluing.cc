#include "cirque/io/con_gluing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/grouping.h"
#include "cirque/core/triangulation.h"

namespace cirque {
namespace {

constexpr double kLengthTolerance = 1e-12;  ///< relative, of glued sides

class ConGluer {
 public:
  ConGluer(const std::string& path, ConFaces* faces) : path_(path), faces_(*faces) {}

  Status Glue() {
    if (faces_.twin.empty()) {
      if (Status s = GlueByVertices(); !s.ok()) return s;
    }
    for (Index h = 0; h < static_cast<Index>(faces_.twin.size()); ++h) {
      if (faces_.twin[h] == kNone) continue;
      if (Status s = CheckSide(h, faces_.twin[h]); !s.ok()) return s;
    }
    if (Status s = CheckFans(); !s.ok()) return s;
    return CheckConnected();
  }

 private:
  Index Tail(Index h) const { return faces_.vertex[Triangulation::Next(h)]; }
  Index Tip(Index h) const { return faces_.vertex[Triangulation::Prev(h)]; }

  std::string Name(Index h) const {
    return fmt::format("side {} (of face {}, from vertex {} to {})", h + 1,
                       Triangulation::Face(h) + 1, Tail(h) + 1, Tip(h) + 1);
  }

  Status Error(Index face, const std::string& message) const {
    return Status::InvalidInput(fmt::format("{}:{}: {}", path_, faces_.line[face], message));
  }

  Status ErrorAtSide(Index h, const std::string& message) const {
    return Error(Triangulation::Face(h), Name(h) + " " + message);
  }

  Status GlueByVertices() {
    const auto num_sides = static_cast<Index>(faces_.vertex.size());
    std::vector<Index> order(num_sides);
    std::iota(order.begin(), order.end(), 0);
    const auto ends = [&](Index h) {
      return std::pair(std::min(Tail(h), Tip(h)), std::max(Tail(h), Tip(h)));
    };
    std::sort(order.begin(), order.end(),
              [&](Index a, Index b) { return std::pair(ends(a), a) < std::pair(ends(b), b); });
    faces_.twin.assign(num_sides, kNone);
    for (Index first = 0, last = 0; first < num_sides; first = last) {
      while (last < num_sides && ends(order[last]) == ends(order[first])) ++last;
      if (last - first == 1) continue;
      const Index h = order[first], g = order[first + 1];
      if (last - first > 2) {
        return ErrorAtSide(h, fmt::format("could be glued to {} and to others; add the three "
                                          "neighbouring sides to every face's line",
                                          Name(g)));
      }
      faces_.twin[h] = g;
      faces_.twin[g] = h;
    }
    return Status();
  }

  Status CheckSide(Index h, Index g) const {
    if (g == h) return ErrorAtSide(h, "is glued to itself; 0 says that it is on the boundary");
    if (faces_.twin[g] != h) {
      return ErrorAtSide(h, fmt::format("names {} as its neighbour, which names side {}; both must "
                                        "name each other",
                                        Name(g), faces_.twin[g] + 1));
    }
    if (Tail(g) != Tip(h) || Tip(g) != Tail(h)) {
      return ErrorAtSide(h, fmt::format("is glued to {}; they must run between the same vertices "
                                        "in opposite directions: turn one of the faces around or "
                                        "correct its neighbours",
                                        Name(g)));
    }
    const double a = faces_.length[h], b = faces_.length[g];
    if (std::abs(a - b) > kLengthTolerance * std::max(a, b)) {
      return ErrorAtSide(h,
                         fmt::format("has length {}, but {} on the other side of it has {}; they "
                                     "must agree to {:g} of the length",
                                     a, Name(g), b, kLengthTolerance));
    }
    return Status();
  }

  /// The corners of a vertex must form one fan or one cycle.
  Status CheckFans() const {
    const auto num_corners = static_cast<Index>(faces_.vertex.size());
    DisjointSets fans(num_corners);
    for (Index h = 0; h < num_corners; ++h) {
      const Index g = faces_.twin[h];
      if (g == kNone) continue;
      fans.Unite(Triangulation::Next(h), Triangulation::Prev(g));
      fans.Unite(Triangulation::Prev(h), Triangulation::Next(g));
    }
    std::vector<Index> fan_of(faces_.num_vertices, kNone);
    for (Index h = 0; h < num_corners; ++h) {
      Index& fan = fan_of[faces_.vertex[h]];
      if (fan == kNone) fan = fans.Find(h);
      if (fan == fans.Find(h)) continue;
      return Error(Triangulation::Face(h),
                   fmt::format("vertex {} belongs to face {} and to face {}, which no glued sides "
                               "join around it; give each of its fans a vertex of its own",
                               faces_.vertex[h] + 1, Triangulation::Face(fan) + 1,
                               Triangulation::Face(h) + 1));
    }
    const auto unused = std::find(fan_of.begin(), fan_of.end(), kNone);
    if (unused == fan_of.end()) return Status();
    return Status::InvalidInput(fmt::format(
        "{}: vertex {} belongs to no face; lower the number of vertices and renumber them", path_,
        unused - fan_of.begin() + 1));
  }

  Status CheckConnected() const {
    const auto num_faces = static_cast<Index>(faces_.line.size());
    DisjointSets pieces(num_faces);
    for (Index h = 0; h < 3 * num_faces; ++h) {
      if (faces_.twin[h] == kNone) continue;
      pieces.Unite(Triangulation::Face(h), Triangulation::Face(faces_.twin[h]));
    }
    for (Index f = 0; f < num_faces; ++f) {
      if (pieces.Find(f) == 0) continue;
      return Error(f, fmt::format("face {} is not connected to face 1; put every connected "
                                  "component into a file of its own",
                                  f + 1));
    }
    return Status();
  }

  const std::string& path_;
  ConFaces& faces_;
};

}  // namespace

Status GlueFaces(const std::string& path, ConFaces* faces) { return ConGluer(path, faces).Glue(); }

}  // namespace cirque
