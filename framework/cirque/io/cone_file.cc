#include "cirque/io/cone_file.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/core/count.h"
#include "cirque/io/file_input.h"

namespace cirque {
namespace {

/// A vertex whose angle sums a file rounded.
struct RoundedAngle {
  Index vertex;
  double lower, upper;  ///< [rad] by how much at most
};

/// Half a unit of the last decimal of a multiple of pi [rad]; 0 where that has less than three.
double HalfUnit(double multiple) {
  constexpr std::ptrdiff_t kExactDigits = 2;
  const std::string text = fmt::format("{:.15f}", multiple);
  const std::size_t point = text.find('.'), last = text.find_last_not_of('0');
  if (point == std::string::npos || last == std::string::npos || last <= point) return 0;
  const auto digits = static_cast<std::ptrdiff_t>(last - point);
  return digits <= kExactDigits ? 0 : 0.5 * kPi * std::pow(10.0, -static_cast<double>(digits));
}

/// Changes, none beyond its limit, that add up to `sum` with the least largest one: all alike but
/// for those whose limit is lower.
std::vector<double> Share(double sum, const std::vector<double>& limit) {
  std::vector<std::size_t> order(limit.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return limit[a] < limit[b]; });
  std::vector<double> share(limit.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    share[order[i]] = std::min(limit[order[i]], sum / static_cast<double>(order.size() - i));
    sum -= share[order[i]];
  }
  return share;
}

/// Makes targets add up that miss what they should by their digits alone, in every component of a
/// surface.
class ExactTargets {
 public:
  ExactTargets(const Triangulation& t, const std::vector<RoundedAngle>& ends, ConeTargets* targets)
      : t_(t), ends_(ends), targets_(*targets) {}

  ConeFileRounding Make() {
    const Patches components = ConnectedPatches(t_);
    // As MeasureGaussBonnetDefect has it: those of flat vertices are exactly 0.
    std::vector<double> lower(components.count, 0), upper(components.count, 0);
    component_of_.assign(t_.num_vertices, kNone);
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      component_of_[t_.vertex[h]] = components.of_face[Triangulation::Face(h)];
    }
    for (const Index component : components.of_face) {
      lower[component] -= 1;
      upper[component] -= 1;
    }
    for (Index v = 0; v < t_.num_vertices; ++v) {
      lower[component_of_[v]] += targets_.lower[v] / kPi;
      upper[component_of_[v]] += targets_.upper[v] / kPi;
    }
    for (Index c = 0; c < components.count; ++c) {
      if (lower[c] * kPi > kRounding) Change(c, lower[c] * kPi);
      if (upper[c] * kPi < -kRounding) Change(c, upper[c] * kPi);
    }
    return rounding_;
  }

 private:
  /// Lowers the lower ends where the sum is too large, or raises the upper ones, if the digits allow.
  void Change(Index component, double missed) {
    std::vector<RoundedAngle> ends;
    std::vector<double> limit;
    for (const RoundedAngle& end : ends_) {
      if (component_of_[end.vertex] != component) continue;
      ends.push_back(end);
      limit.push_back(missed > 0 ? end.lower : end.upper);
    }
    constexpr double kSlack = 1 + 1e-6;
    if (std::abs(missed) > kSlack * std::accumulate(limit.begin(), limit.end(), 0.0)) return;
    const std::vector<double> share = Share(std::abs(missed), limit);
    for (std::size_t i = 0; i < share.size(); ++i) {
      if (share[i] == 0) continue;
      double &lower = targets_.lower[ends[i].vertex], &upper = targets_.upper[ends[i].vertex];
      const double change = missed > 0 ? -share[i] : share[i];
      const bool fixed = lower == upper;
      if (fixed || missed > 0) lower += change;
      if (fixed || missed < 0) upper += change;
      ++rounding_.cones;
      rounding_.largest = std::max(rounding_.largest, share[i]);
    }
    if (std::abs(missed) > std::abs(rounding_.missed)) rounding_.missed = missed;
  }

  static constexpr double kRounding = 1e-9;  ///< [rad], which solvers take for exact

  const Triangulation& t_;
  const std::vector<RoundedAngle>& ends_;
  ConeTargets& targets_;
  std::vector<Index> component_of_;
  ConeFileRounding rounding_;
};

/// What both files need: targets by the file's numbers, checked against the corners.
class TargetParser {
 public:
  TargetParser(const std::string& path, std::string_view text, const Triangulation& t,
               const FileVertices& vertices)
      : scanner_(path, text),
        t_(t),
        count_(vertices.count),
        corners_(CornersPerVertex(t)),
        vertex_at_(vertices.count, kNone),
        targets_(FreeBoundaryTargets(t)) {
    CHECK_EQ(static_cast<Index>(vertices.of_vertex.size()), t.num_vertices);
    for (Index v = 0; v < t.num_vertices; ++v) vertex_at_.at(vertices.of_vertex[v]) = v;
  }

  StatusOr<ConeTargets> ParseCones(ConeFileRounding* rounding) {
    std::vector<int> line_of(count_, 0);
    while (scanner_.NextLine()) {
      if (Status s = ParseCone(&line_of); !s.ok()) return s;
    }
    const ConeFileRounding done = ExactTargets(t_, ends_, &targets_).Make();
    if (rounding) *rounding = done;
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
    ends_.push_back({v, HalfUnit(*lower), HalfUnit(*upper)});
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
          fmt::format("{} of less than pi each cannot reach the angle sum {} pi; "
                      "choose a smaller one or a vertex with more triangles",
                      Count(corners_[v], "corner"), lower < corners_[v] ? upper : lower));
    }
    targets_.lower[v] = lower * kPi;
    targets_.upper[v] = upper * kPi;
    return Status();
  }

  TextScanner scanner_;
  const Triangulation& t_;
  std::vector<RoundedAngle> ends_;
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
                                    const Triangulation& t, const FileVertices& vertices,
                                    ConeFileRounding* rounding) {
  return TargetParser(path, content, t, vertices).ParseCones(rounding);
}

StatusOr<ConeTargets> ParseAngleSumFile(const std::string& path, std::string_view content,
                                        const Triangulation& t, const FileVertices& vertices) {
  return TargetParser(path, content, t, vertices).ParseAngleSums();
}

StatusOr<ConeTargets> ReadConeFile(const std::string& path, const Triangulation& t,
                                   const FileVertices& vertices, ConeFileRounding* rounding) {
  const StatusOr<std::string> content = ReadFileContent(path);
  if (!content.ok()) return content.status();
  return ParseConeFile(path, *content, t, vertices, rounding);
}

StatusOr<ConeTargets> ReadAngleSumFile(const std::string& path, const Triangulation& t,
                                       const FileVertices& vertices) {
  const StatusOr<std::string> content = ReadFileContent(path);
  if (!content.ok()) return content.status();
  return ParseAngleSumFile(path, *content, t, vertices);
}

}  // namespace cirque
