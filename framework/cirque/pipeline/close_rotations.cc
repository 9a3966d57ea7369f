#include "cirque/pipeline/close_rotations.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "cirque/angles/fit_with_rows.h"
#include "cirque/radii/rotation_gradient.h"
#include "cirque/radii/solve_log_radii.h"

namespace cirque {
namespace {

constexpr int kMostSteps = 24, kMostHalvings = 3;
constexpr double kNear = 1e-2;          ///< [rad]: misses that the angles nearest to the last close
constexpr double kGoal = 1e-11;         ///< [rad]: rounding allows hardly less
constexpr double kLeastProgress = 0.9;  ///< of a miss, by a step worth taking

/// A pattern on its way to rotations that are multiples.
class Closing {
 public:
  Closing(const FlattenJob& job, const AngleFitProblem& problem, LoopBasis basis,
          const AngleObjective& objective, const FlatSurface& flat)
      : job_(job),
        fit_(problem),
        t_(flat.intrinsic.triangulation),
        basis_(std::move(basis)),
        objective_(std::shared_ptr<void>(), &objective),
        angles_(flat.angles),
        log_radii_(flat.log_radii),
        multipliers_(flat.multipliers),
        start_(flat.angles.value),
        rotations_(Measure(angles_, log_radii_)) {
    fit_.epsilon = flat.angles.epsilon;
    targets_ = rotations_;
  }

  void AimAt(const Eigen::VectorXd& targets) { targets_ = targets; }

  Status Run(const SolverStrategy& strategy) {
    while (steps_ < kMostSteps && Miss() > kGoal) {
      const auto rows = RotationGradients(t_, angles_, log_radii_, basis_.loops);
      if (!rows.ok()) break;
      bool taken = false;
      double share = 1;
      const int most = Miss() > kRotationAccuracy ? kMostHalvings : 0;
      for (int i = 0; i <= most && !taken; ++i, share /= 2) {
        Status status = TryStep(*rows, share, strategy, &taken);
        if (status.code() == StatusCode::kCancelled) return status;
      }
      if (!taken) break;
      ++steps_;
    }
    return Status();
  }

  double Miss() const {
    return basis_.loops.empty() ? 0 : (targets_ - rotations_).lpNorm<Eigen::Infinity>();
  }
  const Eigen::VectorXd& rotations() const { return rotations_; }
  double AngleChange() const { return (angles_.value - start_).lpNorm<Eigen::Infinity>(); }
  int steps() const { return steps_; }

  void WriteTo(Certificate* certificate, FlatSurface* flat) {
    flat->angles = std::move(angles_);
    flat->log_radii = std::move(log_radii_);
    flat->multipliers = std::move(multipliers_);
    if (!certificate->angle_fit) return;
    certificate->angle_fit->smallest_angle = kkt_.smallest_angle;
    certificate->angle_fit->smallest_theta = kkt_.smallest_theta;
    certificate->angle_fit->triangle_sum_residual = kkt_.triangle_sum_residual;
    certificate->angle_fit->vertex_sum_residual = kkt_.vertex_sum_residual;
    if (certificate->radii) certificate->radii->radii_gradient = radii_gradient_;
  }

 private:
  Eigen::VectorXd Measure(const CoherentAngles& angles, const LogRadii& log_radii) const {
    return basis_.Rotations(FlatCornerAngles(t_, angles, log_radii).value);
  }

  /// A share of the way to the targets. `taken`: whether it misses them by less. Angles nearest to
  /// the surface's move along what the rows allow while these turn, and close by a share a step;
  /// once little is missing, those nearest to the last ones close it as Newton's method does.
  Status TryStep(const Eigen::MatrixXd& rows, double share, const SolverStrategy& strategy,
                 bool* taken) {
    const ExtraRows extra = {rows, angles_.value, share * (targets_ - rotations_)};
    const bool near = Miss() < kNear;
    AngleFitProblem problem = {fit_.constraints, near ? angles_.value : fit_.reference,
                               fit_.epsilon};
    problem.start = near ? nullptr : &multipliers_;
    AngleFitResult fit;
    const Eigen::VectorXd z = memory_.z;
    if (near) memory_.z.setZero();
    Status status = FitWithRows(problem, objective_, extra, job_.control, &memory_, &fit);
    if (!status.ok()) return status;
    LogRadiiResult radii;
    status = SolveLogRadii(t_, fit.angles, strategy, job_.control, &radii);
    if (status.ok()) {
      const Eigen::VectorXd rotations = Measure(fit.angles, radii.log_radii);
      const double allowed = 1 - (1 - kLeastProgress) * share;
      *taken = (targets_ - rotations).lpNorm<Eigen::Infinity>() < allowed * Miss();
      if (*taken) Accept(std::move(fit), std::move(radii), rotations);
    }
    if (!*taken) memory_.z = z;
    return status;
  }

  void Accept(AngleFitResult fit, LogRadiiResult radii, const Eigen::VectorXd& rotations) {
    angles_ = std::move(fit.angles);
    if (Miss() >= kNear) multipliers_ = std::move(fit.multipliers);
    kkt_ = fit.kkt;
    log_radii_ = std::move(radii.log_radii);
    radii_gradient_ = radii.gradient_max;
    rotations_ = rotations;
  }

  const FlattenJob& job_;
  AngleFitProblem fit_;
  const Triangulation& t_;
  const LoopBasis basis_;
  const std::shared_ptr<const AngleObjective> objective_;  ///< borrowed
  CoherentAngles angles_;
  LogRadii log_radii_;
  Eigen::VectorXd multipliers_;
  RowFitMemory memory_;
  const Eigen::VectorXd start_;
  Eigen::VectorXd rotations_, targets_;
  KktReport kkt_;
  double radii_gradient_ = 0;
  int steps_ = 0;
};

/// Flat angles of the triangulation that the metric was solved on.
CornerAngles FlatAnglesOf(const FlatSurface& flat) {
  const Triangulation& t = flat.intrinsic.triangulation;
  const bool is_pattern =
      flat.log_radii.value.size() == t.num_faces() && flat.angles.value.size() == t.num_halfedges();
  return is_pattern ? FlatCornerAngles(t, flat.angles, flat.log_radii)
                    : MeasureCornerAngles(t, flat.intrinsic_lengths);
}

/// What is asked for less what there is, modulo 2 pi.
Eigen::VectorXd Missing(const PrescribedRotations& prescribed, const Eigen::VectorXd& rotations) {
  Eigen::VectorXd missing = rotations;
  for (Eigen::Index q = 0; q < missing.size(); ++q) {
    const double asked = prescribed.loops[static_cast<std::size_t>(q)].rotation;
    missing[q] = BeyondMultiple(asked - rotations[q], 2 * kPi);
  }
  return missing;
}

Eigen::VectorXd NearestMultiples(const Eigen::VectorXd& rotations, double unit) {
  return rotations.unaryExpr([&](double x) { return x - BeyondMultiple(x, unit); });
}

}  // namespace

bool MeetsRotations(const FlattenJob& job) {
  return job.rotations && job.rotations->meet && !job.rotations->loops.empty();
}

LoopBasis LoopsOf(const PrescribedRotations& rotations, const Triangulation& input,
                  const FlatSurface& flat) {
  std::vector<DualPath> paths;
  for (const LoopRotation& loop : rotations.loops) paths.push_back(loop.path);
  LoopBasis basis;
  for (const DualPath& path : PathsAfterFlips(input, flat.intrinsic.flips, std::move(paths))) {
    basis.loops.push_back(CornersAlong(flat.intrinsic.triangulation, path));
  }
  basis.offset.assign(basis.loops.size(), 0);
  return basis;
}

namespace {

/// By the metric's own triangulation or, where flips were Ptolemy's, by the input's.
Eigen::VectorXd RotationsOf(const PrescribedRotations& rotations, const Triangulation& input,
                            const FlatSurface& flat) {
  if (flat.log_scale.size() == 0) {
    return LoopsOf(rotations, input, flat).Rotations(FlatAnglesOf(flat).value);
  }
  LoopBasis basis;
  for (const LoopRotation& loop : rotations.loops) {
    basis.loops.push_back(CornersAlong(input, loop.path));
  }
  basis.offset.assign(basis.loops.size(), 0);
  return basis.Rotations(flat.on_input.angles.value);
}

}  // namespace

std::optional<double> RotationUnit(HolonomyRule holonomy) {
  if (holonomy == HolonomyRule::kFree) return std::nullopt;
  return kPi / (holonomy == HolonomyRule::kHalves ? 2 : 3);
}

LoopBasis::LoopBasis(const Triangulation& t) {
  for (const DualPath& path : HandleLoops(t)) loops.push_back(CornersAlong(t, path));
  handle_loops = static_cast<int>(loops.size());
  offset.assign(loops.size(), 0);
  std::vector<int> loop_of(t.num_vertices, -1);
  const std::vector<std::vector<Index>> boundary = BoundaryLoops(t);
  for (std::size_t k = 1; k < boundary.size(); ++k) {
    for (const Index h : boundary[k]) loop_of[t.Tip(h)] = static_cast<int>(loops.size());
    offset.push_back(kPi * static_cast<double>(boundary[k].size()));
    loops.emplace_back();
  }
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    if (loop_of[t.vertex[h]] >= 0) loops[loop_of[t.vertex[h]]].emplace_back(h, -1);
  }
}

Eigen::VectorXd LoopBasis::Rotations(const Eigen::VectorXd& angles) const {
  Eigen::VectorXd rotations(static_cast<int>(loops.size()));
  for (std::size_t q = 0; q < loops.size(); ++q) {
    rotations[static_cast<int>(q)] = offset[q] + RotationAlong(loops[q], angles);
  }
  return rotations;
}

std::optional<RotationSummary> MeasureRotations(const FlatSurface& flat) {
  const Triangulation& t = flat.intrinsic.triangulation;
  const auto boundary = static_cast<Index>(BoundaryLoops(t).size());
  if (boundary < 2 && EulerCharacteristic(t) + boundary == 2) return std::nullopt;
  const Eigen::VectorXd angles = FlatAnglesOf(flat).value;
  const LoopBasis basis(t);
  const Eigen::VectorXd rotations = basis.Rotations(angles);
  RotationSummary summary;
  summary.rotations.assign(rotations.begin(), rotations.end());
  summary.rotation_miss_halves = MissOf(rotations, kPi / 2).largest;
  summary.rotation_miss_thirds = MissOf(rotations, kPi / 3).largest;
  summary.handle_rotations = basis.handle_loops;
  summary.boundary_rotations = static_cast<int>(basis.loops.size()) - basis.handle_loops;
  for (const DualPath& path : BoundaryPaths(t)) {
    summary.boundary_turns.push_back(RotationAlong(CornersAlong(t, path), angles));
  }
  return summary;
}

RotationMiss MissOf(const Eigen::VectorXd& rotations, double unit) {
  RotationMiss miss;
  for (int q = 0; q < rotations.size(); ++q) {
    const double beyond = std::abs(BeyondMultiple(rotations[q], unit));
    if (miss.loop < 0 || beyond > miss.largest) miss = {beyond, q};
  }
  return miss;
}

void NoteMiss(const ParameterizeOptions& options, const FlatSurface& flat,
              Certificate* certificate) {
  const std::optional<double> unit = RotationUnit(options.holonomy);
  if (!unit) return;
  const LoopBasis basis(flat.intrinsic.triangulation);
  const RotationMiss miss = MissOf(basis.Rotations(FlatAnglesOf(flat).value), *unit);
  HolonomySummary& summary = Fill(&certificate->holonomy);
  summary.holonomy_miss = miss.largest;
  summary.holonomy_loop = miss.loop;
}

void NoteLoops(const Triangulation& input, const PrescribedRotations& rotations,
               Parameterization* result) {
  const Eigen::VectorXd found = RotationsOf(rotations, input, result->flat);
  const Eigen::VectorXd missing = Missing(rotations, found);
  LoopsSummary& summary = Fill(&result->certificate.loops);
  summary.rotations.assign(found.begin(), found.end());
  summary.misses.assign(missing.begin(), missing.end());
  summary.loops_to_meet = rotations.meet ? 1 : 0;
  for (std::size_t q = 0; q < summary.misses.size(); ++q) {
    const double miss = std::abs(summary.misses[q]);
    if (summary.loop_that_misses >= 0 && miss <= summary.loop_miss) continue;
    summary.loop_miss = miss;
    summary.loop_that_misses = static_cast<int>(q);
  }
}

namespace {

/// The job's prescribed rotations, at whatever change of angles.
Status MeetLoops(const FlattenJob& job, const SolverStrategy& strategy, Closing* closing,
                 Certificate* certificate, FlatSurface* flat) {
  closing->AimAt(closing->rotations() + Missing(*job.rotations, closing->rotations()));
  LoopsSummary& summary = Fill(&certificate->loops);
  summary.loop_miss_before = closing->Miss();
  if (Status s = closing->Run(strategy); !s.ok()) return s;
  summary.loop_steps = closing->steps();
  summary.loop_angle_change = closing->AngleChange();
  if (closing->Miss() <= kRotationAccuracy) closing->WriteTo(certificate, flat);
  return Status();
}

}  // namespace

Status CloseRotations(const FlattenJob& job, const AngleFitProblem& problem,
                      Certificate* certificate, FlatSurface* flat) {
  const std::optional<double> unit = RotationUnit(job.options.holonomy);
  if (!unit && !MeetsRotations(job)) return Status();
  job.control.BeginStage("rotations");
  const auto objective = AngleObjectiveOf(job.options);
  if (!objective.ok()) return objective.status();
  const auto strategy = MakeSolverStrategy(
      job.options.radii_solver, {{"max_iterations", std::to_string(job.options.max_iterations)}});
  if (!strategy.ok()) return strategy.status();
  const Triangulation& solved = flat->intrinsic.triangulation;
  Closing closing(
      job, problem,
      unit ? LoopBasis(solved) : LoopsOf(*job.rotations, job.surface.triangulation, *flat),
      **objective, *flat);
  if (!unit) return MeetLoops(job, **strategy, &closing, certificate, flat);
  closing.AimAt(NearestMultiples(closing.rotations(), *unit));
  HolonomySummary& summary = Fill(&certificate->holonomy);
  summary.holonomy_miss_before = closing.Miss();
  if (Status s = closing.Run(**strategy); !s.ok()) return s;
  summary.holonomy_steps = closing.steps();
  summary.holonomy_angle_change = closing.AngleChange();
  const bool met = closing.Miss() <= kRotationAccuracy;
  if (met && closing.AngleChange() <= kMostAngleChange) closing.WriteTo(certificate, flat);
  NoteMiss(job.options, *flat, certificate);
  return Status();
}

}  // namespace cirque
