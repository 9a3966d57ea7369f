#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "cirque/math/box_tree.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/math/overlap_geometry.h"
#include "cirque/metrics/measures.h"

namespace cirque {
namespace {

using Eigen::Vector2d;
using Triangle = PlaneTriangle;

/// Pieces below this share of the image are rounding.
constexpr double kNegligible = 1e-18;

/// The image of a measurable face, counter-clockwise.
Triangle ImageOf(const MappedFaces& faces, Index i) {
  const auto uv = faces.uv.value.begin() + 3 * faces.face[i];
  return faces.flipped[i] ? Triangle{uv[0], uv[2], uv[1]} : Triangle{uv[0], uv[1], uv[2]};
}

/// A part of a triangle with the number of earlier triangles that cover it, 0 or 1.
struct Piece {
  ConvexPolygon polygon;
  int times_covered = 0;
};

/// Covers the pieces by one triangle more. What is covered twice then is of no more interest.
std::vector<Piece> Cover(std::vector<Piece> pieces, const Triangle& triangle, double negligible) {
  std::vector<Piece> result;
  const auto keep = [&](ConvexPolygon polygon, int times) {
    if (times < 2 && Area(polygon) > negligible) result.push_back({std::move(polygon), times});
  };
  std::vector<ConvexPolygon> outside;
  for (Piece& piece : pieces) {
    outside.clear();
    ConvexPolygon inside = CutByTriangle(std::move(piece.polygon), triangle, &outside);
    for (ConvexPolygon& part : outside) keep(std::move(part), piece.times_covered);
    keep(std::move(inside), piece.times_covered + 1);
  }
  return result;
}

class OverlapSum {
 public:
  explicit OverlapSum(const MappedFaces& faces) : faces_(faces), tree_(Boxes(faces)) {
    std::vector<Index> by_area(faces.num_faces());
    std::iota(by_area.begin(), by_area.end(), 0);
    std::stable_sort(by_area.begin(), by_area.end(),
                     [&](Index i, Index j) { return faces.image_area[i] > faces.image_area[j]; });
    rank_.resize(by_area.size());
    for (Index r = 0; r < faces.num_faces(); ++r) rank_[by_area[r]] = r;
    for (const Index i : by_area) Add(i);
  }

  double once_again() const { return once_again_.Value(); }
  double second_time() const { return second_time_.Value(); }

 private:
  static std::vector<Eigen::AlignedBox2d> Boxes(const MappedFaces& faces) {
    std::vector<Eigen::AlignedBox2d> boxes(faces.num_faces());
    for (Index i = 0; i < faces.num_faces(); ++i) {
      for (const Vector2d& p : ImageOf(faces, i)) boxes[i].extend(p);
    }
    return boxes;
  }

  /// The larger triangles near triangle i, from the largest down.
  std::vector<Index> LargerOnes(Index i, const Triangle& triangle) const {
    Eigen::AlignedBox2d box;
    for (const Vector2d& p : triangle) box.extend(p);
    std::vector<Index> found;
    tree_.VisitMeeting(box, [&](Index j) {
      if (rank_[j] < rank_[i]) found.push_back(j);
    });
    std::sort(found.begin(), found.end(), [&](Index j, Index k) { return rank_[j] < rank_[k]; });
    return found;
  }

  /// Scaled to image area 1, about a point nearby.
  Triangle Scaled(const Triangle& triangle, const Vector2d& origin) const {
    Triangle scaled;
    for (std::size_t k = 0; k < 3; ++k) scaled[k] = (triangle[k] - origin) / faces_.image_size;
    return scaled;
  }

  void Add(Index i) {
    const Triangle triangle = ImageOf(faces_, i), scaled = Scaled(triangle, triangle[0]);
    std::vector<Piece> pieces = {{{scaled.begin(), scaled.end()}, 0}};
    bool overlaps = false;
    for (const Index j : LargerOnes(i, triangle)) {
      const Triangle other = ImageOf(faces_, j);
      if (pieces.empty()) break;
      if (!InteriorsMeet(triangle, other)) continue;
      overlaps = true;
      pieces = Cover(std::move(pieces), Scaled(other, triangle[0]), kNegligible);
    }
    if (!overlaps) return;
    double area[2] = {0, 0};
    for (const Piece& piece : pieces) area[piece.times_covered] += Area(piece.polygon);
    once_again_ += std::max(0.0, faces_.image_area[i] - area[0]);
    second_time_ += area[1];
  }

  const MappedFaces& faces_;
  BoxTree tree_;
  std::vector<Index> rank_;
  CompensatedSum once_again_;   ///< what later triangles cover of earlier ones
  CompensatedSum second_time_;  ///< the part of it that had been covered once
};

Measurement MeasureOverlap(const MappedFaces& faces) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  if (faces.num_faces() == 0) return {{}, {kNothing, kNothing}};
  const OverlapSum sum(faces);
  return {{}, {sum.once_again(), sum.second_time()}};
}

Measurement MeasureFlipped(const MappedFaces& faces) {
  Eigen::VectorXd flipped(faces.num_faces());
  for (Index i = 0; i < faces.num_faces(); ++i) flipped[i] = faces.flipped[i] ? 1 : 0;
  const double share = flipped.sum() / faces.num_faces();  // NaN without a face
  return {flipped, {std::min(share, 1 - share)}};
}

Measurement CountDegenerate(const MappedFaces& faces) {
  return {{}, {static_cast<double>(faces.triangulation.num_faces() - faces.num_faces())}};
}

}  // namespace

DistortionMeasure Flipped() {
  return {"injectivity",
          "1 where flipped, else 0",
          0,
          1,
          {{"flipped_share", "min(p, 1 - p), p the share of flipped faces (Shay, Solomon, Stein)"}},
          MeasureFlipped};
}

DistortionMeasure Overlap() {
  return {.group = "injectivity",
          .figures = {{"overlap_area", "1 - area of the union, total 1 (Shay, Solomon, Stein)"},
                      {"covered_twice_area", "area covered at least twice, total 1"}},
          .measure = MeasureOverlap};
}

DistortionMeasure Degenerate() {
  return {.group = "injectivity",
          .figures = {{"degenerate_faces", "faces without area, left out of all other figures"}},
          .measure = CountDegenerate};
}

}  // namespace cirque
