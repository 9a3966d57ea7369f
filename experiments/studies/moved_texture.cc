// A texture baked for one map of a surface and moved to another: how far it is from the one baked
// there at once: results/moved_texture.md.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/solve_summary.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/transfer.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"

#include "experiments/studies/studies.h"

DEFINE_int32(least_texels, 256, "columns and rows of the coarsest texture");
DEFINE_int32(most_texels, 2048, "of the finest; each has twice as many as the one before");

namespace cirque {
namespace {

constexpr int kMargin = 4;    ///< texels
constexpr double kWaves = 3;  ///< over the surface's extent

/// A smooth function of the place in space, between -1 and 1.
class Waves {
 public:
  explicit Waves(const Surface& surface) : surface_(surface) {
    for (const Eigen::Vector3d& p : surface.position) box_.extend(p);
  }

  Eigen::VectorXd operator()(const SurfacePoint& point) const {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      place += point.barycentric[k] *
               surface_.position[surface_.triangulation.vertex[3 * point.face + k]];
    }
    const Eigen::Vector3d phase = 2 * kPi * kWaves * (place - box_.min()) / box_.sizes().maxCoeff();
    return Eigen::VectorXd::Constant(1, (phase.array() + 0.3).sin().mean());
  }

 private:
  const Surface& surface_;
  Eigen::AlignedBox3d box_;
};

struct Errors {
  double largest = 0, nearly_all = 0, mean = 0;
  int texels = 0;
};

/// At the texels of the image.
Errors Compare(const MapLocator& to, const Texture& moved, const Texture& baked) {
  std::vector<double> error;
  Errors errors;
  for (int j = 0; j < moved.height; ++j) {
    for (int i = 0; i < moved.width; ++i) {
      if (!to.PointAt(moved.Centre(i, j))) continue;
      error.push_back(std::abs(*moved.At(i, j) - *baked.At(i, j)));
      errors.mean += error.back();
    }
  }
  if (error.empty()) return errors;
  std::sort(error.begin(), error.end());
  errors.texels = static_cast<int>(error.size());
  errors.mean /= errors.texels;
  errors.largest = error.back();
  errors.nearly_all = error[error.size() - 1 - error.size() / 1000];
  return errors;
}

Texture Blank(int texels, const MapLocator& map) {
  Eigen::AlignedBox2d frame = map.box();
  const Eigen::Vector2d middle = frame.center();
  const double half = 0.5 * frame.sizes().maxCoeff();
  frame = {middle - Eigen::Vector2d(half, half), middle + Eigen::Vector2d(half, half)};
  return {texels, texels, 1, frame, {}};
}

StatusOr<MapLocator> LocatorOf(const Surface& surface, PatternKind pattern, bool exact) {
  MapRequest request;
  request.options.pattern = pattern;
  request.options.exact = exact;
  const StatusOr<SurfaceMap> map = MapSurface(surface, request);
  if (!map.ok()) return map.status();
  return MapLocator(exact ? TrianglesOf(surface.triangulation, *map->exact_map)
                          : TrianglesOf(surface.triangulation, map->uv));
}

std::string RowOf(const Surface& surface, const std::string& name, int texels,
                  const std::string& maps, const MapLocator& from, const MapLocator& to) {
  const Waves waves(surface);
  Texture painted = Blank(texels, from), moved = Blank(texels, to), baked = moved;
  BakeTexture(from, waves, kMargin, &painted);
  const Timer timer;
  TransferTexture(from, painted, to, kMargin, &moved);
  const double seconds = timer.Seconds();
  BakeTexture(to, waves, kMargin, &baked);
  const Errors errors = Compare(to, moved, baked);
  return fmt::format("| {} | {} | {} | {} | {:.2e} | {:.1e} | {:.1e} | {:.2f} |\n", name, maps,
                     texels, errors.texels, errors.largest, errors.nearly_all, errors.mean,
                     seconds);
}

StatusOr<std::string> RowsOf(const std::string& path) {
  const StatusOr<PolygonSoup> soup = ReadMesh(path);
  if (!soup.ok()) return soup.status();
  PreflightReport preflight;
  const StatusOr<Surface> surface = Preflight(*soup, &preflight);
  if (!surface.ok()) return surface.status().In(path);
  const auto circle = LocatorOf(*surface, PatternKind::kCircle, false);
  const auto exact = LocatorOf(*surface, PatternKind::kCircle, true);
  const auto equivalence = LocatorOf(*surface, PatternKind::kEquivalence, true);
  for (const auto* map : {&circle, &exact, &equivalence}) {
    if (!map->ok()) return map->status().In(path);
  }
  const std::string name = path.substr(path.find_last_of('/') + 1);
  std::string rows;
  for (int texels = FLAGS_least_texels; texels <= FLAGS_most_texels; texels *= 2) {
    rows += RowOf(*surface, name, texels, "circle pattern to exact", *circle, *exact);
    rows += RowOf(*surface, name, texels, "exact to exact equivalence", *exact, *equivalence);
  }
  return rows;
}

constexpr char kAbout[] =
    R"(A smooth function of the place in space, three waves over the surface's extent, baked for one map, moved
to another (`TransferTexture`, what `transfer` does) and held against the same function baked there at once, at every texel that the
image covers. The function ranges from -1 to 1. Inside an image reading between texels costs the square of their size on the surface; at its
edge, where texels beyond are means of their neighbours, their size. So the largest errors are at the edges where a map shrinks the surface
most and a texel covers much of it; 99.9 % of the texels are below the next column. Where an image overlaps itself a texture has two
places in one texel, and no map can be moved: such meshes have errors as large as the function.

| mesh | from, to | texels a side | of the image | largest error | 99.9 % below | mean error | s |
|---|---|--:|--:|--:|--:|--:|--:|
)";

}  // namespace

Status RunMovedTexture(const StudyCall& call) {
  if (call.arguments.empty()) return Status::InvalidInput("no mesh is given; see --help");
  if (FLAGS_least_texels < 2 || FLAGS_most_texels < FLAGS_least_texels) {
    return Status::InvalidInput("--least_texels: from 2 to --most_texels");
  }
  std::string text = fmt::format("# Moved textures\n\nMade by `{}`: {}", call.command, kAbout);
  for (const std::string& path : call.arguments) {
    const StatusOr<std::string> rows = RowsOf(path);
    if (!rows.ok()) return rows.status();
    text += *rows;
  }
  return Deliver(text);
}

}  // namespace cirque
