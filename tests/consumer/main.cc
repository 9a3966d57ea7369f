// A program of another project: it uses the installed library and checks what it was given.
#include <dlfcn.h>

#include <string_view>

#include "cirque/core/text.h"
#include "cirque/core/version.h"

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
  if (cirque::NearestWord("newtn", {"newton", "cg"}) != "newton") return 2;
  return BlasIsOpenBlas() ? 0 : 3;
}
