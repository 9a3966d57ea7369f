#include "cirque/verify/angle_check.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>

#include <fmt/format.h>

namespace cirque::verify {
namespace {

double CornerAngle(const UvComplex& complex, Index h) {
  const Point a = complex.Tip(h) - complex.uv[h];
  const Point b = complex.uv[FanMesh::Prev(h)] - complex.uv[h];
  return std::atan2(std::abs(a.x() * b.y() - a.y() * b.x()), a.dot(b));
}

/// Whether the direction from the apex to p has its angle in [pi, 2 pi).
bool InLowerHalf(const Point& apex, const Point& p) {
  return p.y() < apex.y() || (p.y() == apex.y() && p.x() < apex.x());
}

/// What the vertices' corners add up to.
struct VertexSums {
  explicit VertexSums(Index n) : angle(n, 0), turns(n, 0), inside(n, true), on_seam(n, false) {}
  std::vector<double> angle;
  /// How often the corners, each turning counterclockwise by less than pi, pass the direction +x:
  /// the number of full turns of a closed fan, without rounding.
  std::vector<int> turns;
  std::vector<bool> inside, on_seam;
};

VertexSums SumCorners(const UvComplex& complex, const std::vector<double>& angle) {
  const FanMesh& mesh = complex.mesh();
  VertexSums sums(mesh.num_vertices);
  std::vector<bool> used(mesh.num_vertices, false);
  for (Index h = 0; h < static_cast<Index>(angle.size()); ++h) {
    const Index v = mesh.Tail(h);
    used[v] = true;
    sums.angle[v] += angle[h];
    const Point& apex = complex.uv[h];
    const bool passes =
        InLowerHalf(apex, complex.Tip(h)) && !InLowerHalf(apex, complex.uv[FanMesh::Prev(h)]);
    if (passes) ++sums.turns[v];
    for (const Index end : {v, mesh.Tip(h)}) {
      if (complex.surface.twin[h] == kNone) sums.inside[end] = false;
      if (complex.IsSeam(h)) sums.on_seam[end] = true;
    }
  }
  for (Index v = 0; v < mesh.num_vertices; ++v) {
    if (!used[v]) sums.inside[v] = false;
  }
  return sums;
}

void JudgeInnerVertices(const VertexSums& sums, double tolerance, AngleMeasures* result) {
  for (Index v = 0; v < static_cast<Index>(sums.angle.size()); ++v) {
    if (!sums.inside[v]) continue;
    const double deviation = std::abs(sums.angle[v] - 2 * kPi);
    if (!sums.on_seam[v]) {
      ++result->num_plain;
      result->largest_plain_deviation = std::max(result->largest_plain_deviation, deviation);
      if (sums.turns[v] != 1) result->wrapped.push_back(v);
      continue;
    }
    ++result->num_on_seam;
    if (deviation > tolerance) {
      result->cones.push_back({v, sums.angle[v]});
    } else {
      result->largest_flat_seam_deviation =
          std::max(result->largest_flat_seam_deviation, deviation);
    }
  }
}

void CompareWithTargets(const VertexSums& sums, const std::vector<std::optional<double>>& targets,
                        double tolerance, AngleMeasures* result) {
  result->largest_target_deviation = 0;
  for (Index v = 0; v < static_cast<Index>(targets.size()); ++v) {
    if (!targets[v]) continue;
    const double deviation = std::abs(sums.angle[v] - *targets[v]);
    result->largest_target_deviation = std::max(result->largest_target_deviation, deviation);
    if (deviation > tolerance) result->off_target.push_back(v);
  }
}

}  // namespace

AngleMeasures MeasureAngles(const UvComplex& complex,
                            const std::vector<std::optional<double>>& targets, double tolerance) {
  AngleMeasures result;
  std::vector<double> angle(complex.uv.size());
  for (Index h = 0; h < static_cast<Index>(angle.size()); ++h) {
    angle[h] = CornerAngle(complex, h);
    result.smallest_angle = std::fmin(result.smallest_angle, angle[h]);
  }
  for (Index h = 0; h < static_cast<Index>(angle.size()); ++h) {
    const Index t = complex.surface.twin[h];
    if (t < h) continue;  // none, or done from the other side
    const double margin = kPi - angle[FanMesh::Prev(h)] - angle[FanMesh::Prev(t)];
    result.delaunay_margin = std::fmin(result.delaunay_margin, margin);
  }
  const VertexSums sums = SumCorners(complex, angle);
  JudgeInnerVertices(sums, tolerance, &result);
  if (!targets.empty()) CompareWithTargets(sums, targets, tolerance, &result);
  return result;
}

namespace {

std::string Trimmed(const std::string& line) {
  const char* const kBlank = " \t\r";
  const std::size_t begin = line.find_first_not_of(kBlank);
  if (begin == std::string::npos) return {};
  return line.substr(begin, line.find_last_not_of(kBlank) - begin + 1);
}

}  // namespace

StatusOr<std::vector<std::optional<double>>> ReadTargets(const std::string& path,
                                                         Index num_vertices) {
  std::ifstream file(path);
  if (!file) return Status::InvalidInput(fmt::format("{}: cannot be read", path));
  std::vector<std::optional<double>> targets;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    const std::string word = Trimmed(line);
    if (word.empty()) continue;
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number =
        error == std::errc() && end == word.data() + word.size() && std::isfinite(value);
    if (!is_number && word != "free") {
      return Status::InvalidInput(
          fmt::format("{}:{}: '{}' is no angle sum; write radians, or free", path, number, word));
    }
    targets.push_back(is_number ? std::optional<double>(value) : std::nullopt);
  }
  if (static_cast<Index>(targets.size()) == num_vertices) return targets;
  return Status::InvalidInput(
      fmt::format("{}: {} angle sums for {} vertices; one line each is needed", path,
                  targets.size(), num_vertices));
}

}  // namespace cirque::verify
