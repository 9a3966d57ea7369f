#pragma once

#include <petscksp.h>

#include <string>

namespace cirque {

/// MPI and PETSc, initialised for the life of the process. Silent, without signal handlers, without
/// options from files; PETSC_OPTIONS is heeded.
class PetscSession {
 public:
  /// On all ranks that mpirun has started, or on this process alone.
  explicit PetscSession(bool all_ranks);

  /// Finalises what it has initialised, in the process that did so and not in a fork of it.
  ~PetscSession();

  PetscSession(const PetscSession&) = delete;
  PetscSession& operator=(const PetscSession&) = delete;

  /// Ready, and not a fork of the process that initialised.
  bool IsOwner() const;

  const std::string& error() const { return error_; }  ///< empty: ready
  MPI_Comm comm() const { return comm_; }
  int rank() const { return rank_; }
  int num_ranks() const { return num_ranks_; }

 private:
  bool StartMpi(bool all_ranks);
  void StartPetsc();

  const int process_;
  std::string error_;
  MPI_Comm comm_ = MPI_COMM_NULL;
  int rank_ = 0, num_ranks_ = 1;
  bool owns_mpi_ = false, owns_petsc_ = false;
};

}  // namespace cirque
