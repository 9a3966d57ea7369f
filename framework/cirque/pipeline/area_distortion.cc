#include <cmath>

#include <glog/logging.h>

#include "cirque/energy/angle_constraints.h"
#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/energy/edge_block_assembler.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/linear/registry.h"
#include "cirque/math/circle_angle.h"
#include "cirque/pipeline/cone_stages.h"
#include "cirque/radii/solve_log_radii.h"

namespace cirque {
namespace {

constexpr double kLevel = 1e-9;  ///< added to the dual's Hessian, which can be singular

/// The surface's own angles, where it was solved.
CornerAngles SourceAngles(const FlatSurface& flat) {
  return MeasureCornerAngles(flat.intrinsic.triangulation, flat.intrinsic.lengths);
}

/// Logarithms of face areas from lengths and angles of the same triangles.
Eigen::VectorXd LogAreas(const Triangulation& t, const EdgeLengths& lengths,
                         const CornerAngles& angles) {
  Eigen::VectorXd log_area(t.num_faces());
  for (Index f = 0; f < t.num_faces(); ++f) {
    log_area[f] = std::log(0.5 * lengths.value[t.edge[3 * f]] * lengths.value[t.edge[3 * f + 1]]) +
                  std::log(std::sin(angles.value[3 * f + 2]));
  }
  return log_area;
}

Eigen::VectorXd Shares(const Eigen::VectorXd& log_area) {
  const Eigen::VectorXd area = (log_area.array() - log_area.maxCoeff()).exp();
  return area / area.sum();
}

/// Shares of the areas before and after, and the logarithms of their ratios.
struct AreaRatios {
  AreaRatios(const FlatSurface& flat, const CornerAngles& source_angles) {
    const Triangulation& t = flat.intrinsic.triangulation;
    const Eigen::VectorXd log_source = LogAreas(t, flat.intrinsic.lengths, source_angles);
    const CornerAngles phi = FlatCornerAngles(t, flat.angles, flat.log_radii);
    Eigen::VectorXd log_image = 2 * flat.log_radii.value;
    for (Index h = 0; h < t.num_halfedges(); ++h) {
      log_image[Triangulation::Face(h)] += std::log(std::sin(phi.value[h]));
    }
    source = Shares(log_source);
    image = Shares(log_image);
    log_ratio = log_image - log_source;
    // Normalised as the areas are.
    log_ratio.array() += std::log(image[0] / source[0]) - log_ratio[0];
  }

  double Distortion() const { return 0.5 * source.dot(log_ratio.cwiseAbs2()); }

  /// By the logarithm of each face's flat area.
  Eigen::VectorXd Gradient() const {
    const Eigen::VectorXd weighted = source.cwiseProduct(log_ratio);
    return weighted - weighted.sum() * image;
  }

  /// u about its mean.
  Eigen::VectorXd LogScale() const {
    const Eigen::VectorXd u = 0.5 * log_ratio;
    return u.array() - source.dot(u);
  }

  double Norm(int power) const {
    return source.dot(LogScale().array().abs().pow(power).matrix()) / power;
  }

  /// The norm's, by the logarithm of each face's flat area.
  Eigen::VectorXd NormGradient(int power) const {
    const Eigen::ArrayXd u = LogScale().array();
    const Eigen::VectorXd by_u = (source.array() * u.abs().pow(power - 2) * u).matrix();
    return 0.5 * (by_u - by_u.sum() * source);
  }

  Eigen::VectorXd source, image, log_ratio;
};

/// The two adjoint solves.
class Adjoint {
 public:
  /// `by_area`: of what by the logarithm of each face's flat area.
  Adjoint(const FlatSurface& flat, const ConeTargets& targets, const AngleObjective& objective,
          const Eigen::VectorXd& by_area)
      : flat_(flat),
        t_(flat.intrinsic.triangulation),
        constraints_(t_, targets),
        objective_(objective),
        reference_(SourceAngles(flat)),
        by_phi_(t_.num_halfedges()),
        by_rho_(t_.num_faces()) {
    const CornerAngles phi = FlatCornerAngles(t_, flat.angles, flat.log_radii);
    by_rho_ = 2 * by_area;
    for (Index h = 0; h < t_.num_halfedges(); ++h) {
      by_phi_[h] = by_area[Triangulation::Face(h)] / std::tan(phi.value[h]);
    }
    for (const Index h : t_.edge_halfedge) {
      const Index g = t_.twin[h];
      if (g == kNone) continue;
      const double change =
          -0.5 * HalfAngleWeight(LogRatio(h), Angle(h)) * (by_phi_[h] - by_phi_[g]);
      by_rho_[Triangulation::Face(h)] += change;
      by_rho_[Triangulation::Face(g)] -= change;
    }
  }

  Eigen::VectorXd Run() const {
    const Eigen::VectorXd z = SolveFit(ByAngles(SolveRadii()));
    Eigen::VectorXd by_angle_sum = Eigen::VectorXd::Zero(t_.num_vertices);
    const auto& constrained = constraints_.constrained_vertices();
    for (std::size_t i = 0; i < constrained.size(); ++i) {
      by_angle_sum[constrained[i]] = z[t_.num_faces() + static_cast<int>(i)];
    }
    return by_angle_sum;
  }

 private:
  double LogRatio(Index h) const {
    const Eigen::VectorXd& rho = flat_.log_radii.value;
    return rho[Triangulation::Face(h)] - rho[Triangulation::Face(t_.twin[h])];
  }
  CircleAngle Angle(Index h) const {
    return CircleAngle::FromCorners(flat_.angles.value[h], flat_.angles.value[t_.twin[h]]);
  }

  /// A solution whatever constant the kernel leaves: what is added at `gauge` meets a zero there.
  static Eigen::VectorXd SolveWithGauge(SparseMatrix lower, int gauge,
                                        const Eigen::VectorXd& right) {
    if (gauge >= 0) lower.coeffRef(gauge, gauge) += 1 + lower.coeff(gauge, gauge);
    const auto factor = MakeCholesky();
    CHECK(factor->Factorize(lower)) << "adjoint of a converged solve";
    return factor->Solve(right);
  }

  Eigen::VectorXd SolveRadii() const {
    SparseMatrix lower;
    CirclePatternEnergy(t_, flat_.angles).Hessian(flat_.log_radii.value.data(), &lower);
    return SolveWithGauge(std::move(lower), 0, by_rho_);
  }

  /// q, by the coherent angles.
  Eigen::VectorXd ByAngles(const Eigen::VectorXd& lambda) const {
    Eigen::VectorXd q(t_.num_halfedges());
    for (const Index h : t_.edge_halfedge) {
      const Index g = t_.twin[h];
      const double of_h = by_phi_[h] + 2 * lambda[Triangulation::Face(h)];
      q[h] = of_h;
      if (g == kNone) continue;
      const double of_g = by_phi_[g] + 2 * lambda[Triangulation::Face(g)];
      const double share =
          HalfAngleByThetaStar(LogRatio(h), flat_.angles.value[h] + flat_.angles.value[g]);
      q[h] = q[g] = share * of_h + (1 - share) * of_g;
    }
    return q;
  }

  EdgeConjugate Conjugate(const Eigen::VectorXd& reference, Index h) const {
    const double* y = flat_.multipliers.data();
    const Index g = t_.twin[h];
    const double epsilon = flat_.angles.epsilon, slope = constraints_.Slope(y, h);
    if (g == kNone) return objective_.BoundaryConjugate(reference[h], epsilon, slope);
    return objective_.InteriorConjugate(reference[h], reference[g], epsilon, slope,
                                        constraints_.Slope(y, g));
  }

  Eigen::VectorXd SolveFit(const Eigen::VectorXd& q) const {
    CHECK_EQ(flat_.multipliers.size(), constraints_.num_rows());
    EdgeBlockAssembler matrix(constraints_);
    Eigen::VectorXd moved(t_.num_halfedges());
    for (const Index h : t_.edge_halfedge) {
      const Index g = t_.twin[h];
      const EdgeConjugate c = Conjugate(reference_.value, h);
      matrix.Add(h, h, c.h_ll);
      moved[h] = c.h_ll * q[h];
      if (g == kNone) continue;
      matrix.Add(g, g, c.h_rr);
      matrix.Add(h, g, c.h_lr);
      matrix.Add(g, h, c.h_lr);
      moved[h] += c.h_lr * q[g];
      moved[g] = c.h_lr * q[h] + c.h_rr * q[g];
    }
    for (int row = 0; row < constraints_.num_rows(); ++row) matrix.AddToDiagonal(row, kLevel);
    SparseMatrix lower;
    matrix.Assemble(&lower);
    const int gauge = constraints_.HasGauge() ? constraints_.num_faces() : -1;
    return SolveWithGauge(std::move(lower), gauge, constraints_.Apply(moved));
  }

  const FlatSurface& flat_;
  const Triangulation& t_;
  const AngleConstraints constraints_;
  const AngleObjective& objective_;
  const CornerAngles reference_;
  Eigen::VectorXd by_phi_, by_rho_;
};

}  // namespace

double AreaDistortion(const FlatSurface& flat) {
  return AreaRatios(flat, SourceAngles(flat)).Distortion();
}

Eigen::VectorXd AreaDistortionGradient(const FlatSurface& flat, const ConeTargets& targets,
                                       const AngleObjective& objective) {
  const Eigen::VectorXd by_area = AreaRatios(flat, SourceAngles(flat)).Gradient();
  return Adjoint(flat, targets, objective, by_area).Run();
}

double LogScaleNorm(const FlatSurface& flat, int power) {
  return AreaRatios(flat, SourceAngles(flat)).Norm(power);
}

Eigen::VectorXd LogScaleNormGradient(const FlatSurface& flat, const ConeTargets& targets,
                                     const AngleObjective& objective, int power) {
  const Eigen::VectorXd by_area = AreaRatios(flat, SourceAngles(flat)).NormGradient(power);
  return Adjoint(flat, targets, objective, by_area).Run();
}

Eigen::VectorXd VertexLogScale(const FlatSurface& flat) {
  const AreaRatios ratios(flat, SourceAngles(flat));
  const Eigen::VectorXd u = ratios.LogScale();
  const Triangulation& t = flat.intrinsic.triangulation;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(t.num_vertices), area = sum;
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    const Index f = Triangulation::Face(h);
    sum[t.vertex[h]] += ratios.source[f] * u[f];
    area[t.vertex[h]] += ratios.source[f];
  }
  return sum.cwiseQuotient(area);
}

}  // namespace cirque
