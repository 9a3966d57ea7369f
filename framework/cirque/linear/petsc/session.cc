#include "cirque/linear/petsc/session.h"

#include <unistd.h>

#include <cstdlib>
#include <set>

namespace cirque {
namespace {

/// Restores the environment at its end: MPI notes there that this process is by itself, which would
/// mislead an mpirun that this process starts.
class EnvironmentGuard {
 public:
  EnvironmentGuard() : names_(Names()) {}
  ~EnvironmentGuard() {
    for (const std::string& name : Names()) {
      if (!names_.contains(name)) unsetenv(name.c_str());
    }
  }
  EnvironmentGuard(const EnvironmentGuard&) = delete;
  EnvironmentGuard& operator=(const EnvironmentGuard&) = delete;

 private:
  static std::set<std::string> Names() {
    std::set<std::string> names;
    for (char** entry = environ; *entry; ++entry) {
      const std::string text = *entry;
      names.insert(text.substr(0, text.find('=')));
    }
    return names;
  }

  const std::set<std::string> names_;
};

bool HasOtherRanks() {
  const char* size = std::getenv("OMPI_COMM_WORLD_SIZE");
  return size && std::atoi(size) > 1;
}

/// Where the user's own settings say nothing.
void SetMpiUp() {
  if (HasOtherRanks()) {
    // Ranks that wait shall leave the core to those that work.
    setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
    return;
  }
  // A process by itself needs no daemon for processes to come, and no folder for them, which all such
  // processes of a machine would make and remove under one name.
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
}

}  // namespace

PetscSession::PetscSession(bool all_ranks) : process_(getpid()) {
  if (!StartMpi(all_ranks)) return;
  comm_ = all_ranks ? MPI_COMM_WORLD : MPI_COMM_SELF;
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &num_ranks_);
  StartPetsc();
}

bool PetscSession::StartMpi(bool all_ranks) {
  int initialized = 0;
  MPI_Initialized(&initialized);
  if (initialized) return true;
  if (HasOtherRanks() && !all_ranks) {
    error_ = "this program cannot share its work among the processes that mpirun has started";
    return false;
  }
  const EnvironmentGuard guard;
  SetMpiUp();
  int provided = 0;
  owns_mpi_ = MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided) == MPI_SUCCESS;
  if (!owns_mpi_) error_ = "MPI could not be initialised";
  return owns_mpi_;
}

void PetscSession::StartPetsc() {
  PetscBool initialized = PETSC_FALSE;
  PetscInitialized(&initialized);
  if (initialized) return;
  PETSC_COMM_WORLD = comm_;
  PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");
  PetscOptionsSetValue(nullptr, "-skip_petscrc", "true");
  owns_petsc_ = PetscInitializeNoArguments() == 0;
  if (!owns_petsc_) {
    error_ = "PETSc could not be initialised";
    return;
  }
  PetscPushErrorHandler(PetscReturnErrorHandler, nullptr);
}

bool PetscSession::IsOwner() const { return getpid() == process_ && error_.empty(); }

PetscSession::~PetscSession() {
  if (getpid() != process_) return;
  if (owns_petsc_) PetscFinalize();
  if (owns_mpi_) MPI_Finalize();
}

}  // namespace cirque
