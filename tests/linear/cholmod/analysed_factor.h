#pragma once

#ifdef CIRQUE_CHOLMOD

#include <cholmod.h>

#include "cirque/energy/energy.h"

namespace cirque {

/// A matrix as CHOLMOD sees it, and its supernodal analysis.
class AnalysedFactor {
 public:
  explicit AnalysedFactor(SparseMatrix lower);
  ~AnalysedFactor();
  AnalysedFactor(const AnalysedFactor&) = delete;
  AnalysedFactor& operator=(const AnalysedFactor&) = delete;

  /// Has CHOLMOD compute the numbers, or only make room for them.
  void FactorizeByCholmod();
  void AllocateNumbers();

  cholmod_factor& factor() { return *factor_; }

 private:
  SparseMatrix lower_;
  cholmod_sparse view_ = {};
  cholmod_common common_ = {};
  cholmod_factor* factor_;
};

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
