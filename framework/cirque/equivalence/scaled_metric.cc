#include "cirque/equivalence/scaled_metric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "cirque/core/parallel.h"
#include "cirque/intrinsic/metric_delaunay.h"
#include "cirque/intrinsic/ptolemy_complex.h"

namespace cirque {
namespace {

constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
/// Of the logarithms of lengths, relatively: a few units of three doubles, after hundreds of flips.
constexpr double kExtendedRounding = 0x1p-150;

IntrinsicTriangulation AsItIs(const Triangulation& t, const EdgeLengths& lengths) {
  IntrinsicTriangulation same{t, lengths, {}, std::vector<Index>(t.num_edges())};
  std::iota(same.edge_of_input.begin(), same.edge_of_input.end(), 0);
  return same;
}

/// MeasureScaledMetric.
class MetricMeasure {
 public:
  MetricMeasure(const ScaleProblem& problem, const VertexScales& scales, ScaledMetric* result,
                ScaleRounding* rounding)
      : problem_(problem),
        t_(problem.start.triangulation),
        scales_(scales),
        result_(*result),
        rounding_(*rounding) {}

  bool Measure() {
    PtolemyComplex complex(problem_.start.triangulation, problem_.log_lengths, scales_);
    Eigen::VectorXd& scale = result_.log_scale;
    scale.resize(t_.num_vertices);
    for (Index v = 0; v < t_.num_vertices; ++v) scale[v] = scales_[v].Value();
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(t_.num_vertices);
    if (problem_.flips == ScaleProblem::Flips::kPtolemy && !complex.MakeDelaunay(none))
      return false;
    result_.angles.value.resize(t_.num_halfedges());
    std::vector<double> rounding(t_.num_halfedges()), beyond(t_.num_halfedges());
    Eigen::VectorXd range(complex.num_faces());
    const double size =
        1 + problem_.log_lengths.lpNorm<Eigen::Infinity>() + scale.lpNorm<Eigen::Infinity>();
    ParallelFor(complex.num_faces(), [&](Index f) {
      const LogTriangle triangle = complex.ScaledTriangle(f, none);
      range[f] = RangeOfSides(complex, f, none);
      double cotangents = 0;
      for (int k = 0; k < 3; ++k) cotangents += std::abs(triangle.Cotangent(k));
      for (Index h = 3 * f; h < 3 * f + 3; ++h) {
        result_.angles.value[h] = triangle.angle[h - 3 * f];
        rounding[h] = cotangents * kRounding * size;
        beyond[h] = std::min(kPi, std::exp(range[f]) * kExtendedRounding * size);
      }
    });
    MeasureResidual(complex, rounding);
    rounding_.beyond_digits = LargestSum(complex, beyond);
    rounding_.longest_needle = range.maxCoeff();
    TakeTriangulation(complex);
    return true;
  }

 private:
  /// Of the logarithms of a face's sides, scaled by u.
  static double RangeOfSides(const PtolemyComplex& complex, Index f, const Eigen::VectorXd& u) {
    Eigen::Array3d x;
    for (int k = 0; k < 3; ++k) x[k] = complex.ScaledLogLength(3 * f + k, u);
    return x.maxCoeff() - x.minCoeff();
  }

  /// Of values at corners, over the vertices whose angle sums are prescribed.
  double LargestSum(const PtolemyComplex& complex, const std::vector<double>& at_corner) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(problem_.targets.angle_sum.size());
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      const int p = problem_.targets.parameter[complex.vertex(h)];
      if (p != kNone) sum[p] += at_corner[h];
    }
    return sum.size() > 0 ? sum.lpNorm<Eigen::Infinity>() : 0;
  }

  /// And what rounding of the lengths' logarithms may do to it: d alpha_i = sum of cotangents times
  /// changes of these.
  void MeasureResidual(const PtolemyComplex& complex, const std::vector<double>& rounding) {
    Eigen::VectorXd missed = problem_.targets.angle_sum;
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      const int p = problem_.targets.parameter[complex.vertex(h)];
      if (p != kNone) missed[p] -= result_.angles.value[h];
    }
    result_.residual = missed.size() > 0 ? missed.lpNorm<Eigen::Infinity>() : 0;
    rounding_.by_doubles = LargestSum(complex, rounding);
  }

  void TakeTriangulation(const PtolemyComplex& complex) {
    IntrinsicTriangulation& intrinsic = result_.intrinsic;
    intrinsic.triangulation = complex.MakeTriangulation(t_.num_vertices);
    const Triangulation& flipped = intrinsic.triangulation;
    result_.log_lengths = complex.MakeLogLengths(flipped);
    result_.extended_log_lengths = complex.MakeExtendedLogLengths(flipped);
    intrinsic.lengths.value.resize(flipped.num_edges());
    for (Index e = 0; e < flipped.num_edges(); ++e) {
      const Index h = flipped.edge_halfedge[e];
      const double scale = result_.log_scale[flipped.Tail(h)] + result_.log_scale[flipped.Tip(h)];
      intrinsic.lengths.value[e] = std::exp(result_.log_lengths[e] - 0.5 * scale);
    }
    intrinsic.flips = problem_.start.flips;
    result_.euclidean_flips = static_cast<int>(problem_.start.flips.size());
    intrinsic.flips.insert(intrinsic.flips.end(), complex.flips().begin(), complex.flips().end());
    std::vector<Index> still(problem_.start.triangulation.num_edges(), kNone);
    for (Index h = 0; h < complex.num_halfedges(); ++h) {
      if (complex.label(h) != kNone) still[complex.label(h)] = intrinsic.triangulation.edge[h];
    }
    intrinsic.edge_of_input = problem_.start.edge_of_input;
    for (Index& e : intrinsic.edge_of_input) e = e == kNone ? kNone : still[e];
  }

  const ScaleProblem& problem_;
  const Triangulation& t_;
  const VertexScales& scales_;
  ScaledMetric& result_;
  ScaleRounding& rounding_;
};

}  // namespace

ScaleProblem::ScaleProblem(const Triangulation& t, const EdgeLengths& lengths,
                           ScaleTargets angle_sums, Flips which)
    : flips(which),
      start(flips == Flips::kNever ? AsItIs(t, lengths) : MakeDelaunayOfMetric(t, lengths)),
      targets(std::move(angle_sums)),
      log_lengths(start.lengths.value.array().log()) {}

bool ScaleProblem::IsClosed() const {
  const std::vector<Index>& twin = start.triangulation.twin;
  return std::find(twin.begin(), twin.end(), kNone) == twin.end();
}

ConformalEquivalenceEnergy ScaleProblem::EnergyFrom(const VertexScales& scales) const {
  return {start.triangulation, log_lengths, targets, flips, scales};
}

bool MeasureScaledMetric(const ScaleProblem& problem, const VertexScales& scales,
                         ScaledMetric* result, ScaleRounding* rounding) {
  return MetricMeasure(problem, scales, result, rounding).Measure();
}

}  // namespace cirque
