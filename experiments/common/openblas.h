#pragma once

namespace cirque {

/// Takes back what OpenBLAS was told through the environment while it was loaded: programs that this one
/// starts choose for themselves.
void ForgetOpenBlasKernels();

}  // namespace cirque
