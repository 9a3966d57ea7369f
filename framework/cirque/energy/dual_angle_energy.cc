#include "cirque/energy/dual_angle_energy.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cirque/core/parallel.h"
#include "cirque/energy/edge_block_assembler.h"
#include "cirque/math/compensated_sum.h"
#include "cirque/math/parallel_chunks.h"

namespace cirque {
namespace {

/// That of the table; empty: it is not there.
std::string NameOf(const AngleObjective* objective) {
  for (const std::string& name : AngleObjectives().Names()) {
    if (AngleObjectives().Find(name)->get() == objective) return name;
  }
  return "";
}

}  // namespace

DualAngleEnergy::DualAngleEnergy(AngleConstraints constraints, const Eigen::VectorXd& reference,
                                 double epsilon, std::shared_ptr<const AngleObjective> objective)
    : constraints_(std::move(constraints)),
      reference_(reference),
      epsilon_(epsilon),
      objective_(std::move(objective)),
      corner_of_row_(constraints_.num_rows() - constraints_.num_faces()) {
  for (Index h = 0; h < constraints_.triangulation().num_halfedges(); ++h) {
    const int row = constraints_.VertexRow(h);
    if (row != kNone) corner_of_row_[row - constraints_.num_faces()] = h;
  }
}

EdgeSlopes DualAngleEnergy::SlopesAt(Index e, const double* y) const {
  const Triangulation& t = constraints_.triangulation();
  const Index l = t.edge_halfedge[e], r = t.twin[l];
  if (r == kNone) return {reference_[l], 0, constraints_.Slope(y, l), 0, true};
  return {reference_[l], reference_[r], constraints_.Slope(y, l), constraints_.Slope(y, r), false};
}

EdgeConjugate DualAngleEnergy::Conjugate(Index e, const double* y) const {
  return objective_->Conjugate(SlopesAt(e, y), epsilon_);
}

template <class Visit>
double DualAngleEnergy::SumConjugates(const double* y, const Visit& visit) const {
  const int num_edges = constraints_.triangulation().num_edges();
  if (objective_->TakesArrays()) {
    std::vector<EdgeSlopes> edges(num_edges);
    ParallelFor(num_edges, [&](Index e) { edges[e] = SlopesAt(e, y); });
    std::vector<EdgeConjugate> conjugates(edges.size());
    objective_->Conjugates(edges, epsilon_, conjugates);
    return ParallelSum(num_edges, [&](Index e) { return visit(e, conjugates[e]); });
  }
  if (!objective_->PrefersArrays()) {
    return ParallelSum(num_edges, [&](Index e) { return visit(e, Conjugate(e, y)); });
  }
  return ParallelSumOfChunks(num_edges, [&](Index first, Index end, CompensatedSum* sum) {
    ChunkOf<EdgeSlopes> edges(end - first);
    ChunkOf<EdgeConjugate> conjugates(end - first);
    for (Index e = first; e < end; ++e) edges[e - first] = SlopesAt(e, y);
    objective_->Conjugates(edges, epsilon_, conjugates);
    for (Index e = first; e < end; ++e) *sum += visit(e, conjugates[e - first]);
  });
}

Eigen::VectorXd DualAngleEnergy::Maximise(const double* y, double* sum) const {
  const Triangulation& t = constraints_.triangulation();
  Eigen::VectorXd alpha(t.num_halfedges());
  *sum = SumConjugates(y, [&](Index e, const EdgeConjugate& g) {
    const Index l = t.edge_halfedge[e];
    alpha[l] = g.alpha_l;
    if (t.twin[l] != kNone) alpha[t.twin[l]] = g.alpha_r;
    return g.value;
  });
  return alpha;
}

bool DualAngleEnergy::Evaluate(const double* y, double* value, double* gradient) const {
  if (!AllFinite(y)) return false;
  const int rows = constraints_.num_rows();
  const Eigen::VectorXd alpha = Angles(y, value);
  if (gradient) {
    Eigen::Map<Eigen::VectorXd> of_row(gradient, rows);
    constraints_.Apply(alpha, of_row);
    ParallelFor(rows, [&](int row) { of_row[row] -= Target(y, row); });
  }
  return std::isfinite(*value);
}

bool DualAngleEnergy::Share(const double* y, const std::vector<bool>& own, double* share) const {
  if (!AllFinite(y)) return false;
  const Triangulation& t = constraints_.triangulation();
  const double of_edges = SumConjugates(y, [&](Index e, const EdgeConjugate& g) {
    return own[Triangulation::Face(t.edge_halfedge[e])] ? g.value : 0.;
  });
  *share = of_edges - ParallelSum(constraints_.num_rows(),
                                  [&](int row) { return own[row] ? Target(y, row) * y[row] : 0.; });
  return std::isfinite(*share);
}

bool DualAngleEnergy::Hessian(const double* y, SparseMatrix* lower) const {
  if (!AllFinite(y)) return false;
  const Triangulation& t = constraints_.triangulation();
  EdgeBlockAssembler matrix(constraints_);
  SumConjugates(y, [&](Index e, const EdgeConjugate& g) {
    const Index l = t.edge_halfedge[e], r = t.twin[l];
    matrix.Add(l, l, g.h_ll);
    if (r == kNone) return 0.;
    matrix.Add(r, r, g.h_rr);
    matrix.Add(l, r, g.h_lr);
    matrix.Add(r, l, g.h_lr);
    return 0.;
  });
  matrix.Assemble(lower);
  return true;
}

bool DualAngleEnergy::SmoothHessian(const double*, SparseMatrix* lower) const {
  EdgeBlockAssembler matrix(constraints_);
  const std::vector<double> references = ClampedReferences();
  std::vector<ScalarJet> jets(references.size());
  objective_->Distances(references, references, jets);
  ParallelFor(static_cast<int>(jets.size()),
              [&](Index h) { matrix.Add(h, h, 1 / jets[h].curvature); });
  matrix.Assemble(lower);
  return true;
}

const EnergySource* DualAngleEnergy::source() const {
  const bool by_name = !NameOf(objective_.get()).empty();
  return by_name && !constraints_.HasRanges() && !objective_->TakesArrays() ? this : nullptr;
}

std::vector<int> DualAngleEnergy::VertexParameters() const {
  std::vector<int> parameters(constraints_.triangulation().num_vertices, kNone);
  int row = constraints_.num_faces();
  for (const Index v : constraints_.constrained_vertices()) parameters[v] = row++;
  return parameters;
}

EnergyData DualAngleEnergy::DataOf(const MeshPart& part) const {
  EnergyData data;
  data.objective = NameOf(objective_.get());
  data.epsilon = epsilon_;
  data.angles = AtHalfedges(part, reference_);
  const std::vector<int> parameters = VertexParameters();
  for (const Index v : part.vertex) {
    const int row = parameters[v];
    data.lower.push_back(row == kNone ? 0 : constraints_.Lower(row));
    data.upper.push_back(row == kNone ? kPi * constraints_.corners()[v] : constraints_.Upper(row));
  }
  return data;
}

std::vector<int> DualAngleEnergy::GaugeParameters() const {
  // Along the kernel of A' the term b.y changes with the sides of ranged multipliers.
  const bool constant = constraints_.HasGauge() && !constraints_.HasRanges();
  return constant ? std::vector<int>{constraints_.num_faces()} : std::vector<int>{};
}

std::vector<Kink> DualAngleEnergy::Kinks() const {
  std::vector<Kink> kinks;
  for (int row = constraints_.num_faces(); row < constraints_.num_rows(); ++row) {
    const double range = constraints_.Upper(row) - constraints_.Lower(row);
    if (range > 0) kinks.push_back({row, range});
  }
  return kinks;
}

Eigen::VectorXd DualAngleEnergy::Angles(const double* y) const {
  double sum;
  return Maximise(y, &sum);
}

Eigen::VectorXd DualAngleEnergy::Angles(const double* y, double* value) const {
  Eigen::VectorXd alpha = Maximise(y, value);
  *value -= ParallelSum(constraints_.num_rows(), [&](int row) { return Target(y, row) * y[row]; });
  return alpha;
}

std::vector<double> DualAngleEnergy::ClampedReferences() const {
  std::vector<double> references(reference_.size());
  ParallelFor(static_cast<int>(references.size()), [&](Index h) {
    references[h] = objective_->ClampReference(reference_[h], epsilon_);
  });
  return references;
}

std::vector<ScalarJet> DualAngleEnergy::Distances(const Eigen::VectorXd& alpha) const {
  const std::vector<double> references = ClampedReferences();
  std::vector<ScalarJet> distances(references.size());
  objective_->Distances(references, {alpha.data(), references.size()}, distances);
  return distances;
}

double DualAngleEnergy::Primal(const Eigen::VectorXd& alpha,
                               const std::vector<ScalarJet>& distances) const {
  if (!objective_->MeasuresTheta()) {
    return ParallelSum(static_cast<int>(distances.size()),
                       [&](Index h) { return distances[h].value; });
  }
  const Triangulation& t = constraints_.triangulation();
  return ParallelSum(t.num_edges(), [&](Index e) {
    const Index l = t.edge_halfedge[e], r = t.twin[l];
    return r == kNone
               ? objective_->Boundary(reference_[l], epsilon_, alpha[l])
               : objective_->Interior(reference_[l], reference_[r], epsilon_, alpha[l], alpha[r]);
  });
}

}  // namespace cirque
