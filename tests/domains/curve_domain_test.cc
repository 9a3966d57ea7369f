// Maps onto what a closed curve bounds, by conformal maps that are known and by the curve itself.
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/domains/curves.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/inscribed_in_curve.h"
#include "cirque/generators/known_maps.h"
#include "cirque/metrics/injectivity.h"

#include "tests/common/domain_maps.h"
#include "tests/common/surfaces.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;
using Eigen::Vector2d;
using ::testing::HasSubstr;

std::string TextOf(const std::vector<Vector2d>& points) {
  std::string text = "# x y\n";
  for (const Vector2d& p : points) text += fmt::format("{:.17g} {:.17g}\n", p.x(), p.y());
  return text;
}

MapRequest RequestForCurve(const std::string& curve, Index start = kNone) {
  DomainOptions shape;
  shape.curve = curve;
  shape.angle_zero = start;
  return RequestFor("curve", shape);
}

std::vector<Index> BoundaryOf(const Surface& surface) {
  const std::vector<Index> loop = BoundaryLoops(surface.triangulation).front();
  std::vector<Index> boundary;
  for (const Index h : loop) {
    boundary.push_back(surface.triangulation.Tail(h));
  }
  return boundary;
}

double DistanceFrom(const ClosedCurve& curve, Complex z) {
  const Vector2d p(z.real(), z.imag());
  double least = std::numeric_limits<double>::infinity();
  const auto& points = curve.points();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Vector2d side = points[(k + 1) % points.size()] - points[k];
    const double share = std::clamp((p - points[k]).dot(side) / side.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - points[k] - share * side).norm());
  }
  return least;
}

double FarthestFromCurve(const Surface& surface, const SurfaceMap& map, const std::string& option) {
  const ClosedCurve curve = *CurveOf(option);
  const std::vector<Complex> place = PlacesOf(surface, map);
  double farthest = 0;
  for (const Index v : BoundaryOf(surface)) {
    farthest = std::max(farthest, DistanceFrom(curve, place[v]));
  }
  return farthest;
}

void ExpectOnCurve(const Surface& surface, const SurfaceMap& map, const std::string& option) {
  EXPECT_LT(FarthestFromCurve(surface, map, option), 1e-13);
  EXPECT_TRUE(FlippedFaces(surface.triangulation, map.uv).empty());
  EXPECT_EQ(map.certificate.overlap, "injective");
}

TEST(MapToCurve, AFlatSurfaceOntoItsOwnBoundaryIsLeftAsItIs) {
  Surface flat = GeneratedSurface("bumpy_terrain", 400);
  // Not convex, and far from a circle.
  for (Eigen::Vector3d& x : flat.position) x = {x.x() + 0.5 * x.y() * x.y(), x.y(), 0};
  std::vector<Vector2d> points;
  const std::vector<Index> boundary = BoundaryOf(flat);
  for (const Index v : boundary) points.emplace_back(flat.position[v].head<2>());
  const TemporaryFolder folder;
  const std::string curve = folder.Write("own.curve", TextOf(points));
  MapRequest request = RequestForCurve(curve, boundary[0]);
  const SurfaceMap map = MustMap(flat, request);
  ExpectOnCurve(flat, map, curve);
  const std::vector<Complex> place = PlacesOf(flat, map);
  for (std::size_t v = 0; v < place.size(); ++v) {
    EXPECT_NEAR(place[v].real(), flat.position[v].x(), 1e-7);
    EXPECT_NEAR(place[v].imag(), flat.position[v].y(), 1e-7);
  }
  EXPECT_EQ(map.certificate.curve->start_vertex, flat.soup_vertex[boundary[0]]);
  EXPECT_LT(map.certificate.curve->length_mismatch, 1e-9);
  // The beginning is found without being named.
  request.shape.angle_zero = kNone;
  EXPECT_EQ(MustMap(flat, request).certificate.curve->start_vertex, flat.soup_vertex[boundary[0]]);
}

/// w of w + 0.3 w^2, |w| <= 1: the conformal map from the disk onto a region with a dent.
constexpr double kDent = 0.3;
Complex Dented(Complex w) { return w + kDent * w * w; }
Complex Undented(Complex z) { return (std::sqrt(1.0 + 4 * kDent * z) - 1.0) / (2 * kDent); }

Complex CrossRatio(const std::vector<Complex>& z, std::size_t a, std::size_t b, std::size_t c,
                   std::size_t d) {
  return (z[a] - z[c]) * (z[b] - z[d]) / ((z[b] - z[c]) * (z[a] - z[d]));
}

/// Largest difference of cross ratios of what the map is on the disk from those of the known map.
double MoebiusMiss(Index triangles, const std::string& curve) {
  const Surface hemisphere = GeneratedSurface("hemisphere", triangles);
  const SurfaceMap map = MustMap(hemisphere, RequestForCurve(curve));
  EXPECT_LT(map.certificate.curve->length_mismatch, 1e-7);
  std::vector<Complex> found, known;
  for (const Complex z : PlacesOf(hemisphere, map)) found.push_back(Undented(z));
  const ConformalMap stereographic = StereographicMap();
  for (const Eigen::Vector3d& x : hemisphere.position) {
    const Vector2d p = stereographic.to_plane(x);
    known.emplace_back(p.x(), p.y());
  }
  const std::vector<Index> boundary = BoundaryOf(hemisphere);
  const std::size_t third = boundary.size() / 3;
  double miss = 0;
  for (std::size_t v = 0; v < known.size(); ++v) {
    if (std::abs(known[v]) > 0.8) continue;
    const auto ratio = [&](const std::vector<Complex>& z) {
      return CrossRatio(z, v, boundary[0], boundary[third], boundary[2 * third]);
    };
    miss = std::max(miss, std::abs(ratio(found) - ratio(known)));
  }
  return miss;
}

TEST(MapToCurve, IsTheRiemannMapAsMeshesGetFiner) {
  std::vector<Vector2d> points;
  for (int k = 0; k < 2000; ++k) {
    const Complex z = Dented(std::polar(1.0, 2 * kPi * k / 2000));
    points.emplace_back(z.real(), z.imag());
  }
  const TemporaryFolder folder;
  const std::string curve = folder.Write("dented.curve", TextOf(points));
  const double coarse = MoebiusMiss(400, curve), fine = MoebiusMiss(3200, curve);
  EXPECT_LT(coarse, 0.1);
  EXPECT_LT(fine, coarse / 3);
}

TEST(MapToCurve, CornersOfTheCurveGetAVertex) {
  const Surface hemisphere = GeneratedSurface("hemisphere", 800);
  const TemporaryFolder folder;
  // Clockwise, and not convex.
  const std::string curve = folder.Write("arrow.curve", "0 0\n-1 2\n3 0\n-1 -2\n");
  const SurfaceMap map = MustMap(hemisphere, RequestForCurve(curve));
  ExpectOnCurve(hemisphere, map, curve);
  EXPECT_EQ(map.certificate.curve->corners, 4);
  const std::vector<Complex> place = PlacesOf(hemisphere, map);
  for (const Complex corner : {Complex(0, 0), Complex(-1, 2), Complex(3, 0), Complex(-1, -2)}) {
    EXPECT_EQ(std::count(place.begin(), place.end(), corner), 1) << corner;
  }
}

TEST(MapToCurve, TheVertexNamedLiesAtTheFirstPoint) {
  const Surface hemisphere = GeneratedSurface("hemisphere", 400);
  const Index start = BoundaryOf(hemisphere)[7];
  const SurfaceMap map = MustMap(hemisphere, RequestForCurve("ellipse:ratio=3", start));
  ExpectOnCurve(hemisphere, map, "ellipse:ratio=3");
  EXPECT_EQ(PlacesOf(hemisphere, map)[start], Complex(3, 0));
}

TEST(MapToCurve, RefusesWhatDoesNotFit) {
  const Surface hemisphere = GeneratedSurface("hemisphere", 200);
  const TemporaryFolder folder;
  const auto message = [&](const MapRequest& request) {
    return MustFail(hemisphere, request, StatusCode::kInvalidInput).message;
  };
  const std::vector<Index> boundary = BoundaryOf(hemisphere);
  Index inner = 0;
  while (std::find(boundary.begin(), boundary.end(), inner) != boundary.end()) ++inner;
  EXPECT_THAT(message(RequestForCurve("ellipse", inner)), HasSubstr("no vertex of the boundary"));
  EXPECT_THAT(message(RequestForCurve(folder.Path("none"))), HasSubstr("none"));
  EXPECT_THAT(message(RequestForCurve("ellipse:ratio=0.5")), HasSubstr("ratio"));
  EXPECT_THAT(message(RequestForCurve("elipse:ratio=2")), HasSubstr("did you mean 'ellipse'"));
  const std::string words = folder.Write("words", "0 0\n1 zero\n");
  EXPECT_THAT(message(RequestForCurve(words)), HasSubstr(words + ":2: expected x and y"));
  const std::string eight = folder.Write("eight", "0 0\n4 0\n1 3\n3 3\n");
  EXPECT_THAT(message(RequestForCurve(eight)), HasSubstr("meets itself"));
}

TEST(MapToCurve, ACurveTooFineForTheBoundaryIsSaid) {
  std::vector<Vector2d> comb;  // fifty teeth for a dozen vertices
  for (int k = 0; k < 50; ++k) {
    comb.emplace_back(k, 0);
    comb.emplace_back(k + 0.5, -40);
  }
  comb.emplace_back(50, 0);
  comb.emplace_back(50, 0.1);
  comb.emplace_back(0, 0.1);
  const TemporaryFolder folder;
  const std::string curve = folder.Write("comb", TextOf(comb));
  const Certificate failed = MustFail(GeneratedSurface("hemisphere", 40), RequestForCurve(curve),
                                      StatusCode::kUnrepresentable);
  EXPECT_THAT(failed.message, HasSubstr("too fine"));
}

TEST(InscribedPolygons, AnglesAreThoseOfTheCornersAndAddUp) {
  const ClosedCurve square = *ClosedCurve::Through({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const InscribedPolygons polygons(square);
  const Eigen::VectorXd even = Eigen::VectorXd::Zero(8);
  const Eigen::VectorXd lower = Eigen::VectorXd::Constant(8, 0.1);
  Eigen::VectorXd upper = Eigen::VectorXd::Constant(8, 5);
  const Eigen::VectorXd angles = polygons.Angles(even, lower, upper);
  for (Eigen::Index k = 0; k < 8; ++k) EXPECT_NEAR(angles[k], k % 2 ? kPi : kPi / 2, 1e-14);
  EXPECT_LT(polygons.Missing(even, Eigen::VectorXd::Constant(8, 3)).norm(), 1e-14);
  // A corner that reaches less leaves the rest to its neighbours.
  upper[3] = 2;
  const Eigen::VectorXd bounded = polygons.Angles(even, lower, upper);
  EXPECT_NEAR(bounded.sum(), 6 * kPi, 1e-12);
  EXPECT_NEAR(bounded[3], 2, 1e-12);
  EXPECT_GT(bounded[2], kPi / 2 + 0.4);
}

TEST(InscribedPolygons, NearestStartFindsTheTurn) {
  const ClosedCurve curve = *ClosedCurve::Through({{0, 0}, {3, 0}, {3, 1}, {2, 2}, {0, 1}});
  // The same polygon, scaled, from its third corner on.
  Eigen::VectorXd lengths(5), angles(5);
  for (Eigen::Index k = 0; k < 5; ++k) {
    const auto of = static_cast<std::size_t>((k + 2) % 5);
    lengths[k] = 7 * (curve.arcs()[of + 1] - curve.arcs()[of]);
    angles[k] = kPi - curve.TurningAt(of);
  }
  EXPECT_EQ(NearestStart(curve, lengths, angles), 3);
}

}  // namespace
}  // namespace cirque
