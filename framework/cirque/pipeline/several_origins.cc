#include "cirque/pipeline/several_origins.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cirque/cuts/cut_graph.h"
#include "cirque/cuts/split_off.h"
#include "cirque/math/predicates.h"

namespace cirque {
namespace {

constexpr double kLengthError = 1e-9;  ///< relative, of a laid out edge

double Side(const FlatTriangles& of, Index h) {
  return of.flat.lengths.value[of.triangulation.edge[h]];
}

/// The largest relative error of the sides of a face as it lies.
double LengthError(const FlatTriangles& of, const CornerUv& uv, Index f) {
  double worst = 0;
  for (Index h = 3 * f; h < 3 * f + 3; ++h) {
    const double side = Side(of, h);
    const auto along = uv.value[Triangulation::Prev(h)] - uv.value[Triangulation::Next(h)];
    worst = std::max(worst, std::abs(along.stableNorm() - side) / side);
  }
  return worst;
}

bool IsHeld(const FlatTriangles& of, const CornerUv& uv, Index f) {
  const Eigen::Vector2d* corner = &uv.value[3 * f];
  return LengthError(of, uv, f) <= kLengthError &&
         OrientationSign(corner[0], corner[1], corner[2]) > 0;
}

std::vector<Index> FacesNotHeld(const FlatTriangles& of, const CornerUv& uv) {
  std::vector<Index> faces;
  for (Index f = 0; f < of.triangulation.num_faces(); ++f) {
    if (!IsHeld(of, uv, f)) faces.push_back(f);
  }
  return faces;
}

/// Angles of caps next to 0 have digits that directions do not.
void PlaceAlone(const FlatTriangles& of, Index f, CornerUv* uv) {
  Index longest = 3 * f;
  for (Index h = 3 * f; h < 3 * f + 3; ++h) {
    if (Side(of, h) > Side(of, longest)) longest = h;
  }
  const Index tail = Triangulation::Next(longest), tip = Triangulation::Prev(longest);
  // The side opposite the tip ends in the tail.
  const bool from_tail = Side(of, tip) <= Side(of, tail);
  const double sign = from_tail ? 1 : -1;
  const Index origin = from_tail ? tail : tip, other = from_tail ? tip : tail;
  const double leg = Side(of, other), angle = of.flat.angles.value[origin];
  uv->value[origin] = {0, 0};
  uv->value[other] = {sign * Side(of, longest), 0};
  uv->value[longest] = {sign * leg * std::cos(angle), leg * std::sin(angle)};
}

void PlaceLonePatches(const FlatTriangles& of, PlanarLayout* layout) {
  std::vector<Index> faces(layout->patches.count, 0);
  for (const Index p : layout->patches.of_face) ++faces[p];
  for (Index f = 0; f < of.triangulation.num_faces(); ++f) {
    const Index patch = layout->patches.of_face[f];
    if (faces[patch] > 1) continue;
    PlaceAlone(of, f, &layout->uv);
    layout->patch_closure[patch] = LengthError(of, layout->uv, f);
  }
  layout->closure = *std::max_element(layout->patch_closure.begin(), layout->patch_closure.end());
}

Status TooSmall(const FlatTriangles& of, Index f) {
  return Status(
      StatusCode::kUnrepresentable,
      fmt::format("doubles do not hold face {} (0-based) of the flat metric even by itself: "
                  "its sides are {:.3g}, {:.3g} and {:.3g}; add cones there",
                  f, Side(of, 3 * f), Side(of, 3 * f + 1), Side(of, 3 * f + 2)));
}

/// Opens all sides of the faces.
Cut PartAll(const Triangulation& t, const std::vector<Index>& faces, Cut cut) {
  for (const Index f : faces) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (t.twin[h] != kNone) cut.edge[t.edge[h]] = true;
    }
  }
  return cut;
}

Status LayOutAlong(const FlatTriangles& of, const Cut& split, Cut* cut, PlanarLayout* layout) {
  const auto& [t, flat, cones] = of;
  StatusOr<Cut> further = CompleteCut(t, flat.lengths.value, split, cones);
  if (!further.ok()) return further.status();
  *cut = *std::move(further);
  *layout = LayOutPatches(t, flat.angles, flat.lengths, *cut);
  PlaceLonePatches(of, layout);
  return Status();
}

}  // namespace

Status LayOutAboutSeveralOrigins(const FlatTriangles& of, const std::vector<Index>& alone, Cut* cut,
                                 PlanarLayout* layout) {
  const Triangulation& t = of.triangulation;
  if (!alone.empty()) {
    if (Status s = LayOutAlong(of, PartAll(t, alone, *cut), cut, layout); !s.ok()) return s;
  }
  for (std::vector<Index> left = FacesNotHeld(of, layout->uv); !left.empty();
       left = FacesNotHeld(of, layout->uv)) {
    const Cut split = SplitOff(t, *cut, left);
    if (split.edge == cut->edge) return TooSmall(of, left.front());
    if (Status s = LayOutAlong(of, split, cut, layout); !s.ok()) return s;
  }
  return Status();
}

}  // namespace cirque
