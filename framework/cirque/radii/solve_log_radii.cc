#include "cirque/radii/solve_log_radii.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/energy/circle_pattern_source.h"
#include "cirque/energy/dual_laplacian.h"
#include "cirque/math/circle_angle.h"
#include "cirque/math/clausen.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/math/elementary_arrays.h"
#include "cirque/math/half_angles.h"
#include "cirque/math/parallel_chunks.h"
#include "cirque/radii/pattern_part.h"
#include "cirque/radii/pattern_volume.h"
#include "cirque/solver/energy_on_ranks.h"

namespace cirque {
namespace {

constexpr double kAcceptedGradient = 1e-9;
constexpr double kOneCircle = 1e-9;      ///< [rad]: two circles that are one to rounding
constexpr double kStartGradient = 1e-2;  ///< whence Newton on the radii needs a few full steps

/// max over coherent alpha with these theta of
///   2 sum L(alpha) - 2 sum L(theta*),
/// the first sum over the corners opposite inner edges: the flat angles attain it.
double DualEnergy(const Triangulation& t, const CoherentAngles& angles, const CornerAngles& flat) {
  return ParallelSum(t.num_edges(), [&](Index e) {
    const Index h = t.edge_halfedge[e], g = t.twin[h];
    CompensatedSum sum;
    if (g == kNone) return sum;
    sum += 2 * Lobachevsky(flat.value[h]);
    sum += 2 * Lobachevsky(flat.value[g]);
    sum -= 2 * Lobachevsky(angles.value[h] + angles.value[g]);
    return sum;
  });
}

/// Margins can shrink so far that angles coherent up to rounding are none: a corner of 0, or two
/// circles that touch.
Status CheckStrictlyCoherent(const Triangulation& t, const CoherentAngles& angles) {
  for (const Index h : t.edge_halfedge) {
    const Index g = t.twin[h];
    const double alpha = angles.value[h], beta = g == kNone ? 0 : angles.value[g];
    const bool inside = alpha > 0 && (g == kNone || beta > 0) && alpha + beta < kPi;
    if (inside) continue;
    const Index face = Triangulation::Face(h);
    return {StatusCode::kNotConverged,
            fmt::format("log radii: at {} the coherent angles {} and {} rad are none to rounding; "
                        "raise epsilon",
                        g == kNone ? fmt::format("face {}", face)
                                   : fmt::format("faces {} and {}", face, Triangulation::Face(g)),
                        alpha, beta)};
  }
  return Status();
}

}  // namespace

RadiiSystem::RadiiSystem(const Triangulation& t, const SolverStrategy& strategy)
    : solver_(strategy.MakeSystemSolver(t.num_faces())),
      analysis_(solver_->WantsPattern() ? t.num_faces() : 0, [this, &t] {
        if (solver_->WantsPattern()) solver_->Prepare(DualLaplacian(t).pattern());
      }) {}

SystemSolver* RadiiSystem::Get() {
  analysis_.Wait();
  return solver_.get();
}

double LogRadiiResult::RelativeGap() const {
  return std::abs(energy - dual_energy) / (1 + std::abs(energy));
}

Status SolveLogRadii(const Triangulation& t, const CoherentAngles& angles,
                     const SolverStrategy& strategy, const SolveControl& control,
                     LogRadiiResult* result) {
  RadiiSystem system(t, strategy);
  return SolveLogRadii(t, angles, strategy, control, &system, result);
}

namespace {

/// What both ways end with.
void Conclude(const Energy& energy, Eigen::VectorXd rho, LogRadiiResult* result) {
  rho.array() -= rho.mean();
  Eigen::VectorXd gradient(rho.size());
  energy.Gradient(rho.data(), gradient.data());
  result->gradient_max = gradient.lpNorm<Eigen::Infinity>();
  result->log_radii.value = std::move(rho);
}

void SolveWhole(const Triangulation& t, const CoherentAngles& angles,
                const SolverStrategy& strategy, const SolveControl& control, RadiiSystem* system,
                LogRadiiResult* result) {
  const CirclePatternEnergy energy(t, angles);
  Eigen::VectorXd rho;
  SolveControl with_solver = control;
  with_solver.system_solver = system->Get();
  result->start =
      MaximizePatternVolume(t, angles, energy, kStartGradient, with_solver.system_solver, &rho);
  result->solve = strategy.Minimize(energy, with_solver, &rho);
  Conclude(energy, std::move(rho), result);
}

/// False where there are no ranks, or multigrid does not converge on them.
bool SolveOnRanks(const Triangulation& t, const CoherentAngles& angles,
                  const SolverStrategy& strategy, const SolveControl& control,
                  LogRadiiResult* result) {
  const CirclePatternSource source(t, angles);
  const auto energy = strategy.TakeToRanks(source);
  if (!energy) return false;
  Eigen::VectorXd rho(t.num_faces());
  EnergyCall& call = energy->work().part().call;
  call.result = rho.data();
  call.tolerance = kStartGradient;
  call.summary = &result->start;
  energy->work().Do(PatternPart::kMaximizeVolume);
  call.summary = nullptr;
  result->solve = strategy.Minimize(*energy, control, &rho);
  if (energy->failed()) return false;
  Conclude(*energy, std::move(rho), result);
  return true;
}

}  // namespace

Status SolveLogRadii(const Triangulation& t, const CoherentAngles& angles,
                     const SolverStrategy& strategy, const SolveControl& control,
                     RadiiSystem* system, LogRadiiResult* result) {
  result->log_radii.value = Eigen::VectorXd::Zero(t.num_faces());
  if (Status s = CheckStrictlyCoherent(t, angles); !s.ok()) return s;
  if (!SolveOnRanks(t, angles, strategy, control, result)) {
    SolveWhole(t, angles, strategy, control, system, result);
  }
  result->energy = result->solve.final_value;
  result->dual_energy = DualEnergy(t, angles, FlatCornerAngles(t, angles, result->log_radii));
  if (result->solve.termination == Termination::kCancelled) {
    return Status(StatusCode::kCancelled, "log radii: cancelled");
  }
  if (!(result->gradient_max <= kAcceptedGradient)) {
    return Status(StatusCode::kNotConverged,
                  fmt::format("log radii: gradient {:.2e} rad > {:.0e}: {}", result->gradient_max,
                              kAcceptedGradient, result->solve.BriefReport()));
  }
  return Status();
}

CornerAngles FlatCornerAngles(const Triangulation& t, const CoherentAngles& angles,
                              const LogRadii& log_radii) {
  CornerAngles flat{angles.value};  // on the boundary they stay
  const auto difference = [&](Index h) {
    return log_radii.value[Triangulation::Face(h)] -
           log_radii.value[Triangulation::Face(t.twin[h])];
  };
  ParallelChunks(t.num_halfedges(), [&](Index first, Index end) {
    std::array<Index, kChunk> corner;
    int size = 0;
    for (Index h = first; h < end; ++h) {
      if (t.twin[h] != kNone) corner[size++] = h;
    }
    ChunkOf<> alpha(size), across(size), d(size), sine(size), one_minus_cosine(size), phi(size);
    for (int k = 0; k < size; ++k) {
      alpha[k] = angles.value[corner[k]];
      across[k] = angles.value[t.twin[corner[k]]];
      d[k] = difference(corner[k]);
    }
    ChunkOf<CircleAngle> angle(size);
    CircleAngles(alpha, across, angle);
    for (int k = 0; k < size; ++k) {
      sine[k] = angle[k].sine;
      one_minus_cosine[k] = angle[k].one_minus_cosine;
    }
    HalfAngles(d, sine, one_minus_cosine, phi);
    for (int k = 0; k < size; ++k) {
      if (angle[k].theta >= kOneCircle) flat.value[corner[k]] = phi[k];
    }
  });
  return flat;
}

EdgeLengths FlatEdgeLengths(const Triangulation& t, const CornerAngles& flat,
                            const LogRadii& log_radii) {
  EdgeLengths lengths;
  lengths.value.resize(t.num_edges());
  ParallelChunks(t.num_edges(), [&](Index first, Index end) {
    ChunkOf<> log_radius(end - first), angle(end - first);
    for (Index e = first; e < end; ++e) {
      const Index h = t.edge_halfedge[e];
      log_radius[e - first] = log_radii.value[Triangulation::Face(h)];
      angle[e - first] = flat.value[h];
    }
    Exponentials(log_radius, log_radius);
    Sines(angle, angle);
    for (Index e = first; e < end; ++e) {
      lengths.value[e] = 2 * log_radius[e - first] * angle[e - first];
    }
  });
  return lengths;
}

}  // namespace cirque
