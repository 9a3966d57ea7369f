#include "cirque/cones/cone_measure.h"

#include <cmath>
#include <complex>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "cirque/cones/cone_heuristic.h"
#include "cirque/pipeline/parameterize.h"

#include "tests/common/surfaces.h"

namespace cirque {
namespace {

using Complex = std::complex<double>;

Complex At(const Surface& surface, Index v) {
  return {surface.position[v].x(), surface.position[v].y()};
}

/// Area-weighted mean of s/t - 1 of the map that is linear on every triangle of a flat surface,
/// from the values of f at the vertices: with A, B the coefficients of z and conj(z).
template <class Function>
double MeanStretch(const Surface& surface, const Function& f) {
  const Triangulation& t = surface.triangulation;
  double sum = 0, total = 0;
  for (Index h = 0; h < t.num_halfedges(); h += 3) {
    const Complex p = At(surface, t.vertex[h]);
    const Complex d1 = At(surface, t.vertex[h + 1]) - p, d2 = At(surface, t.vertex[h + 2]) - p;
    const Complex w1 = f(p + d1) - f(p), w2 = f(p + d2) - f(p);
    const Complex determinant = d1 * std::conj(d2) - d2 * std::conj(d1);
    const double a = std::abs((w1 * std::conj(d2) - w2 * std::conj(d1)) / determinant);
    const double b = std::abs((d1 * w2 - d2 * w1) / determinant);
    const double area = std::abs(determinant);
    sum += area * ((a + b) / (a - b) - 1);
    total += area;
  }
  return sum / total;
}

Eigen::VectorXd LinearField(const Surface& surface, Complex slope) {
  Eigen::VectorXd u(surface.triangulation.num_vertices);
  for (Index v = 0; v < u.size(); ++v) u[v] = (slope * At(surface, v)).real();
  return u;
}

TEST(AngleMeasure, IsTheStretchOfASampledConformalMap) {
  // The derivative of (e^(cz) - 1) / c is e^(cz): its log scale is Re(cz).
  const Surface surface = GeneratedSurface("flat_delaunay_patch", 2000);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  const AngleMeasure measure(problem);
  for (const Complex c : {Complex(0.5, 0), Complex(0, 0.5), Complex(-0.3, 0.4)}) {
    const double real = MeanStretch(surface, [&](Complex z) { return (std::exp(c * z) - 1.) / c; });
    EXPECT_GT(real, 1e-3);
    EXPECT_NEAR(measure.Value(LinearField(surface, c)), real, 0.02 * real);
  }
}

TEST(AngleMeasure, ConstantsDoNotStretchAndItIsHomogeneous) {
  const Surface surface = GeneratedSurface("blob", 600);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  const AngleMeasure measure(problem);
  const Eigen::VectorXd u = problem.LogScaleWithoutCones();
  const Eigen::VectorXd shifted = u.array() + 3;
  EXPECT_GT(measure.Value(u), 1e-3);
  EXPECT_NEAR(measure.Value(shifted), measure.Value(u), 1e-10);
  EXPECT_NEAR(measure.Value(-2 * u), 2 * measure.Value(u), 1e-10);
  EXPECT_NEAR(measure.Apply(u).sum(), 0, 1e-10);
}

TEST(AngleMeasure, TheAdaptedFormMajorisesIt) {
  const Surface surface = GeneratedSurface("blob", 600);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  AngleMeasure measure(problem);
  const Eigen::VectorXd u = problem.LogScaleWithoutCones();
  ASSERT_TRUE(measure.AdaptTo(u));
  const double value = measure.Value(u), form = u.dot(measure.Apply(u));
  EXPECT_LE(form, value);
  EXPECT_GT(form, 0.9 * value);
  // By concavity of the root the measure changes at most by half of the form's change, up to the
  // smoothing of 5 %.
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, 0.05);
  for (int trial = 0; trial < 20; ++trial) {
    Eigen::VectorXd v = u;
    for (double& x : v) x += normal(random);
    EXPECT_LE(measure.Value(v) - value, 0.5 * (v.dot(measure.Apply(v)) - form) + 0.05 * value);
  }
}

/// Any number of columns, on both sides of what is done at once.
TEST(ConeMeasure, AppliesToAllColumnsAsToEach) {
  const Surface surface = GeneratedSurface("blob", 600);
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  for (const ConeMeasureKind kind : {ConeMeasureKind::kArea, ConeMeasureKind::kAngle}) {
    const auto measure = MakeConeMeasure(kind, problem);
    measure->AdaptTo(problem.LogScaleWithoutCones());
    for (const int count : {0, 1, 3, 8, 11}) {
      std::vector<Eigen::VectorXd> fields;
      for (int k = 0; k < count; ++k) fields.push_back(LinearField(surface, 0.1 * (k + 1)));
      ConeMeasure::Columns columns;
      for (const Eigen::VectorXd& field : fields) columns.push_back(&field);
      const Eigen::MatrixXd all = measure->ApplyToAll(columns);
      ASSERT_EQ(all.cols(), count);
      for (int k = 0; k < count; ++k) {
        const Eigen::VectorXd one = measure->Apply(fields[k]);
        EXPECT_GT(one.norm(), 1e-6);
        EXPECT_LT((all.col(k) - one).norm(), 1e-14 * one.norm()) << count << " columns, " << k;
      }
    }
  }
}

TEST(AngleMeasure, SliversStayFinite) {
  Surface surface = FlatStrip(4, 4);
  surface = Moved(std::move(surface), [](Eigen::Vector3d x) {
    if (x.y() == 1) x.y() = 1e-9;
    return x;
  });
  const EdgeLengths lengths = MeasureEdgeLengths(surface);
  const ConeProblem problem(surface.triangulation, lengths);
  const AngleMeasure measure(problem);
  const double value = measure.Value(LinearField(surface, 0.1));
  EXPECT_TRUE(std::isfinite(value));
  EXPECT_GT(value, 0);
  EXPECT_LT(value, 10);
}

TEST(AngleMeasure, FitsLowerItAndItPredictsTheMap) {
  const std::map<std::string, double> most = {{"blob", 1.01}, {"double_torus", 0.995}};
  for (const auto& [name, share] : most) {
    SCOPED_TRACE(name);
    const Surface surface = GeneratedSurface(name, 3000);
    ParameterizeOptions options;
    options.cone_budget = 10;
    const auto realised = [&](const std::string& measure) {
      options.cones = "moving:measure=" + measure;
      Parameterization map;
      EXPECT_TRUE(Parameterize(surface, {options}, {}, &map).ok());
      const EdgeLengths lengths = MeasureEdgeLengths(surface);
      const ConeProblem problem(surface.triangulation, lengths);
      const std::vector<Cone> cones = ConesOf(surface.triangulation, map.targets);
      const double predicted = AngleMeasure(problem).Value(PredictedLogScale(problem, cones));
      const double mean = map.certificate.distortion->quasi_conformal_mean - 1;
      EXPECT_NEAR(predicted, mean, 0.2 * mean);
      return mean;
    };
    const double by_angle = realised("angle");
    EXPECT_GT(by_angle, 1e-3);
    // The blob is round: what lowers the one lowers the other there.
    EXPECT_LT(by_angle, share * realised("area"));
  }
}

}  // namespace
}  // namespace cirque
