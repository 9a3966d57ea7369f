// A linear map of a flat surface has the same singular values on every face, so that every quality
// figure has a value in closed form.
#include <cmath>
#include <map>

#include <Eigen/Geometry>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/metrics/maps.h"

namespace cirque {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

Matrix2d Turn(double angle) { return Eigen::Rotation2Dd(angle).toRotationMatrix(); }

/// The map p -> Turn(0.4) diag(s, t) Turn(1.1) p, |s| >= |t|; of negative s t it mirrors.
struct LinearMap {
  double s, t;

  Matrix2d Matrix() const { return Turn(0.4) * Vector2d(s, t).asDiagonal() * Turn(1.1); }
  double Ratio() const { return std::abs(s / t); }
};

Surface FlatPatch() { return GeneratedSurface("flat_delaunay_patch", 120); }

TestMap Apply(const LinearMap& map, const Surface& surface) {
  return MapOf(surface,
               [&](const Eigen::Vector3d& p) -> Vector2d { return map.Matrix() * p.head<2>(); });
}

/// By what every corner angle of the surface changes [rad], by the law of cosines.
Eigen::Matrix3Xd AngleChanges(const LinearMap& map, const Surface& surface) {
  const Triangulation& t = surface.triangulation;
  const auto angle = [&](const Matrix2d& m, Index h) {
    const auto at = [&](Index c) -> Vector2d {
      return m * surface.position[t.vertex[c]].head<2>();
    };
    const Vector2d a = at(Triangulation::Next(h)) - at(h), b = at(Triangulation::Prev(h)) - at(h);
    return std::acos(a.dot(b) / (a.norm() * b.norm()));
  };
  Eigen::Matrix3Xd change(3, t.num_faces());
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    change(h % 3, h / 3) = std::abs(angle(map.Matrix(), h) - angle(Matrix2d::Identity(), h));
  }
  return change;
}

/// The larger side of the image's bounding box.
double Extent(const TestMap& map) {
  Eigen::AlignedBox2d box;
  for (const Vector2d& p : map.uv.value) box.extend(p);
  return box.sizes().maxCoeff();
}

/// The square has area 4, the image 4 |s t|; of area 1 each, the singular values are the roots of
/// the ratio and of its inverse.
std::map<std::string, double> ExpectedFigures(const LinearMap& map, const Surface& surface) {
  const double q = map.Ratio(), extent = Extent(Apply(map, surface));
  const TestMap identity = Apply({1, 1}, surface);
  const MappedFaces faces = MeasureFaces(identity.triangulation, identity.lengths, identity.uv);
  const Eigen::Matrix3Xd changes = AngleChanges(map, surface);
  const double discrepancy = changes.colwise().sum().dot(faces.area);
  const double pixels = extent / std::sqrt(4 * std::abs(map.s * map.t)) * std::sqrt(q);
  return {{"quasi_conformal_mean", q},
          {"quasi_conformal_p50", q},
          {"quasi_conformal_p95", q},
          {"quasi_conformal_p99", q},
          {"quasi_conformal_max", q},
          {"angle_error_mean", discrepancy / 3},
          {"angle_error_max", changes.maxCoeff()},
          {"angle_discrepancy", discrepancy},
          {"angle_distortion_max", q + 1 / q - 2},
          {"log_area_ratio_min", 0},
          {"log_area_ratio_max", 0},
          {"log_area_ratio_mean", 0},
          {"log_area_ratio_l2", 0},
          {"log_scale_max", 0},
          {"log_scale_l2", 0},
          {"area_distortion_max", 0},
          {"area_discrepancy", 0},
          {"symmetric_dirichlet", q + 1 / q},
          {"symmetric_dirichlet_max", q + 1 / q},
          {"singular_value_min", 1 / std::sqrt(q)},
          {"singular_value_max", std::sqrt(q)},
          {"resolution", 2 * pixels},
          {"resolution_unit_area", pixels},
          {"cut_length", 0},
          {"flipped_share", 0},
          {"overlap_area", 0},
          {"covered_twice_area", 0},
          {"degenerate_faces", 0}};
}

class LinearMaps : public testing::TestWithParam<LinearMap> {};

TEST_P(LinearMaps, EveryFigureHasItsValue) {
  const Surface patch = FlatPatch();
  const MapMeasures measures = Apply(GetParam(), patch).Measure();
  std::map<std::string, double> expected = ExpectedFigures(GetParam(), patch);
  for (const MapMeasures::Figure& figure : measures.figures) {
    ASSERT_TRUE(expected.contains(figure.name)) << figure.name << " has no value in closed form";
    const double value = expected[figure.name];
    EXPECT_NEAR(figure.value, value, 1e-9 * (1 + value)) << figure.name;
  }
  EXPECT_EQ(expected.size(), measures.figures.size());
}

TEST_P(LinearMaps, EveryFaceHasTheSameValueBesideItsAngles) {
  const LinearMap& map = GetParam();
  const Surface patch = FlatPatch();
  const MapMeasures measures = Apply(map, patch).Measure();
  const double q = map.Ratio();
  const std::map<std::string, double> expected = {{"quasi_conformal", q},
                                                  {"angle_distortion", q + 1 / q - 2},
                                                  {"log_area_ratio", 0},
                                                  {"log_scale", 0},
                                                  {"area_distortion", 0},
                                                  {"area_discrepancy", 0},
                                                  {"symmetric_dirichlet", q + 1 / q},
                                                  {"singular_value_min", 1 / std::sqrt(q)},
                                                  {"singular_value_max", std::sqrt(q)},
                                                  {"flipped", map.s * map.t < 0 ? 1 : 0}};
  for (const auto& [name, value] : expected) {
    const Eigen::ArrayXd found = measures.FaceValuesOf(name).value;
    ASSERT_EQ(found.size(), patch.triangulation.num_faces());
    EXPECT_LT((found - value).abs().maxCoeff(), 1e-9 * (1 + value)) << name;
  }
  const Eigen::VectorXd mean_change = AngleChanges(map, patch).colwise().mean();
  EXPECT_LT((measures.FaceValuesOf("angle_error").value - mean_change).cwiseAbs().maxCoeff(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(OfChosenSingularValues, LinearMaps,
                         testing::Values(LinearMap{1, 1}, LinearMap{3, 3}, LinearMap{1.01, 1},
                                         LinearMap{2, 0.5}, LinearMap{7e-6, 1e-6}, LinearMap{40, 1},
                                         LinearMap{2, -0.5}, LinearMap{-1, 1}));

}  // namespace
}  // namespace cirque
