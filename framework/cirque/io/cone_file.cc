#include "cirque/io/cone_file.h"

#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/io/file_input.h"

namespace cirque {
namespace {

/// What both files need: targets by the file's numbers, checked against the corners.
class TargetParser {
 public:
  TargetParser(const std::string& path, std::string_view text, const Triangulation& t,
               const FileVertices& vertices)
      : scanner_(path, text),
        count_(vertices.count),
        corners_(CornersPerVertex(t)),
        vertex_at_(vertices.count, kNone),
        targets_(FreeBoundaryTargets(t)) {
    CHECK_EQ(static_cast<Index>(vertices.of_vertex.size()), t.num_vertices);
    for (Index v = 0; v < t.num_vertices; ++v) vertex_at_.at(vertices.of_vertex[v]) = v;
  }

  StatusOr<ConeTargets> ParseCones() {
    std::vector<int> line_of(count_, 0);
    while (scanner_.NextLine()) {
      if (Status s = ParseCone(&line_of); !s.ok()) return s;
    }
    return std::move(targets_);
  }

  StatusOr<ConeTargets> ParseAngleSums() {
    for (Index i = 0; i < count_; ++i) {
      if (!scanner_.NextLine()) {
        return scanner_.Error(
            fmt::format("the file ends after {} angle sums; the mesh has {} "
                        "vertices",
                        i, count_));
      }
      if (Status s = ParseAngleSum(vertex_at_[i]); !s.ok()) return s;
    }
    if (scanner_.NextLine()) {
      return scanner_.Error(
          fmt::format("more angle sums follow than the {} vertices of the mesh", count_));
    }
    return std::move(targets_);
  }

 private:
  Status ParseCone(std::vector<int>* line_of) {
    const std::optional<long long> number = scanner_.Integer();
    if (!number) return scanner_.Expected("a vertex (counted from 1)");
    const std::optional<double> lower = scanner_.Number();
    if (!lower) return scanner_.Expected("the least angle sum, as a multiple of pi");
    const std::optional<double> upper = scanner_.AtLineEnd() ? lower : scanner_.Number();
    if (!upper || !scanner_.AtLineEnd()) {
      return scanner_.Expected("the greatest angle sum, as a multiple of pi, and nothing else");
    }
    if (*number < 1 || *number > count_) {
      return scanner_.Error(
          fmt::format("the mesh has no vertex {}: they count from 1 to {}, as in the mesh file",
                      *number, count_));
    }
    int& line = (*line_of)[*number - 1];
    if (line != 0) {
      return scanner_.Error(fmt::format(
          "vertex {} has a target already, in line {}; keep one of them", *number, line));
    }
    line = scanner_.line();
    const Index v = vertex_at_[*number - 1];
    if (v == kNone) {
      return scanner_.Error(
          fmt::format("vertex {} belongs to no face and can have no target", *number));
    }
    return SetTarget(v, *lower, *upper, fmt::format("vertex {}", *number));
  }

  Status ParseAngleSum(Index v) {
    const std::optional<double> angle = scanner_.Number();
    if (!angle || !scanner_.AtLineEnd()) {
      return scanner_.Expected("one angle sum in radians, and nothing else");
    }
    if (v == kNone) return Status();
    const Status status = SetTarget(v, *angle / kPi, *angle / kPi, "the vertex of this line");
    targets_.lower[v] = targets_.upper[v] = *angle;
    return status;
  }

  /// Angles as multiples of pi.
  Status SetTarget(Index v, double lower, double upper, const std::string& name) {
    const auto refuse = [&](const std::string& why) {
      return scanner_.Error(fmt::format("{}: {}", name, why));
    };
    if (!std::isfinite(lower) || !std::isfinite(upper)) {
      return refuse("an angle sum must be a finite number");
    }
    if (lower < 0) return refuse(fmt::format("the angle sum {} pi is negative", lower));
    if (lower > upper) {
      return refuse(
          fmt::format("the least angle sum {} pi is above the greatest, {} pi", lower, upper));
    }
    if (upper == 0)
      return refuse("the angle sum 0 is out of reach: triangles have positive angles");
    const bool reachable = upper <= corners_[v] && lower < corners_[v];
    if (!reachable) {
      return refuse(
          fmt::format("{} corners of less than pi each cannot reach the angle sum {} pi; "
                      "choose a smaller one or a vertex with more triangles",
                      corners_[v], lower < corners_[v] ? upper : lower));
    }
    targets_.lower[v] = lower * kPi;
    targets_.upper[v] = upper * kPi;
    return Status();
  }

  TextScanner scanner_;
  Index count_;
  std::vector<Index> corners_;
  std::vector<Index> vertex_at_;  ///< per vertex of the file, kNone for isolated ones
  ConeTargets targets_;
};

}  // namespace

FileVertices VerticesInOrder(Index count) {
  FileVertices file = {count, std::vector<Index>(count)};
  std::iota(file.of_vertex.begin(), file.of_vertex.end(), 0);
  return file;
}

StatusOr<ConeTargets> ParseConeFile(const std::string& path, std::string_view content,
                                    const Triangulation& t, const FileVertices& vertices) {
  return TargetParser(path, content, t, vertices).ParseCones();
}

StatusOr<ConeTargets> ParseAngleSumFile(const std::string& path, std::string_view content,
                                        const Triangulation& t, const FileVertices& vertices) {
  return TargetParser(path, content, t, vertices).ParseAngleSums();
}

StatusOr<ConeTargets> ReadConeFile(const std::string& path, const Triangulation& t,
                                   const FileVertices& vertices) {
  const StatusOr<std::string> content = ReadFileContent(path);
  if (!content.ok()) return content.status();
  return ParseConeFile(path, *content, t, vertices);
}

StatusOr<ConeTargets> ReadAngleSumFile(const std::string& path, const Triangulation& t,
                                       const FileVertices& vertices) {
  const StatusOr<std::string> content = ReadFileContent(path);
  if (!content.ok()) return content.status();
  return ParseAngleSumFile(path, *content, t, vertices);
}

}  // namespace cirque
