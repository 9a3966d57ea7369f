#include "cirque/verify/mesh_match.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cirque/core/text.h"
#include "cirque/verify/nearest_point.h"
#include "cirque/verify/report_words.h"

namespace cirque::verify {
namespace {

using Eigen::Vector3d;

std::vector<bool> UsedVertices(const PolygonSoup& soup) {
  std::vector<bool> used(soup.position.size(), false);
  for (const Index v : soup.corner) used[v] = true;
  return used;
}

Eigen::AlignedBox3d UsedBox(const PolygonSoup& soup) {
  Eigen::AlignedBox3d box;
  for (const Index v : soup.corner) box.extend(soup.position[v]);
  return box;
}

/// Length of the diagonal, without overflow; 1 where there is none to measure by.
double Extent(const Eigen::AlignedBox3d& box) {
  const double extent = box.isEmpty() ? 0 : box.diagonal().stableNorm();
  return extent > 0 ? extent : 1;
}

}  // namespace

Displacement ComparePositions(const PolygonSoup& in, const std::vector<Vector3d>& out,
                              double tolerance) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double extent = Extent(UsedBox(in));
  const std::vector<bool> used = UsedVertices(in);
  Displacement result;
  for (std::size_t v = 0; v < in.position.size(); ++v) {
    if (!used[v]) continue;
    // stableNorm() of a NaN is no NaN.
    const bool finite = out[v].allFinite();
    const double relative = finite ? (in.position[v] - out[v]).stableNorm() / extent : kInfinity;
    if (!(relative <= tolerance)) result.moved.push_back(static_cast<Index>(v));
    result.largest = std::max(result.largest, relative);
  }
  return result;
}

MeshMatch MatchByNumber(const PolygonSoup& in, const PolygonSoup& out) {
  std::vector<Index> number(in.position.size());
  std::iota(number.begin(), number.end(), 0);
  MeshMatch match;
  match.in = NameCorners(in, number);
  match.out = NameCorners(out, number);
  match.faces = MatchFaces(match.in, match.out);
  return match;
}

namespace {

/// A vertex is named by the first vertex of IN at its place; those of OUT that have none within the
/// tolerance have no name.
MeshMatch MatchByPosition(const PolygonSoup& in, const PolygonSoup& out, double tolerance) {
  const std::vector<Index> first = FirstOfEqualPoints(in.position);
  std::vector<Index> places;
  const std::vector<bool> in_used = UsedVertices(in), out_used = UsedVertices(out);
  std::vector<bool> is_place(in.position.size(), false);
  for (std::size_t v = 0; v < in_used.size(); ++v) {
    if (!in_used[v] || is_place[first[v]]) continue;
    is_place[first[v]] = true;
    places.push_back(first[v]);
  }
  const NearestPoint nearest(in.position, std::move(places));
  const double extent = Extent(UsedBox(in));
  MeshMatch match;
  match.by_position = true;
  std::vector<Index> name(out.position.size(), kNone);
  for (std::size_t v = 0; v < name.size(); ++v) {
    if (!out_used[v] || !out.position[v].allFinite()) continue;
    const Index at = nearest.To(out.position[v]);
    if (at == kNone) continue;
    const double distance = (in.position[at] - out.position[v]).stableNorm() / extent;
    if (!(distance <= tolerance)) continue;
    name[v] = at;
    match.displacement.largest = std::max(match.displacement.largest, distance);
  }
  match.in = NameCorners(in, first);
  match.out = NameCorners(out, name);
  match.faces = MatchFaces(match.in, match.out);
  return match;
}

/// By numbers where that finds everything, else by positions where that does.
std::optional<MeshMatch> MatchInPlace(const PolygonSoup& in, const PolygonSoup& out,
                                      double tolerance) {
  if (in.position.size() == out.position.size()) {
    Displacement displacement = ComparePositions(in, out.position, tolerance);
    if (displacement.moved.empty()) {
      MeshMatch match = MatchByNumber(in, out);
      match.displacement = std::move(displacement);
      if (match.faces.complete()) return match;
    }
  }
  MeshMatch match = MatchByPosition(in, out, tolerance);
  return match.faces.complete() ? std::optional(std::move(match)) : std::nullopt;
}

/// The same where OUT is a scaled and shifted copy.
std::optional<MeshMatch> MatchScaled(const PolygonSoup& in, const PolygonSoup& out,
                                     double tolerance) {
  const Eigen::AlignedBox3d in_box = UsedBox(in), out_box = UsedBox(out);
  if (out_box.isEmpty()) return std::nullopt;
  const double scale = Extent(out_box) / Extent(in_box);
  const Vector3d shift = out_box.center() - scale * in_box.center();
  if (!std::isfinite(scale) || !shift.allFinite()) return std::nullopt;
  PolygonSoup moved = out;
  for (Vector3d& p : moved.position) p = (p - shift) / scale;
  std::optional<MeshMatch> match = MatchInPlace(in, moved, tolerance);
  if (!match) return std::nullopt;
  match->scale = scale;
  match->shift = shift;
  return match;
}

}  // namespace

MeshMatch MatchMeshes(const PolygonSoup& in, const PolygonSoup& out, double tolerance) {
  if (auto match = MatchInPlace(in, out, tolerance)) return *std::move(match);
  if (auto match = MatchScaled(in, out, tolerance)) return *std::move(match);
  if (in.position.size() != out.position.size()) return MatchByPosition(in, out, tolerance);
  MeshMatch match = MatchByNumber(in, out);
  match.displacement = ComparePositions(in, out.position, tolerance);
  return match;
}

std::vector<std::string> MatchErrors(const PolygonSoup& in, const PolygonSoup& out,
                                     const MeshMatch& match, double tolerance) {
  std::vector<std::string> errors;
  const Displacement& displacement = match.displacement;
  if (!displacement.moved.empty()) {
    errors.push_back(
        fmt::format("{} moved ({}): by up to {:.3g} of the bounding box, {:.3g} allowed",
                    Count(displacement.moved.size(), "vertex"), IdList(displacement.moved),
                    displacement.largest, tolerance));
  }
  const std::string noun = FaceNoun(in);
  if (!match.faces.missing.empty()) {
    errors.push_back(fmt::format("{} of IN missing from OUT ({})",
                                 Count(match.faces.missing.size(), noun),
                                 IdList(match.faces.missing)));
  }
  if (!match.faces.extra.empty()) {
    errors.push_back(fmt::format("{} of OUT not in IN (numbers of OUT: {})",
                                 Count(match.faces.extra.size(), FaceNoun(out)),
                                 IdList(match.faces.extra)));
  }
  if (!errors.empty() && match.by_position) {
    errors.back() += fmt::format(", by their corners' positions: IN has {} and OUT {}",
                                 Count(in.position.size(), "vertex"), out.position.size());
  }
  return errors;
}

}  // namespace cirque::verify
