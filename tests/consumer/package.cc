// A program of another project: the library and the BLAS that it was given are the right ones.
#include <dlfcn.h>

#include <string_view>

#include "cirque/cirque.h"

namespace {

// Whether the BLAS that CHOLMOD's calls bind to is OpenBLAS (true when there is none at all).
bool BlasIsOpenBlas() {
  const void* dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
  Dl_info info;
  if (dgemm == nullptr || dladdr(dgemm, &info) == 0) return true;
  return std::string_view(info.dli_fname).find("openblas") != std::string_view::npos;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 || cirque::Version() != argv[1]) return 1;
  return BlasIsOpenBlas() ? 0 : 2;
}
