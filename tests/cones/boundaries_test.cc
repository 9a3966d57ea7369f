// Boundaries by name: the linear model behind them, and what every registered shape promises.
#include "cirque/cones/boundaries.h"

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cirque/cones/boundary_problem.h"
#include "cirque/cones/linear_model.h"
#include "cirque/cones/log_scale_norm.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"
#include "tests/common/temporary_folder.h"

namespace cirque {
namespace {

/// A surface with a boundary, and its linear model.
class ModelOf {
 public:
  explicit ModelOf(const std::string& generator, Index triangles = 600, double scale = 1)
      : surface_(GeneratedSurface(generator, triangles)),
        lengths_{scale * MeasureEdgeLengths(surface_).value},
        intrinsic_(MeasureSurface(surface_.triangulation, lengths_)),
        problem(MeasureSurface(surface_.triangulation, lengths_), intrinsic_,
                FreeBoundaryTargets(surface_.triangulation)) {}

  const Triangulation& t() const { return surface_.triangulation; }
  const EdgeLengths& lengths() const { return lengths_; }
  const IntrinsicSurface& intrinsic() const { return intrinsic_; }

  Eigen::VectorXd Choose(const std::string& text) {
    const auto shape = ParseBoundaryShape(text);
    EXPECT_TRUE(shape.ok()) << shape.status().message();
    const StatusOr<Eigen::VectorXd> sums = (*shape)->Choose(&problem);
    EXPECT_TRUE(sums.ok()) << sums.status().message();
    return *sums;
  }

 private:
  Surface surface_;
  EdgeLengths lengths_;
  IntrinsicSurface intrinsic_;

 public:
  BoundaryProblem problem;
};

Eigen::VectorXd RandomOf(Index n, unsigned seed) {
  std::srand(seed);
  return Eigen::VectorXd::Random(n);
}

double Sum(const BoundaryProblem& problem, const Eigen::VectorXd& sums) {
  CompensatedSum sum;
  for (const Index v : problem.boundary()) sum += sums[v];
  return sum.Value();
}

TEST(BoundaryProblem, TheAdjointIsThatOfTheHarmonicExtension) {
  for (const char* generator : {"bumpy_terrain", "catenoid", "enneper_patch"}) {
    const ModelOf model(generator);
    const Eigen::VectorXd b = RandomOf(model.t().num_vertices, 1);
    const Eigen::VectorXd w = RandomOf(model.t().num_vertices, 2);
    const double one = model.problem.Harmonic(b).dot(w);
    EXPECT_GT(std::abs(one), 1e-3);
    EXPECT_NEAR(one, model.problem.HarmonicAdjoint(w).dot(b), 1e-10);
  }
}

/// Cotangents reproduce linear functions of the plane.
TEST(BoundaryProblem, ExtendsLinearFunctionsAsTheyAre) {
  const Surface surface = GeneratedSurface("flat_delaunay_patch", 600);
  const ModelOf model("flat_delaunay_patch");
  Eigen::VectorXd linear(model.t().num_vertices);
  for (Index v = 0; v < linear.size(); ++v) {
    linear[v] = 0.3 + surface.position[v].x() - 2 * surface.position[v].y();
  }
  EXPECT_LT((model.problem.Harmonic(linear) - linear).lpNorm<Eigen::Infinity>(), 1e-9);
}

/// A flat surface has its own angle sums without a change of scale.
TEST(BoundaryProblem, AFlatSurfaceKeepsItsAngles) {
  ModelOf model("annulus");
  const std::vector<double> own = VertexAngleSums(model.t(), model.intrinsic().angles);
  const Eigen::VectorXd sums = model.Choose("isometric");
  for (const Index v : model.problem.boundary()) EXPECT_NEAR(sums[v], own[v], 1e-9);
}

/// A cap of a sphere is a round disk: every stretch of its boundary turns by its length.
TEST(BoundaryProblem, ASphericalCapIsRound) {
  for (const char* shape : {"isometric", "least_area", "least_max"}) {
    ModelOf model("spherical_cap", 4000);
    const Eigen::VectorXd sums = model.Choose(shape);
    const std::vector<Index> loop = BoundaryLoops(model.t()).front();
    const auto length = [&](std::size_t i) {
      return model.lengths().value[model.t().edge[loop[i]]];
    };
    double total = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) total += length(i);
    double turned = 0, passed = -length(0) / 2;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      turned += (kPi - sums[model.t().Tail(loop[i])]) / (2 * kPi);
      passed += length(i);
      EXPECT_NEAR(turned, (passed - length(i) / 2) / total, 0.02) << shape;
    }
    EXPECT_NEAR(turned, 1, 1e-12);
  }
}

TEST(BoundaryProblem, DoesNotDependOnScale) {
  for (const char* shape : {"isometric", "least_area", "least_max", "straight"}) {
    ModelOf one("bumpy_terrain"), other("bumpy_terrain", 600, 37);
    EXPECT_LT((one.Choose(shape) - other.Choose(shape)).lpNorm<Eigen::Infinity>(), 1e-3) << shape;
  }
}

/// A dense matrix of H and the normal equations of the least squares agree.
TEST(LogScaleNorm, IsLeastAsADenseSolveHasIt) {
  const ModelOf model("bumpy_terrain", 300);
  const BoundaryProblem& problem = model.problem;
  const auto n = static_cast<Index>(problem.boundary().size());
  Eigen::MatrixXd h(model.t().num_vertices, n);
  for (Index k = 0; k < n; ++k) {
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(model.t().num_vertices);
    unit[problem.boundary()[k]] = 1;
    h.col(k) = problem.Harmonic(unit);
  }
  const Eigen::VectorXd u0 = problem.LogScale(Eigen::VectorXd::Zero(model.t().num_vertices));
  const Eigen::MatrixXd weighted = problem.area().asDiagonal() * h;
  const Eigen::VectorXd expected =
      (h.transpose() * weighted).ldlt().solve(-weighted.transpose() * u0);
  const Eigen::VectorXd b = LeastNormLogScale(problem, 2, 0);
  EXPECT_GT(expected.norm(), 0.01);
  for (Index k = 0; k < n; ++k) EXPECT_NEAR(b[problem.boundary()[k]], expected[k], 1e-3);
}

/// Norms fall as they should: that of p is least at its own minimum.
TEST(LogScaleNorm, EachNormIsLeastAtItsOwnMinimum) {
  const ModelOf model("enneper_patch", 800);
  const BoundaryProblem& problem = model.problem;
  const auto norm = [&](const Eigen::VectorXd& b, int p) {
    const Eigen::VectorXd u = problem.LogScale(b);
    return std::pow(problem.area().dot(u.array().abs().pow(p).matrix()), 1. / p);
  };
  const Eigen::VectorXd two = LeastNormLogScale(problem, 2, 0);
  const Eigen::VectorXd eight = LeastNormLogScale(problem, 8, 0);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(two.size());
  EXPECT_LT(norm(two, 2), 0.95 * norm(zero, 2));
  EXPECT_LT(norm(two, 2), norm(eight, 2));
  EXPECT_LT(norm(eight, 8), norm(two, 8));
  for (unsigned seed = 1; seed < 5; ++seed) {
    const Eigen::VectorXd change = 1e-2 * RandomOf(two.size(), seed);
    EXPECT_GT(norm(two + change, 2), norm(two, 2));
    EXPECT_GT(norm(eight + change, 8), norm(eight, 8));
  }
}

TEST(BoundaryShapes, StraightHasItsCornersAndNoOther) {
  ModelOf model("hemisphere");
  const Eigen::VectorXd sums = model.Choose("straight:corners=5");
  int corners = 0;
  for (const Index v : model.problem.boundary()) {
    if (std::abs(sums[v] - kPi) < 1e-9) continue;
    EXPECT_NEAR(sums[v], kPi - 2 * kPi / 5, 1e-9);
    ++corners;
  }
  EXPECT_EQ(corners, 5);
}

TEST(BoundaryShapes, GivenTakesThoseOfTheFile) {
  const TemporaryFolder folder;
  ModelOf model("bumpy_terrain");
  const Index v = model.problem.boundary()[7];
  const std::string path = folder.path() + "/cones";
  std::ofstream(path) << v + 1 << " 0.8\n";  // counted from 1, of pi
  const Eigen::VectorXd sums = model.Choose("given:file=" + path);
  EXPECT_NEAR(sums[v], 0.8 * kPi, 0.02);  // but for the share of what Gauss-Bonnet then misses
  EXPECT_NEAR(Sum(model.problem, sums), model.problem.TotalAngleSum(), 1e-13 * sums.sum());
}

TEST(BoundaryShapes, RefuseWhatTheyDoNotKnow) {
  EXPECT_THAT(ParseBoundaryShape("round").status().message(), testing::HasSubstr("least_area"));
  EXPECT_THAT(ParseBoundaryShape("least_area:share=2").status().message(),
              testing::HasSubstr("share"));
  EXPECT_FALSE(CheckBoundaryShape("isometric:share=1").ok());
  EXPECT_TRUE(CheckBoundaryShape("free").ok());
  EXPECT_THAT(CheckBoundaryShape("fre").message(), testing::HasSubstr("did you mean 'free'"));
  ModelOf model("hemisphere", 100);
  EXPECT_FALSE((*ParseBoundaryShape("given"))->Choose(&model.problem).ok());
}

struct Case {
  std::string shape, generator;
};

std::vector<Case> Cases() {
  std::vector<Case> cases;
  for (const std::string& shape : BoundaryShapes().Names()) {
    for (const char* generator : {"bumpy_terrain", "enneper_patch", "hexagonal_fan", "catenoid"}) {
      cases.push_back({shape, generator});
    }
  }
  return cases;
}

class EveryBoundaryShape : public testing::TestWithParam<Case> {
 protected:
  EveryBoundaryShape() : text_(GetParam().shape) {
    if (text_ != "given") return;
    std::ofstream(folder_.path() + "/cones") << "";
    text_ += ":file=" + folder_.path() + "/cones";
  }

  const TemporaryFolder folder_;
  std::string text_;
};

TEST_P(EveryBoundaryShape, KeepsBoundsAndGaussBonnet) {
  ModelOf model(GetParam().generator);
  const Eigen::VectorXd sums = model.Choose(text_);
  EXPECT_NEAR(Sum(model.problem, sums), model.problem.TotalAngleSum(), 1e-12);
  for (Index v = 0; v < model.t().num_vertices; ++v) {
    if (!model.intrinsic().boundary[v]) {
      EXPECT_EQ(sums[v], 0);
      continue;
    }
    const auto [lower, upper] = model.problem.BoundsOf(v);
    EXPECT_GE(sums[v], lower - 1e-11);
    EXPECT_LE(sums[v], upper + 1e-11);
  }
}

TEST_P(EveryBoundaryShape, IsThatOfTheMap) {
  const Surface surface = GeneratedSurface(GetParam().generator, 600);
  ParameterizeRequest request;
  request.options.boundary = text_;
  Parameterization result;
  const Status status = Parameterize(surface, request, SolveControl(), &result);
  ASSERT_TRUE(status.ok()) << status.message();
  ASSERT_TRUE(result.certificate.boundary);
  const Triangulation& t = surface.triangulation;
  std::vector<double> sum(t.num_vertices, 0);
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    sum[t.vertex[h]] += result.flat.on_input.angles.value[h];
  }
  const double range = result.certificate.boundary->boundary_range;
  const std::vector<bool> boundary = BoundaryVertices(t);
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (!boundary[v]) continue;
    EXPECT_GE(sum[v], result.targets.lower[v] - 1e-8);
    EXPECT_LE(sum[v], result.targets.upper[v] + 1e-8);
    EXPECT_LE(result.targets.upper[v] - result.targets.lower[v], 2 * range + 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryBoundaryShape, testing::ValuesIn(Cases()),
                         [](const auto& of) { return of.param.shape + "_" + of.param.generator; });

TEST(FlattenWithBoundary, RefusesClosedSurfacesAndPrescribedBoundaries) {
  ParameterizeRequest request;
  request.options.boundary = "isometric";
  Parameterization result;
  const Surface closed = GeneratedSurface("blob", 300);
  Status status = Parameterize(closed, request, SolveControl(), &result);
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(status.message(), testing::HasSubstr("closed"));
  const Surface open = GeneratedSurface("hemisphere", 300);
  request.targets = FreeBoundaryTargets(open.triangulation);
  for (Index v = 0; v < open.triangulation.num_vertices; ++v) {
    if (BoundaryVertices(open.triangulation)[v]) request.targets->lower[v] = 1;
  }
  status = Parameterize(open, request, SolveControl(), &result);
  EXPECT_EQ(status.code(), StatusCode::kInvalidInput);
  EXPECT_THAT(status.message(), testing::HasSubstr("prescribe"));
}

/// Opened along free seams a closed surface has a boundary.
TEST(FlattenWithBoundary, TakesWhatFreeSeamsOpen) {
  ParameterizeRequest request;
  request.options.boundary = "least_area";
  request.options.seams = SeamKind::kFree;
  Parameterization least, free;
  const Surface closed = GeneratedSurface("blob", 800);
  ASSERT_TRUE(Parameterize(closed, request, SolveControl(), &least).ok());
  request.options.boundary = "free";
  ASSERT_TRUE(Parameterize(closed, request, SolveControl(), &free).ok());
  EXPECT_GT(least.certificate.boundary->boundary_vertices, 10);
  EXPECT_LT(least.certificate.distortion->log_area_ratio_l2,
            free.certificate.distortion->log_area_ratio_l2);
}

}  // namespace
}  // namespace cirque
