#include "cirque/cuts/edge_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/atomic_file.h"
#include "cirque/io/file_input.h"

namespace cirque {
namespace {

/// A line of the file, its numbers as they stand there.
struct CutLine {
  long long from, to, face;
};

class CutParser {
 public:
  CutParser(const std::string& path, std::string_view text, const Triangulation& t,
            const FileNumbers& numbers)
      : scanner_(path, text), t_(t), numbers_(numbers), line_of_edge_(t.num_edges(), 0) {
    CHECK(std::is_sorted(numbers.face.begin(), numbers.face.end()));
  }

  StatusOr<Cut> Parse() {
    Cut cut = {std::vector<bool>(t_.num_edges(), false)};
    while (scanner_.NextLine()) {
      std::array<long long, 3> number;
      for (long long& n : number) {
        const std::optional<long long> count = scanner_.Count();
        if (!count) return scanner_.Expected("vertex, vertex and face, 'from to face'");
        n = *count;
      }
      if (!scanner_.AtLineEnd()) return scanner_.Expected("the end of the line");
      const StatusOr<Index> edge = FindEdge({number[0], number[1], number[2]});
      if (!edge.ok()) return edge.status();
      cut.edge[*edge] = true;
    }
    return cut;
  }

 private:
  StatusOr<Index> FindEdge(const CutLine& line) {
    const auto [first, last] =
        std::equal_range(numbers_.face.begin(), numbers_.face.end(), line.face - 1);
    if (first == last) return scanner_.Error(fmt::format("there is no face {}", line.face));
    const auto begin = static_cast<Index>(3 * (first - numbers_.face.begin()));
    const auto end = static_cast<Index>(3 * (last - numbers_.face.begin()));
    Index h = FindHalfedge(begin, end, line.from, line.to);
    if (h == kNone) h = FindHalfedge(begin, end, line.to, line.from);
    if (h != kNone && numbers_.IsInside(t_.edge[h])) {
      return scanner_.Error(
          fmt::format("vertices {} and {} are corners of face {}, but no side of it joins them; a "
                      "cut runs along "
                      "sides",
                      line.from, line.to, line.face));
    }
    if (h == kNone) {
      return scanner_.Error(fmt::format("face {} has no edge from vertex {} to vertex {}",
                                        line.face, line.from, line.to));
    }
    return Judge(t_.edge[h]);
  }

  /// A side rather than a diagonal.
  Index FindHalfedge(Index begin, Index end, long long from, long long to) const {
    Index diagonal = kNone;
    for (Index h = begin; h < end; ++h) {
      const bool starts = numbers_.vertex[t_.Tail(h)] == from - 1;
      if (!starts || numbers_.vertex[t_.Tip(h)] != to - 1) continue;
      if (!numbers_.IsInside(t_.edge[h])) return h;
      diagonal = h;
    }
    return diagonal;
  }

  StatusOr<Index> Judge(Index e) {
    if (t_.IsBoundaryEdge(e)) {
      return scanner_.Error("this edge lies on the boundary, which is open; remove the line");
    }
    if (line_of_edge_[e] != 0) {
      return scanner_.Error(
          fmt::format("this edge is cut already by line {}; remove one", line_of_edge_[e]));
    }
    line_of_edge_[e] = scanner_.line();
    return e;
  }

  TextScanner scanner_;
  const Triangulation& t_;
  const FileNumbers& numbers_;
  std::vector<int> line_of_edge_;
};

}  // namespace

FileNumbers NumbersInFile(const Surface& surface) {
  return {surface.soup_vertex, surface.soup_polygon, EdgesInsidePolygons(surface)};
}

FileNumbers OwnNumbers(const Triangulation& t) {
  FileNumbers numbers = {std::vector<Index>(t.num_vertices), std::vector<Index>(t.num_faces()), {}};
  std::iota(numbers.vertex.begin(), numbers.vertex.end(), 0);
  std::iota(numbers.face.begin(), numbers.face.end(), 0);
  return numbers;
}

StatusOr<Cut> ParseCut(const std::string& path, std::string_view text, const Triangulation& t,
                       const FileNumbers& numbers) {
  return CutParser(path, text, t, numbers).Parse();
}

StatusOr<Cut> ReadCutFile(const std::string& path, const Triangulation& t,
                          const FileNumbers& numbers) {
  const StatusOr<std::string> text = ReadFileContent(path);
  if (!text.ok()) return text.status();
  return ParseCut(path, *text, t, numbers);
}

std::string FormatCut(const Triangulation& t, const FileNumbers& numbers, const Cut& cut) {
  std::string text;
  for (Index e = 0; e < t.num_edges(); ++e) {
    if (!cut.edge[e] || t.IsBoundaryEdge(e)) continue;
    const Index h = t.edge_halfedge[e];
    text += fmt::format("{} {} {}\n", numbers.vertex[t.Tail(h)] + 1, numbers.vertex[t.Tip(h)] + 1,
                        numbers.face[Triangulation::Face(h)] + 1);
  }
  return text;
}

Status WriteCutFile(const std::string& path, const Triangulation& t, const FileNumbers& numbers,
                    const Cut& cut) {
  return WriteFileAtomically(path, FormatCut(t, numbers, cut));
}

namespace {

using Ends = std::pair<long long, long long>;

Ends Ordered(long long a, long long b) { return a < b ? Ends(a, b) : Ends(b, a); }

class EdgeCostParser {
 public:
  EdgeCostParser(const std::string& path, std::string_view text, const Triangulation& t,
                 const std::vector<Index>& number)
      : scanner_(path, text), cost_(Eigen::VectorXd::Ones(t.num_edges())) {
    for (Index e = 0; e < t.num_edges(); ++e) {
      const Index h = t.edge_halfedge[e];
      edges_[Ordered(number[t.Tail(h)] + 1LL, number[t.Tip(h)] + 1LL)].push_back(e);
    }
  }

  StatusOr<Eigen::VectorXd> Run() {
    while (scanner_.NextLine()) {
      if (Status s = ParseLine(); !s.ok()) return s;
    }
    return std::move(cost_);
  }

 private:
  Status ParseLine() {
    const std::optional<long long> from = scanner_.Integer();
    if (!from) return scanner_.Expected("a vertex (counted from 1)");
    const std::optional<long long> to = scanner_.Integer();
    if (!to) return scanner_.Expected("the edge's other vertex (counted from 1)");
    const std::optional<double> cost = scanner_.Number();
    if (!cost || !scanner_.AtLineEnd()) return scanner_.Expected("a cost, and nothing else");
    if (!(std::isfinite(*cost) && *cost >= 0)) {
      return scanner_.Error(fmt::format("the cost {} must be finite and at least 0", *cost));
    }
    const auto found = edges_.find(Ordered(*from, *to));
    if (found == edges_.end()) {
      return scanner_.Error(fmt::format("no edge joins the vertices {} and {}", *from, *to));
    }
    const auto [line, is_new] = line_of_.emplace(found->first, scanner_.line());
    if (!is_new) {
      return scanner_.Error(
          fmt::format("the edge {} {} has a cost already, in line {}", *from, *to, line->second));
    }
    for (const Index e : found->second) cost_[e] = *cost;
    return Status();
  }

  TextScanner scanner_;
  Eigen::VectorXd cost_;
  std::map<Ends, std::vector<Index>> edges_;
  std::map<Ends, int> line_of_;
};

}  // namespace

StatusOr<Eigen::VectorXd> ParseEdgeCosts(const std::string& path, std::string_view text,
                                         const Triangulation& t,
                                         const std::vector<Index>& vertex_in_file) {
  return EdgeCostParser(path, text, t, vertex_in_file).Run();
}

StatusOr<Eigen::VectorXd> ReadEdgeCostFile(const std::string& path, const Triangulation& t,
                                           const std::vector<Index>& vertex_in_file) {
  const StatusOr<std::string> content = ReadFileContent(path);
  if (!content.ok()) return content.status();
  return ParseEdgeCosts(path, *content, t, vertex_in_file);
}

}  // namespace cirque
