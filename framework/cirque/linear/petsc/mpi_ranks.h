#pragma once

#include "cirque/linear/multigrid.h"
#include "cirque/linear/petsc/session.h"

namespace cirque {

/// Ranks by MPI, and PETSc's systems on them.
class MpiRanks final : public Ranks {
 public:
  explicit MpiRanks(const PetscSession& session) : session_(session) {}

  int rank() const override { return session_.rank(); }
  int num_ranks() const override { return session_.num_ranks(); }
  void Broadcast(void* data, std::size_t bytes) override;
  void Send(int to, const void* data, std::size_t bytes) override;
  void Receive(int from, void* data, std::size_t bytes) override;
  void SendReceive(int to, const void* sent, std::size_t sent_bytes, int from, void* received,
                   std::size_t received_bytes) override;
  void AllGather(const void* mine, std::size_t bytes, void* all) override;
  std::unique_ptr<SharedSystem> MakeSystem() override;

 private:
  const PetscSession& session_;
};

/// What PETSc says of an error code.
std::string PetscErrorText(PetscErrorCode code);

}  // namespace cirque
