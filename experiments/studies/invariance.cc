// Whether maps depend on what they must not: the numbering, orientation in space and scale of the
// input.
#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numeric>
#include <random>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/text.h"
#include "cirque/domains/domain.h"
#include "cirque/generators/generators.h"
#include "cirque/mesh/preflight.h"

#include "experiments/common/process.h"
#include "experiments/studies/studies.h"

DEFINE_int32(patches, 400, "how many surfaces");
DEFINE_double(roughness, 1, "standard deviation of the heights, in mean edge lengths");
DEFINE_double(allowed, 1e-6, "distance of two maps, as a part of their diameter, that is none");

namespace cirque {
namespace {

using Uv = std::vector<std::complex<double>>;  ///< of every corner of the soup

/// A Delaunay patch with vertices lifted at random: slopes and folds of every kind, many edges to
/// be flipped, and vertices that are at their least number of corners.
PolygonSoup RoughPatch(unsigned seed) {
  std::mt19937 random(seed);
  PolygonSoup soup =
      *GenerateMesh("flat_delaunay_patch", {static_cast<Index>(60 + random() % 400), seed});
  std::normal_distribution<double> height(
      0, FLAGS_roughness * 2 / std::sqrt(static_cast<double>(soup.num_polygons()) / 2));
  for (Eigen::Vector3d& x : soup.position) x.z() = height(random);
  return soup;
}

std::vector<Index> Permutation(Index n, std::mt19937* random) {
  std::vector<Index> permutation(n);
  std::iota(permutation.begin(), permutation.end(), 0);
  std::shuffle(permutation.begin(), permutation.end(), *random);
  return permutation;
}

/// The same surface with vertices and faces in another order, faces begun at another corner, turned
/// in space and scaled; `corner` tells for every corner of the new one the old one's.
struct Disguise {
  PolygonSoup soup;
  std::vector<Index> corner;
};

Disguise Disguised(const PolygonSoup& soup, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto n = static_cast<Index>(soup.position.size());
  const std::vector<Index> vertex = Permutation(n, &random);
  Eigen::Quaterniond rotation(normal(random), normal(random), normal(random), normal(random));
  rotation.normalize();
  const double scale = std::exp(3 * normal(random));
  Disguise disguise;
  disguise.soup.position.resize(n);
  for (Index v = 0; v < n; ++v) {
    disguise.soup.position[vertex[v]] = scale * (rotation * soup.position[v]);
  }
  for (const Index face : Permutation(soup.num_polygons(), &random)) {
    const auto turn = static_cast<Index>(random() % 3);
    for (Index k = 0; k < 3; ++k) {
      const Index corner = 3 * face + (k + turn) % 3;
      disguise.corner.push_back(corner);
      disguise.soup.corner.push_back(vertex[soup.corner[corner]]);
    }
    disguise.soup.first_corner.push_back(static_cast<Index>(disguise.soup.corner.size()));
  }
  return disguise;
}

struct Mapped {
  Uv uv;                  ///< in the order of the soup's corners
  std::string made_with;  ///< the rung of the ladder that it was made on; empty: as asked
};

/// The map of the surface; the outcome where there is none.
StatusOr<Mapped> Map(const PolygonSoup& soup) {
  PreflightReport report;
  const StatusOr<Surface> surface = Preflight(soup, &report);
  if (!surface.ok()) return surface.status();
  const StatusOr<SurfaceMap> map = MapSurface(*surface, MapRequest(), {}, nullptr);
  if (!map.ok()) return map.status();
  Mapped mapped;
  for (const Eigen::Vector2d& point : map->uv.value) mapped.uv.emplace_back(point.x(), point.y());
  if (map->certificate.ladder) mapped.made_with = map->certificate.ladder->made_with;
  return mapped;
}

/// The largest distance of corresponding corners after the similarity a z + b that fits best, as a
/// part of the map's diameter.
double Distance(const Uv& from, const Uv& to) {
  const auto n = static_cast<double>(from.size());
  const std::complex<double> from_mean =
      std::accumulate(from.begin(), from.end(), std::complex<double>()) / n;
  const std::complex<double> to_mean =
      std::accumulate(to.begin(), to.end(), std::complex<double>()) / n;
  std::complex<double> product;
  double square = 0, diameter = 0, distance = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    product += std::conj(from[i] - from_mean) * (to[i] - to_mean);
    square += std::norm(from[i] - from_mean);
    diameter = std::max(diameter, 2 * std::abs(to[i] - to_mean));
  }
  const std::complex<double> a = product / square;
  for (std::size_t i = 0; i < from.size(); ++i) {
    distance = std::max(distance, std::abs(a * (from[i] - from_mean) - (to[i] - to_mean)));
  }
  return distance / diameter;
}

/// What came of one pair.
struct Outcome {
  /// "equal", "differs", "one with cones", "both infeasible", "ok and infeasible", ...
  std::string word;
  double distance = 0;
};

Outcome Compare(unsigned seed) {
  const PolygonSoup soup = RoughPatch(seed);
  const Disguise disguise = Disguised(soup, seed);
  const StatusOr<Mapped> map = Map(soup), other = Map(disguise.soup);
  const std::string code = ToString(map.status().code()),
                    other_code = ToString(other.status().code());
  if (!map.ok() || !other.ok()) {
    return {code == other_code ? "both " + code : code + " and " + other_code};
  }
  Uv matched(map->uv.size());
  for (std::size_t i = 0; i < matched.size(); ++i) matched[disguise.corner[i]] = other->uv[i];
  const double distance = Distance(map->uv, matched);
  if (distance <= FLAGS_allowed) return {"equal", distance};
  const bool same_kind = map->made_with == other->made_with;
  return {same_kind ? "differs" : "one with cones", distance};
}

}  // namespace

Status RunInvariance(const StudyCall& call) {
  if (Status s = NoArguments(call); !s.ok()) return s;
  CatchInterrupts();
  std::map<std::string, int> counts;
  std::vector<std::string> different;
  double largest_equal = 0;
  for (unsigned seed = 1; seed <= static_cast<unsigned>(FLAGS_patches); ++seed) {
    if (IsInterrupted()) return {StatusCode::kCancelled, "interrupted"};
    const Outcome outcome = Compare(seed);
    ++counts[outcome.word];
    if (outcome.word == "equal") {
      largest_equal = std::max(largest_equal, outcome.distance);
    } else if (!outcome.word.starts_with("both")) {
      different.push_back(
          fmt::format("| {} | {} | {:.2e} |\n", seed, outcome.word, outcome.distance));
    }
  }
  std::string text = fmt::format(
      "# Maps of surfaces renumbered, turned and scaled\n\nMade by `{}`. Largest distance of maps "
      "that count as equal: {:.1e} of the diameter. *One with cones*: the layout adds up rounding "
      "along a tree that begins at the first triangle, so an error of closure near {:.0e}, beyond "
      "which a map is made again with cones, may be on either side of that.\n\n"
      "| outcome | patches |\n|---|--:|\n",
      call.command, largest_equal, kAccuracy);
  for (const auto& [word, count] : counts) text += fmt::format("| {} | {} |\n", word, count);
  if (!different.empty()) text += "\n| seed | outcome | distance |\n|--:|---|--:|\n";
  for (const std::string& row : different) text += row;
  return Deliver(text);
}

}  // namespace cirque
