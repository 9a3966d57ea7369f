#include "cirque/linear/multigrid.h"

#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

namespace cirque {
namespace {

constexpr char kHowToBuild[] =
    "install petsc-dev, libhypre-dev, libopenmpi-dev and pkg-config, and configure again";

/// As many processes as mpirun has started this program in.
int LaunchedRanks() {
  const char* size = std::getenv("OMPI_COMM_WORLD_SIZE");
  return size ? std::atoi(size) : 1;
}

#ifdef CIRQUE_PETSC

using MakeLibrary = MultigridLibrary*(bool all_ranks, std::string* error);

/// The module lies at one place relative to the programs, in the build tree as installed; programs
/// of other projects find the installed one.
std::vector<std::string> ModulePaths() {
  std::vector<std::string> paths;
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) paths.push_back(program.parent_path().parent_path() / CIRQUE_PETSC_MODULE);
  paths.push_back(CIRQUE_PETSC_INSTALLED_MODULE);
  return paths;
}

StatusOr<MultigridLibrary*> Load(bool all_ranks) {
  std::string error;
  for (const std::string& path : ModulePaths()) {
    void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!module) {
      error += fmt::format("{}{}", error.empty() ? "" : "; ", dlerror());
      continue;
    }
    auto* make = reinterpret_cast<MakeLibrary*>(dlsym(module, "CirqueMultigridLibrary"));
    MultigridLibrary* library = make ? make(all_ranks, &error) : nullptr;
    if (library) return library;
    break;
  }
  return Status::InvalidInput("multigrid: " + error);
}

#else

StatusOr<MultigridLibrary*> Load(bool) { return MultigridNotBuilt(); }

#endif

/// The first caller decides on which ranks.
const StatusOr<MultigridLibrary*>& Library(bool all_ranks) {
  static const StatusOr<MultigridLibrary*> kLibrary = Load(all_ranks);
  return kLibrary;
}

}  // namespace

bool BuiltWithMultigrid() {
#ifdef CIRQUE_PETSC
  return true;
#else
  return false;
#endif
}

Status MultigridNotBuilt() {
  return Status::InvalidInput(fmt::format("newton_amg: built without PETSc: {}", kHowToBuild));
}

StatusOr<MultigridLibrary*> LoadMultigrid() { return Library(false); }

MultigridLibrary* RanksAtService() {
  if (LaunchedRanks() <= 1) return nullptr;
  const auto& library = Library(false);
  return library.ok() && (*library)->num_ranks() > 1 ? *library : nullptr;
}

StatusOr<bool> ServeOtherRanks(const RankWorks& works) {
  if (LaunchedRanks() <= 1) return false;
  const auto& library = Library(true);
  if (!library.ok()) {
    return library.status().In(fmt::format("started in {} processes", LaunchedRanks()));
  }
  (*library)->SetWorks(works);
  if ((*library)->is_first_rank()) return false;
  (*library)->Serve();
  return true;
}

}  // namespace cirque
