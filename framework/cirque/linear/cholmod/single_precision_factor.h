#pragma once

#ifdef CIRQUE_CHOLMOD

#include <cstddef>
#include <memory>
#include <vector>

#include <cholmod.h>

#include "cirque/linear/cholmod/supernodal_solver.h"

namespace cirque {

/// A supernodal LL' factor of CHOLMOD with its numbers rounded to single precision: a
/// preconditioner. A triangular solve does little but read the factor from main memory once, so it
/// takes a third of the time.
class SinglePrecisionFactor final : public SupernodeNumbers {
 public:
  /// Rounds the numbers of a factor where they are: they are not to be read any more, only computed
  /// anew, which ends this. Factor and tree must outlive this. Null, and nothing done, when numbers
  /// are out of the range of single precision.
  static std::unique_ptr<SinglePrecisionFactor> Round(const cholmod_factor& factor,
                                                      const SupernodalTree& tree);

  /// The memory that the numbers fill, from the first of the factor's on [bytes].
  std::size_t NumBytes() const { return start_.back() * sizeof(float); }

  void Solve(int s, double* w) const override;
  void SolveTransposed(int s, double* w) const override;

 private:
  SinglePrecisionFactor(const cholmod_factor& factor, const SupernodalTree& tree);
  const double* Doubles(int s) const;
  const float* Singles(int s) const { return static_cast<const float*>(factor_.x) + start_[s]; }
  bool CanRound(int s) const;
  bool CanRound() const;
  void RoundInPlace();

  /// Behind the last supernode from `begin` on whose single numbers will lie before where the
  /// double ones of `begin` are: those can be rounded in any order. At least one.
  int EndOfFree(int begin) const;

  const cholmod_factor& factor_;
  const SupernodalTree& tree_;
  std::vector<std::size_t> start_;  ///< per supernode, where its numbers begin
};

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
