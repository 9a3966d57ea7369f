#include "cirque/linear/petsc/mpi_ranks.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "cirque/linear/petsc/rank_system.h"

namespace cirque {
namespace {

constexpr int kTag = 3;  ///< other than those of the rank team

/// MPI counts in int.
int CountOf(std::size_t bytes) {
  if (bytes > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw std::length_error("a message between ranks of more than 2 GiB: use more ranks");
  }
  return static_cast<int>(bytes);
}

class SharedPetscSystem final : public SharedSystem {
 public:
  explicit SharedPetscSystem(MPI_Comm comm) : system_(comm) {}

  bool SetRows(const MatrixRows& rows) override { return Succeeds(system_.SetRows(rows)); }

  bool SetUp(const std::string& method) override {
    const int number = NumberOfMethod(method);
    if (number < 0) throw std::invalid_argument("this PETSc has no '" + method + "'");
    return Succeeds(system_.SetUp(number));
  }

  bool Solve(const double* b, double target, int max_iterations, double* x,
             MultigridResult* result) override {
    return Succeeds(system_.Solve(b, target, max_iterations, x, result));
  }

 private:
  /// The others might wait for this rank for ever: whoever runs the ranks' work ends them all.
  static bool Succeeds(PetscErrorCode code) {
    if (code != 0) throw std::runtime_error(PetscErrorText(code));
    return true;
  }

  RankSystem system_;
};

}  // namespace

std::string PetscErrorText(PetscErrorCode code) {
  const char* text = nullptr;
  PetscErrorMessage(code, &text, nullptr);
  return text ? text : "unknown error";
}

void MpiRanks::Broadcast(void* data, std::size_t bytes) {
  MPI_Bcast(data, CountOf(bytes), MPI_BYTE, 0, session_.comm());
}

void MpiRanks::Send(int to, const void* data, std::size_t bytes) {
  MPI_Send(data, CountOf(bytes), MPI_BYTE, to, kTag, session_.comm());
}

void MpiRanks::Receive(int from, void* data, std::size_t bytes) {
  MPI_Recv(data, CountOf(bytes), MPI_BYTE, from, kTag, session_.comm(), MPI_STATUS_IGNORE);
}

void MpiRanks::SendReceive(int to, const void* sent, std::size_t sent_bytes, int from,
                           void* received, std::size_t received_bytes) {
  MPI_Sendrecv(sent, CountOf(sent_bytes), MPI_BYTE, to, kTag, received, CountOf(received_bytes),
               MPI_BYTE, from, kTag, session_.comm(), MPI_STATUS_IGNORE);
}

void MpiRanks::AllGather(const void* mine, std::size_t bytes, void* all) {
  const int count = CountOf(bytes);
  MPI_Allgather(mine, count, MPI_BYTE, all, count, MPI_BYTE, session_.comm());
}

std::unique_ptr<SharedSystem> MpiRanks::MakeSystem() {
  return std::make_unique<SharedPetscSystem>(session_.comm());
}

}  // namespace cirque
