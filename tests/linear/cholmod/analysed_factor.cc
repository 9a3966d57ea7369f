#ifdef CIRQUE_CHOLMOD

#include "tests/linear/cholmod/analysed_factor.h"

#include <utility>

#include "cirque/linear/cholmod/matrix_view.h"

namespace cirque {

AnalysedFactor::AnalysedFactor(SparseMatrix lower) : lower_(std::move(lower)) {
  cholmod_start(&common_);
  common_.supernodal = CHOLMOD_SUPERNODAL;
  common_.final_ll = 1;
  view_ = ViewOf(lower_);
  factor_ = cholmod_analyze(&view_, &common_);
}

AnalysedFactor::~AnalysedFactor() {
  cholmod_free_factor(&factor_, &common_);
  cholmod_finish(&common_);
}

void AnalysedFactor::FactorizeByCholmod() { cholmod_factorize(&view_, factor_, &common_); }

void AnalysedFactor::AllocateNumbers() {
  cholmod_change_factor(CHOLMOD_REAL, 1, 1, 1, 1, factor_, &common_);
}

}  // namespace cirque

#endif  // CIRQUE_CHOLMOD
