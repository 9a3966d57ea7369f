#include "cirque/cuts/cut_file.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/atomic_file.h"
#include "cirque/io/file_content.h"
#include "cirque/io/text_scanner.h"

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
    if (h == kNone) {
      return scanner_.Error(fmt::format("face {} has no edge from vertex {} to vertex {}",
                                        line.face, line.from, line.to));
    }
    return Judge(t_.edge[h]);
  }

  Index FindHalfedge(Index begin, Index end, long long from, long long to) const {
    for (Index h = begin; h < end; ++h) {
      const bool starts = numbers_.vertex[t_.Tail(h)] == from - 1;
      if (starts && numbers_.vertex[t_.Tip(h)] == to - 1) return h;
    }
    return kNone;
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
  return {surface.soup_vertex, surface.soup_polygon};
}

FileNumbers OwnNumbers(const Triangulation& t) {
  FileNumbers numbers = {std::vector<Index>(t.num_vertices), std::vector<Index>(t.num_faces())};
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

}  // namespace cirque
