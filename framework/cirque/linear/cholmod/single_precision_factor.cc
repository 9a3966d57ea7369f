#ifdef CIRQUE_CHOLMOD

#include "cirque/linear/cholmod/single_precision_factor.h"

#include <algorithm>
#include <atomic>

#include <Eigen/Core>

#include "cirque/core/parallel.h"
#include "cirque/linear/cholmod/supernode_tiles.h"

namespace cirque {
namespace {

constexpr int kSlices = 16;                                   ///< that are rounded at once
constexpr double kLeastPivot = 1e-18, kLargestNumber = 1e18;  ///< their squares are single too

static_assert(SupernodeNumbers::kPadding >= SupernodeTiles::kRows - 1);

SupernodeTiles TilesOf(const SupernodalTree& tree, int s) {
  return {tree.NumRows(s), tree.NumColumns(s)};
}

}  // namespace

std::unique_ptr<SinglePrecisionFactor> SinglePrecisionFactor::Round(const cholmod_factor& factor,
                                                                    const SupernodalTree& tree) {
  std::unique_ptr<SinglePrecisionFactor> rounded(new SinglePrecisionFactor(factor, tree));
  if (!rounded->CanRound()) return nullptr;
  rounded->RoundInPlace();
  return rounded;
}

SinglePrecisionFactor::SinglePrecisionFactor(const cholmod_factor& factor,
                                             const SupernodalTree& tree)
    : factor_(factor), tree_(tree), start_(1, 0) {
  for (int s = 0; s < tree_.num_supernodes(); ++s) {
    start_.push_back(start_.back() + TilesOf(tree_, s).Size());
  }
}

const double* SinglePrecisionFactor::Doubles(int s) const {
  return static_cast<const double*>(factor_.x) + static_cast<const int*>(factor_.px)[s];
}

bool SinglePrecisionFactor::CanRound(int s) const {
  const Eigen::Map<const Eigen::MatrixXd> numbers(Doubles(s), tree_.NumRows(s),
                                                  tree_.NumColumns(s));
  return numbers.diagonal().minCoeff() > kLeastPivot &&
         numbers.lpNorm<Eigen::Infinity>() < kLargestNumber &&
         2 * (Doubles(s + 1) - Doubles(0)) >= static_cast<std::ptrdiff_t>(start_[s + 1]);
}

bool SinglePrecisionFactor::CanRound() const {
  std::atomic<bool> can = true;
  ParallelFor(tree_.num_supernodes(), [&](int s) {
    if (can && !CanRound(s)) can = false;
  });
  return can;
}

void SinglePrecisionFactor::RoundInPlace() {
  float* const singles = static_cast<float*>(factor_.x);
  const auto round = [&](int begin, int end) {
    for (int s = begin; s < end; ++s) TilesOf(tree_, s).Store(Doubles(s), singles + start_[s]);
  };
  for (int begin = 0, end; begin < tree_.num_supernodes(); begin = end) {
    end = EndOfFree(begin);
    const int slice = (end - begin) / kSlices;
    if (slice > 0) {
      ParallelTasks(kSlices, [&](int k) { round(begin + k * slice, begin + (k + 1) * slice); });
    }
    round(begin + kSlices * slice, end);
  }
}

int SinglePrecisionFactor::EndOfFree(int begin) const {
  const std::size_t room = 2 * (Doubles(begin) - Doubles(0));
  const auto past = std::upper_bound(start_.begin() + begin, start_.end(), room);
  return std::max(begin + 1, static_cast<int>(past - start_.begin()) - 1);
}

void SinglePrecisionFactor::Solve(int s, double* w) const {
  TilesOf(tree_, s).Solve(Singles(s), w);
}

void SinglePrecisionFactor::SolveTransposed(int s, double* w) const {
  TilesOf(tree_, s).SolveTransposed(Singles(s), w);
}

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
