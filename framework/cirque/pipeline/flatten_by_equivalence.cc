#include "cirque/pipeline/flatten_by_equivalence.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "cirque/angles/infeasibility.h"
#include "cirque/core/count.h"
#include "cirque/core/text.h"
#include "cirque/equivalence/double_surface.h"
#include "cirque/equivalence/half_of_double.h"
#include "cirque/equivalence/solve_log_scales.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/pipeline/untangle_chart.h"

namespace cirque {
namespace {

/// max |gradient| at the start and after every iteration.
std::vector<double> GradientsOf(const SolveSummary& solve) {
  std::vector<double> gradients = {solve.initial_gradient_max};
  for (const IterationRecord& step : solve.iterations) gradients.push_back(step.gradient_max);
  return gradients;
}

double LogAreaTwice(const Triangulation& t, const LogScalesResult& scales, Index f) {
  return scales.log_lengths[t.edge[3 * f]] + scales.log_lengths[t.edge[3 * f + 1]] +
         std::log(std::sin(scales.angles.value[3 * f + 2]));
}

/// The logarithm of the area of the flat faces that are the surface's or, of a double, either half's.
double LogFlatArea(const LogScalesResult& scales) {
  const Triangulation& t = scales.intrinsic.triangulation;
  double largest = -std::numeric_limits<double>::infinity();
  for (Index f = 0; f < t.num_faces(); ++f) {
    largest = std::max(largest, LogAreaTwice(t, scales, f));
  }
  const double sum = ParallelSum(
      t.num_faces(), [&](Index f) { return std::exp(LogAreaTwice(t, scales, f) - largest); });
  return largest + std::log(0.5 * sum / (scales.doubled ? 2 : 1));
}

/// log(l / (2 sin alpha)) at the corner whose sine is the largest.
double LogCircumradius(const LogScalesResult& scales, Index f) {
  const double* angle = &scales.angles.value[3 * f];
  int widest = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::sin(angle[k]) > std::sin(angle[widest])) widest = k;
  }
  const Index edge = scales.intrinsic.triangulation.edge[3 * f + widest];
  return scales.log_lengths[edge] - std::log(2 * std::sin(angle[widest]));
}

class EquivalenceFlattening {
 public:
  EquivalenceFlattening(const FlattenJob& job, Certificate* certificate, FlatSurface* result)
      : job_(job), certificate_(*certificate), result_(*result) {}

  Status Run() {
    const Status fit = CheckAngleSums(job_.surface, job_.targets, &result_.infeasibility);
    if (!fit.ok()) return fit;
    const auto strategy =
        MakeSolverStrategy(job_.options.radii_solver,
                           {{"max_iterations", std::to_string(job_.options.max_iterations)}});
    if (!strategy.ok()) return strategy.status();
    if (Status s = Solve(**strategy); !s.ok()) return s;
    if (Status s = TakeMetric(); !s.ok()) return s;
    ReadChart();
    if (result_.on_input.flipped.empty() || result_.exact || SolveOnInput(**strategy)) {
      return Status();
    }
    const std::vector<Index>& flipped = result_.on_input.flipped;
    return Status(StatusCode::kNotConverged,
                  fmt::format("the conformally equivalent flat metric exists, but of the "
                              "input {} would be flipped in it, faces {} (0-based) among them",
                              Count(flipped.size(), "triangle"), IdList(flipped, 5)));
  }

 private:
  const Triangulation& input() const { return job_.surface.triangulation; }

  Status Solve(const SolverStrategy& strategy) {
    Status status = SolveKeeping(KeptEdges::kBoundary, strategy);
    const auto& on_boundary = job_.surface.boundary;
    const bool has_boundary =
        std::find(on_boundary.begin(), on_boundary.end(), true) != on_boundary.end();
    if (has_boundary && status.code() == StatusCode::kNotConverged) {
      status = SolveKeeping(KeptEdges::kNoEdge, strategy);
    }
    return status;
  }

  Status SolveKeeping(KeptEdges kept, const SolverStrategy& strategy) {
    const Timer timer;
    job_.control.BeginStage("scales");
    Status status = SolveLogScales(input(), job_.surface.lengths, job_.targets, kept, strategy,
                                   job_.control, &scales_);
    Record();
    AddSeconds(timer, &certificate_.seconds.scales);
    return status;
  }

  /// The metric equivalent on the input's own triangulation, if there is one: no triangle of it can
  /// be flipped. False, and everything as it was, otherwise.
  bool SolveOnInput(const SolverStrategy& strategy) {
    const LogScalesResult flipped = scales_;
    const EquivalenceSummary summary = *certificate_.equivalence;
    const TriangulationSummary flips = *certificate_.triangulation;
    if (SolveKeeping(KeptEdges::kAll, strategy).ok() && TakeMetric().ok()) {
      ReadChart();
      if (result_.on_input.flipped.empty()) return true;
    }
    scales_ = flipped;
    certificate_.equivalence = summary;
    certificate_.triangulation = flips;
    if (TakeMetric().ok()) ReadChart();
    return false;
  }

  void Record() {
    EquivalenceSummary& summary = Fill(&certificate_.equivalence);
    const SolveSummary& solve = scales_.solve;
    const Eigen::VectorXd& u = scales_.log_scale;
    summary.scales_residual = scales_.residual;
    summary.scales_iterations = solve.num_iterations();
    summary.scales_factorizations = solve.factorizations;
    summary.scales_cg_iterations = solve.cg_iterations;
    summary.ptolemy_flips =
        static_cast<int>(scales_.intrinsic.flips.size()) - scales_.euclidean_flips;
    summary.doubled = scales_.doubled ? 1 : 0;
    if (u.size() > 0) summary.log_scale_range = u.maxCoeff() - u.minCoeff();
    summary.solver = solve.strategy;
    summary.gradients = GradientsOf(solve);
    Fill(&certificate_.triangulation).flips = static_cast<int>(scales_.intrinsic.flips.size());
  }

  /// Scales it so that the image has the surface's area.
  Status TakeMetric() {
    const double source_area = SurfaceArea(job_.surface);
    if (source_area > 0) {
      const double larger = 0.5 * (std::log(source_area) - LogFlatArea(scales_));
      scales_.log_lengths.array() += larger;
      scales_.log_scale.array() += larger;
    }
    flat_lengths_.value = scales_.log_lengths.array().exp();
    const auto normal = [](double length) { return std::isnormal(length); };
    if (std::all_of(flat_lengths_.value.begin(), flat_lengths_.value.end(), normal)) {
      return Status();
    }
    return Status(
        StatusCode::kUnrepresentable,
        fmt::format("the flat metric exists but doubles cannot hold it: the logarithms of "
                    "its lengths range over {:.1f}; add cones",
                    scales_.log_lengths.maxCoeff() - scales_.log_lengths.minCoeff()));
  }

  void ReadChart() {
    const Timer timer;
    std::vector<double> sums;
    TakeExact();
    if (scales_.doubled) {
      sums = ReadHalf();
    } else {
      result_.on_input = ReadOnInput(input(), scales_.intrinsic, scales_.angles, flat_lengths_);
      sums = VertexAngleSums(scales_.intrinsic.triangulation, scales_.angles);
      TakePattern();
    }
    UntangleChart(job_, sums, &*certificate_.triangulation, &result_.on_input);
    AddSeconds(timer, &certificate_.seconds.layout);
  }

  /// What an exact map is made of.
  void TakeExact() {
    if (!job_.options.exact || result_.exact) return;
    auto equivalent = std::make_shared<EquivalentTriangulation>();
    if (scales_.doubled) {
      const auto half = TakeHalf(input(), scales_, flat_lengths_, equivalent.get());
      if (half) result_.exact = {half->half, half->angles, half->half.lengths};
    } else {
      *equivalent = TakeWhole(input(), scales_, flat_lengths_);
      result_.exact = {equivalent->whole.scaled, scales_.angles, flat_lengths_};
    }
    if (result_.exact) result_.exact->equivalent = std::move(equivalent);
  }

  /// The surface's half of its double. Its boundary is what the mirror image leaves in place: edges
  /// that are straight whether or not they are edges of the triangulation.
  std::vector<double> ReadHalf() {
    const DoubledSurface doubled = DoubleSurface(input(), job_.surface.lengths);
    InputChart whole =
        ReadOnInput(doubled.triangulation, scales_.intrinsic, scales_.angles, flat_lengths_);
    InputChart& half = result_.on_input;
    half.angles.value = whole.angles.value.head(input().num_halfedges());
    half.lengths.value = whole.lengths.value.head(input().num_edges());
    half.flipped.clear();
    for (const Index f : whole.flipped) {
      if (f < input().num_faces()) half.flipped.push_back(f);
    }
    result_.intrinsic = {input(), job_.surface.lengths, {}, {}};
    result_.intrinsic_lengths = half.lengths;
    std::vector<double> sums = VertexAngleSums(scales_.intrinsic.triangulation, scales_.angles);
    sums.resize(input().num_vertices);
    for (Index v = 0; v < input().num_vertices; ++v) {
      if (job_.surface.boundary[v]) sums[v] *= 0.5;
    }
    return sums;
  }

  /// The circle pattern that the flat Delaunay triangulation is.
  void TakePattern() {
    const Triangulation& t = scales_.intrinsic.triangulation;
    result_.angles = {scales_.angles.value, 0};
    result_.log_radii.value.resize(t.num_faces());
    for (Index f = 0; f < t.num_faces(); ++f) {
      result_.log_radii.value[f] = LogCircumradius(scales_, f);
    }
    result_.log_scale = scales_.log_scale;
    result_.intrinsic = scales_.intrinsic;
    result_.intrinsic_lengths = flat_lengths_;
  }

  const FlattenJob& job_;
  Certificate& certificate_;
  FlatSurface& result_;
  LogScalesResult scales_;
  EdgeLengths flat_lengths_;  ///< of scales_.intrinsic
};

}  // namespace

Status FlattenByEquivalence(const FlattenJob& job, Certificate* certificate, FlatSurface* result) {
  *result = FlatSurface();
  return EquivalenceFlattening(job, certificate, result).Run();
}

bool HasEquivalentMetric(const IntrinsicSurface& surface, const ConeTargets& targets) {
  return targets.lower.size() == surface.corners.size() && CheckAngleSums(surface, targets).ok();
}

}  // namespace cirque
