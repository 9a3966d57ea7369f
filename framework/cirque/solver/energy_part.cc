#include "cirque/solver/energy_part.h"

#include <algorithm>
#include <string>
#include <utility>

#include <glog/logging.h>

namespace cirque {
namespace {

Eigen::VectorXd At(const std::vector<int>& places, const double* values) {
  Eigen::VectorXd found(static_cast<Eigen::Index>(places.size()));
  for (Eigen::Index k = 0; k < found.size(); ++k) found[k] = values[places[k]];
  return found;
}

/// The own unknowns of a rank by their number: parameters of the whole.
std::vector<int> OwnParameters(const MeshPart& part, int rank) {
  const int first = part.first[rank];
  std::vector<int> own(part.first[rank + 1] - first);
  for (std::size_t p = 0; p < part.number.size(); ++p) {
    const int k = part.number[p] - first;
    if (k >= 0 && k < static_cast<int>(own.size())) own[k] = part.parameter[p];
  }
  return own;
}

std::vector<int> PlacesOf(const std::vector<int>& wanted, const std::vector<int>& among) {
  std::vector<int> places;
  for (int k = 0; k < static_cast<int>(among.size()); ++k) {
    if (std::find(wanted.begin(), wanted.end(), among[k]) != wanted.end()) places.push_back(k);
  }
  return places;
}

}  // namespace

void EnergyPart::Do(int task) {
  if (task == kTake) return Take();
  const Eigen::VectorXd x = Scatter(call.x);
  if (task == kShare) {
    call.done = Value(x, &call.number);
  } else {
    Eigen::VectorXd gradient;
    call.done = Gradient(x, &gradient);
    Gather(gradient, call.result);
  }
}

void EnergyPart::Take() {
  if (ranks_.rank() == 0) {
    HandOut();
  } else {
    MeshPart part = MeshPart::Receive(&ranks_);
    EnergyData data = EnergyData::Receive(&ranks_);
    Keep(std::move(part), std::move(data), ranks_.ReceiveArray<int>(0));
  }
  ListUnknowns();
}

/// Part by part: the first rank never has more than two at a time.
void EnergyPart::HandOut() {
  const EnergySource& source = *call.source;
  const MeshPartition parts(source.triangulation(), source.VertexParameters(), ranks_.num_ranks());
  const std::vector<int> gauge = source.GaugeParameters();
  own_.resize(ranks_.num_ranks());
  for (int r = ranks_.num_ranks() - 1; r >= 0; --r) {
    MeshPart part = parts.Part(r);
    EnergyData data = source.DataOf(part);
    own_[r] = OwnParameters(part, r);
    const std::vector<int> of_gauge = PlacesOf(gauge, own_[r]);
    if (r == 0) {
      Keep(std::move(part), std::move(data), of_gauge);
    } else {
      part.Send(&ranks_, r);
      data.Send(&ranks_, r);
      ranks_.SendArray(r, of_gauge);
    }
  }
}

void EnergyPart::Keep(MeshPart part, EnergyData data, std::vector<int> gauge) {
  part_ = std::move(part);
  part_.face = part_.vertex = {};
  data_ = std::move(data);
  gauge_ = std::move(gauge);
  energy_ = make_(part_.triangulation, data_);
}

void EnergyPart::ListUnknowns() {
  const int first = part_.first[ranks_.rank()], end = part_.first[ranks_.rank() + 1];
  RankUnknowns unknowns{part_.first, {}};
  for (const int number : part_.number) {
    is_own_.push_back(number >= first && number < end);
    if (!is_own_.back()) unknowns.ghosts.push_back(number);
  }
  std::sort(unknowns.ghosts.begin(), unknowns.ghosts.end());
  parameter_.assign(end - first, kNone);
  for (std::size_t p = 0; p < part_.number.size(); ++p) {
    const int number = part_.number[p];
    const auto ghost = std::lower_bound(unknowns.ghosts.begin(), unknowns.ghosts.end(), number);
    slot_.push_back(is_own_[p] ? number - first
                               : end - first + static_cast<int>(ghost - unknowns.ghosts.begin()));
    if (is_own_[p]) parameter_[number - first] = static_cast<int>(p);
  }
  CHECK(std::find(parameter_.begin(), parameter_.end(), kNone) == parameter_.end())
      << "a part lacks a parameter of its own";
  part_.number = {};
  halo_.emplace(&ranks_, unknowns);
  MakeSolver();
}

void EnergyPart::MakeSolver() {
  const int most = Told(call.options.max_cg_iterations);
  std::string method(Told(call.options.multigrid.size()), ' ');
  if (ranks_.rank() == 0) method = call.options.multigrid;
  ranks_.Broadcast(method.data(), method.size());
  solver_.emplace(&*halo_, method, most);
}

Eigen::VectorXd EnergyPart::Scatter(const double* all) const {
  if (ranks_.rank() == 0) {
    for (int r = 1; r < ranks_.num_ranks(); ++r) {
      const Eigen::VectorXd values = At(own_[r], all);
      ranks_.Send(r, values.data(), values.size() * sizeof(double));
    }
    return At(own_[0], all);
  }
  Eigen::VectorXd values(num_own());
  ranks_.Receive(0, values.data(), values.size() * sizeof(double));
  return values;
}

void EnergyPart::Gather(const Eigen::VectorXd& own, double* all) const {
  if (ranks_.rank() > 0) return ranks_.Send(0, own.data(), own.size() * sizeof(double));
  for (int r = 0; r < ranks_.num_ranks(); ++r) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(own_[r].size()));
    if (r > 0) ranks_.Receive(r, values.data(), values.size() * sizeof(double));
    const Eigen::VectorXd& of_rank = r == 0 ? own : values;
    for (Eigen::Index k = 0; k < of_rank.size(); ++k) all[own_[r][k]] = of_rank[k];
  }
}

Eigen::VectorXd EnergyPart::OwnOf(const Eigen::VectorXd& of_part) const {
  return At(parameter_, of_part.data());
}

Eigen::VectorXd EnergyPart::WithOthers(const Eigen::VectorXd& own) const {
  Eigen::VectorXd local(halo_->num_local());
  local.head(own.size()) = own;
  halo_->Fill(&local);
  return At(slot_, local.data());
}

bool EnergyPart::Value(const Eigen::VectorXd& x, double* value) {
  const bool done = energy_->Share(WithOthers(x).data(), is_own_, value);
  *value = ranks_.Sum(*value);
  return ranks_.All(done);
}

bool EnergyPart::Gradient(const Eigen::VectorXd& x, Eigen::VectorXd* gradient) {
  const Eigen::VectorXd of_part = WithOthers(x);
  Eigen::VectorXd slopes(of_part.size());
  const bool done = energy_->Gradient(of_part.data(), slopes.data());
  *gradient = OwnOf(slopes);
  return ranks_.All(done);
}

bool EnergyPart::Relax(double threshold, Eigen::VectorXd* x, Eigen::VectorXd* gradient) {
  Eigen::VectorXd of_part = WithOthers(*x), slopes = Eigen::VectorXd::Zero(of_part.size());
  for (int k = 0; k < num_own(); ++k) slopes[parameter_[k]] = (*gradient)[k];
  const bool here = energy_->Relax(threshold, of_part.data(), slopes.data());
  if (ranks_.All(!here)) return false;
  *x = OwnOf(of_part);
  return Gradient(*x, gradient);
}

bool EnergyPart::Linearize(const Eigen::VectorXd& x, double* mean_diagonal) {
  return SetMatrixTo(&Energy::Hessian, x, mean_diagonal);
}

bool EnergyPart::LinearizeSmooth(const Eigen::VectorXd& x, double* mean_diagonal) {
  return SetMatrixTo(&Energy::SmoothHessian, x, mean_diagonal);
}

/// None is set, and false, where it is not defined on all ranks.
bool EnergyPart::SetMatrixTo(MatrixForm form, const Eigen::VectorXd& x, double* mean_diagonal) {
  solver_->ForgetRows();
  SparseMatrix lower;
  const bool defined = ((*energy_).*form)(WithOthers(x).data(), &lower);
  if (!ranks_.All(defined)) return false;
  SetMatrix(lower);
  *mean_diagonal = solver_->MeanDiagonal();
  return true;
}

bool EnergyPart::PrepareForSystemsNear(double damping, SolveSummary* summary) {
  solver_->Damp(damping);
  return solver_->PrepareForSystemsNear(summary);
}

bool EnergyPart::Solve(double damping, const Eigen::VectorXd& right_side, double tolerance,
                       Eigen::VectorXd* x, SolveSummary* summary) {
  solver_->Damp(damping);
  x->setZero(right_side.size());
  return solver_->Solve(right_side, tolerance, x, summary);
}

void EnergyPart::SetMatrix(const SparseMatrix& lower) {
  solver_->SetRows(OwnRows(lower, slot_, static_cast<int>(parameter_.size())), gauge_);
}

}  // namespace cirque
