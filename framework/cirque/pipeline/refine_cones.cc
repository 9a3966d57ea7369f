#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "cirque/cones/cone_fit.h"
#include "cirque/intrinsic/intrinsic_delaunay.h"
#include "cirque/pipeline/cone_stages.h"

namespace cirque {
namespace {

constexpr double kArmijo = 1e-4;
constexpr int kMostHalvings = 6;
constexpr double kNothing = 1e-20;   ///< a distortion that is rounding
constexpr double kLeastRoom = 1e-6;  ///< [rad]: an angle nearer to its bound does not approach it
constexpr double kLeastDecrease = 1e-4;  ///< relative, of a step after which another is worthwhile

/// Columns that span the changes of the free ones of n angles: all, or those that sum to 0.
Eigen::MatrixXd ChangesOf(const std::vector<bool>& free, bool sum_fixed) {
  std::vector<int> rows;
  for (std::size_t i = 0; i < free.size(); ++i) {
    if (free[i]) rows.push_back(static_cast<int>(i));
  }
  const auto m = static_cast<int>(rows.size()), n = static_cast<int>(free.size());
  Eigen::MatrixXd of_free = Eigen::MatrixXd::Identity(m, m);
  if (sum_fixed && m > 0) {
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(m);
    const Eigen::MatrixXd q = Eigen::HouseholderQR<Eigen::MatrixXd>(ones).householderQ();
    of_free = q.rightCols(m - 1);
  }
  Eigen::MatrixXd changes = Eigen::MatrixXd::Zero(n, of_free.cols());
  for (int k = 0; k < m; ++k) changes.row(rows[k]) = of_free.row(k);
  return changes;
}

class Refinement {
 public:
  Refinement(const FlattenJob& job, const ConeTargets& targets, const FlatSurface& start,
             const AngleObjective& objective)
      : options_(job.options),
        control_(job.control),
        objective_(objective),
        surface_(MeasureSurface(start.intrinsic.triangulation, start.intrinsic.lengths)),
        problem_(surface_, {&job.surface, {}}),
        targets_(TransferTargets(job.surface, targets, surface_)),
        current_(start) {
    options_.triangulation = SolvedTriangulation::kInput;  // which the intrinsic one is, now
    FindCones(start);
  }

  /// Steps until none is worthwhile; the number of them.
  int Run() {
    if (vertices_.empty()) return 0;
    Eigen::MatrixXd hessian = LinearModelHessian();
    Eigen::VectorXd gradient = Gradient();
    int steps = 0;
    while (steps < options_.refine_cones) {
      const Eigen::VectorXd step = Direction(hessian, gradient);
      const double before = distortion_;
      const double length = Search(step, gradient.dot(step));
      if (length == 0) break;
      ++steps;
      const Eigen::VectorXd next = Gradient();
      UpdateHessian(length * step, next - gradient, &hessian);
      gradient = next;
      if (distortion_ > (1 - kLeastDecrease) * before) break;
    }
    return steps;
  }

  int solves() const { return solves_; }

  /// The cones' angles as targets of any triangulation of these vertices.
  ConeTargets Apply(ConeTargets targets) const {
    for (std::size_t i = 0; i < vertices_.size(); ++i) {
      targets.lower[vertices_[i]] = targets.upper[vertices_[i]] = angles_[i];
    }
    return targets;
  }

 private:
  void FindCones(const FlatSurface& start) {
    const Triangulation& t = problem_.triangulation();
    std::vector<double> sum(t.num_vertices, 0);
    for (Index h = 0; h < t.num_halfedges(); ++h) sum[t.vertex[h]] += start.angles.value[h];
    std::vector<double> angles;
    for (const Index v : problem_.candidates()) {
      if (targets_.IsFixed(v) && targets_.lower[v] == 2 * kPi) continue;
      vertices_.push_back(v);
      angles.push_back(targets_.IsFixed(v) ? targets_.lower[v] : sum[v]);
    }
    angles_ = Eigen::Map<Eigen::VectorXd>(angles.data(), static_cast<int>(angles.size()));
    targets_ = Apply(targets_);
    distortion_ = AreaDistortion(start);
  }

  /// D is about 2 sum a u^2: the area scales with e^2u.
  Eigen::MatrixXd LinearModelHessian() const {
    ConeFit fit(problem_);
    for (const Index v : vertices_) fit.Add(v);
    return 4 * fit.Gram();
  }

  Eigen::VectorXd Gradient() const {
    return AreaDistortionGradient(current_, targets_, objective_)(vertices_);
  }

  /// Newton's step, without the cones that it would push beyond what is admissible at once.
  Eigen::VectorXd Direction(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient) const {
    std::vector<bool> free(vertices_.size(), true);
    while (true) {
      const Eigen::MatrixXd changes = ChangesOf(free, problem_.IsClosed());
      if (changes.cols() == 0) return Eigen::VectorXd::Zero(angles_.size());
      const Eigen::MatrixXd reduced = changes.transpose() * hessian * changes;
      const Eigen::VectorXd step =
          changes * -reduced.ldlt().solve(changes.transpose() * gradient).eval();
      bool blocked = false;
      for (int i = 0; i < step.size(); ++i) {
        if (!free[i] || step[i] * Room(i, step[i]) > kLeastRoom * std::abs(step[i])) continue;
        free[i] = false;
        blocked = true;
      }
      if (!blocked) return step;
    }
  }

  /// From an angle to the end of what is admissible in the direction of the change.
  double Room(int i, double change) const {
    if (change > 0) return 2 * kPi - problem_.LeastCurvature(vertices_[i]) - angles_[i];
    return 2 * kPi - problem_.GreatestCurvature() - angles_[i];
  }

  /// How far along the change all angles stay admissible, at most 1.
  double LongestStep(const Eigen::VectorXd& change) const {
    double length = change.isZero() ? 0 : 1;
    for (int i = 0; i < change.size(); ++i) {
      if (change[i] != 0) length = std::min(length, Room(i, change[i]) / change[i]);
    }
    return length;
  }

  /// Takes the first of 1, 1/2, 1/4, ... of the step that lowers the distortion enough; its length,
  /// 0 when there is none.
  double Search(const Eigen::VectorXd& change, double slope) {
    double length = LongestStep(change);
    const Eigen::VectorXd start = angles_;
    for (int i = 0; i <= kMostHalvings && length > 0; ++i, length /= 2) {
      angles_ = start + length * change;
      FlatSurface trial;
      if (!Solve(&trial)) continue;
      const double distortion = AreaDistortion(trial);
      if (!(distortion <= distortion_ + kArmijo * length * slope)) continue;
      distortion_ = distortion;
      current_ = std::move(trial);
      targets_ = Apply(targets_);
      return length;
    }
    angles_ = start;
    return 0;
  }

  bool Solve(FlatSurface* flat) {
    ++solves_;
    Certificate unused;
    return Flatten({surface_, Apply(targets_), options_, control_}, &unused, flat).ok();
  }

  static void UpdateHessian(const Eigen::VectorXd& step, const Eigen::VectorXd& change,
                            Eigen::MatrixXd* hessian) {
    const double curvature = step.dot(change);
    if (!(curvature > 1e-10 * step.norm() * change.norm())) return;
    const Eigen::VectorXd image = *hessian * step;
    *hessian +=
        change * change.transpose() / curvature - image * image.transpose() / step.dot(image);
  }

  ParameterizeOptions options_;
  const SolveControl& control_;
  const AngleObjective& objective_;
  const IntrinsicSurface surface_;  ///< where the start was solved
  const ConeProblem problem_;
  ConeTargets targets_;  ///< of the problem's triangulation
  FlatSurface current_;
  std::vector<Index> vertices_;
  Eigen::VectorXd angles_;
  double distortion_ = 0;
  int solves_ = 0;
};

}  // namespace

Status RefineCones(const FlattenJob& job, Certificate* certificate, ConeTargets* targets,
                   FlatSurface* flat) {
  const auto objective = AngleObjectiveOf(job.options);
  if (!objective.ok()) return objective.status();
  const double before = AreaDistortion(*flat);
  Refinement refinement(job, *targets, *flat, **objective);
  const int steps = before > kNothing ? refinement.Run() : 0;
  double after = before;
  if (steps > 0) {
    ConeTargets refined = refinement.Apply(*targets);
    Certificate evidence = *certificate;
    FlatSurface solved;
    const FlattenJob again = {job.surface, refined, job.options, job.control};
    const Status status = Flatten(again, &evidence, &solved);
    if (status.code() == StatusCode::kCancelled) return status;
    if (status.ok() && AreaDistortion(solved) < before) {
      after = AreaDistortion(solved);
      *targets = std::move(refined);
      *flat = std::move(solved);
      *certificate = std::move(evidence);
    }
  }
  certificate->cone_refinement = {steps, refinement.solves(), std::sqrt(2 * before),
                                  std::sqrt(2 * after)};
  return Status();
}

}  // namespace cirque
