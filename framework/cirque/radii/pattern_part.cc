#include "cirque/radii/pattern_part.h"

#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/radii/pattern_volume.h"

namespace cirque {

class PatternPart::Domain final : public VolumeDomain {
 public:
  explicit Domain(PatternPart* part) : part_(*part) {}

  bool SolveForChange(SparseMatrix* lower, const Eigen::VectorXd& right_side,
                      const Eigen::VectorXd& rho, Eigen::VectorXd* change) override {
    part_.SetMatrix(*lower);
    SparseMatrix().swap(*lower);
    part_.solver().Damp(0);
    const Eigen::VectorXd missing =
        part_.OwnOf(right_side) - part_.solver().Times(part_.OwnOf(rho));
    Eigen::VectorXd own;
    const bool solved = part_.solver().Solve(missing, kVolumeTolerance, &own, part_.Summary());
    part_.solver().ForgetRows();
    if (solved) *change = part_.WithOthers(own);
    return solved;
  }
  double Sum(double mine) override { return part_.ranks().Sum(mine); }
  double Least(double mine) override { return -part_.ranks().Largest(-mine); }
  double LargestEntry(const Eigen::VectorXd& gradient) override {
    return part_.ranks().Largest(part_.OwnOf(gradient).lpNorm<Eigen::Infinity>());
  }
  bool Counts(Index face) const override { return part_.is_own()[face]; }

 private:
  PatternPart& part_;
};

PatternPart::PatternPart(Ranks* ranks)
    : NewtonPart(ranks, EnergyPartMakers().at(kCirclePatternWork)) {}

void PatternPart::Do(int task) {
  if (task != kMaximizeVolume) return NewtonPart::Do(task);
  Domain domain(this);
  Eigen::VectorXd rho;
  MaximizeVolume(triangulation(), data().angles, static_cast<const CirclePatternEnergy&>(energy()),
                 Told(call.tolerance), &domain, &rho);
  Gather(OwnOf(rho), call.result);
}

}  // namespace cirque
