#include "cirque/linear/petsc/rank_team.h"

#include <chrono>
#include <cstdint>
#include <exception>
#include <iterator>
#include <numeric>
#include <thread>

#include <glog/logging.h>

namespace cirque {
namespace {

constexpr std::chrono::microseconds kNap(500);
constexpr int kStarts = 0, kColumns = 1, kValues = 2;  ///< tags of messages

template <class T>
void Send(const std::vector<T>& values, MPI_Datatype type, int rank, int tag, MPI_Comm comm) {
  MPI_Send(values.data(), static_cast<int>(values.size()), type, rank, tag, comm);
}

template <class T>
void Receive(std::size_t count, MPI_Datatype type, int tag, MPI_Comm comm, std::vector<T>* values) {
  values->resize(count);
  MPI_Recv(values->data(), static_cast<int>(count), type, 0, tag, comm, MPI_STATUS_IGNORE);
}

}  // namespace

bool RankTeam::Run(const RankCommand& command, const RankData& data, std::string* error) {
  const std::lock_guard lock(mutex_);
  Announce(command);
  return Obey(command, data, error);
}

RankWork* RankTeam::Begin(const std::string& work, int number) {
  const auto known = known_works_.find(work);
  if (known == known_works_.end()) return nullptr;
  RankCommand command{RankCommand::kBegin, number};
  command.work = static_cast<int>(std::distance(known_works_.begin(), known));
  std::string error;
  return Run(command, {}, &error) ? works_.at(number).get() : nullptr;
}

void RankTeam::Stop() {
  const std::lock_guard lock(mutex_);
  systems_.clear();
  works_.clear();
  Announce({});
}

void RankTeam::Serve() {
  RankCommand command;
  std::string error;
  while ((command = Await()).operation != RankCommand::kStop) Obey(command, {}, &error);
  systems_.clear();
  works_.clear();
}

int RankTeam::FirstRow(int rank, int size) const {
  return static_cast<int>(static_cast<std::int64_t>(size) * rank / session_.num_ranks());
}

std::vector<int> RankTeam::RowCounts(int size) const {
  std::vector<int> counts(session_.num_ranks());
  for (int r = 0; r < session_.num_ranks(); ++r) {
    counts[r] = FirstRow(r + 1, size) - FirstRow(r, size);
  }
  return counts;
}

void RankTeam::Announce(RankCommand command) {
  if (session_.num_ranks() == 1) return;
  MPI_Request request;
  MPI_Ibcast(&command, sizeof(command), MPI_BYTE, 0, session_.comm(), &request);
  MPI_Wait(&request, MPI_STATUS_IGNORE);
}

RankCommand RankTeam::Await() {
  RankCommand command;
  MPI_Request request;
  MPI_Ibcast(&command, sizeof(command), MPI_BYTE, 0, session_.comm(), &request);
  // MPI waits by turning its wheels; what the first rank does by itself can take minutes.
  for (int arrived = 0; !arrived;) {
    MPI_Test(&request, &arrived, MPI_STATUS_IGNORE);
    if (!arrived) std::this_thread::sleep_for(kNap);
  }
  return command;
}

bool RankTeam::Obey(const RankCommand& command, const RankData& data, std::string* error) {
  try {
    const PetscErrorCode code = Execute(command, data);
    if (code == 0) return true;
    *error = PetscErrorText(code);
  } catch (const std::exception& exception) {
    *error = exception.what();
  }
  if (session_.num_ranks() > 1) {
    LOG(ERROR) << "rank " << session_.rank() << ": " << *error;
    MPI_Abort(session_.comm(), 1);
  }
  return false;
}

PetscErrorCode RankTeam::Execute(const RankCommand& command, const RankData& data) {
  if (command.operation == RankCommand::kRelease) {
    systems_.erase(command.system);
    return 0;
  }
  if (command.operation >= RankCommand::kBegin) {
    DoWork(command);
    return 0;
  }
  std::unique_ptr<RankSystem>& system = systems_[command.system];
  if (!system) system = std::make_unique<RankSystem>(session_.comm());
  if (command.operation == RankCommand::kSetUp) return system->SetUp(command.method);
  if (command.operation == RankCommand::kSolve) return Solve(command, data, system.get());
  return system->SetRows(session_.rank() == 0 ? HandOutRows(data.lower)
                                              : ReceiveRows(command.size));
}

void RankTeam::DoWork(const RankCommand& command) {
  if (command.operation == RankCommand::kDo) {
    works_.at(command.system)->Do(command.task);
  } else if (command.operation == RankCommand::kBegin) {
    works_[command.system] = std::next(known_works_.begin(), command.work)->second(ranks_);
  } else {
    works_.erase(command.system);
  }
  ReturnFreedMemory();
}

PetscErrorCode RankTeam::Solve(const RankCommand& command, const RankData& data,
                               RankSystem* system) {
  MultigridResult result;
  if (session_.num_ranks() == 1) {
    return system->Solve(data.right_side, command.target, command.max_iterations, data.solution,
                         data.result);
  }
  const std::vector<int> counts = RowCounts(command.size);
  std::vector<int> first(counts.size(), 0);
  std::partial_sum(counts.begin(), counts.end() - 1, first.begin() + 1);
  const int count = counts[session_.rank()];
  std::vector<double> b(count), x(count);
  const auto scatter = [&](const double* whole, std::vector<double>* part) {
    MPI_Scatterv(whole, counts.data(), first.data(), MPI_DOUBLE, part->data(), count, MPI_DOUBLE, 0,
                 session_.comm());
  };
  scatter(data.right_side, &b);
  scatter(data.solution, &x);
  PetscCall(system->Solve(b.data(), command.target, command.max_iterations, x.data(), &result));
  MPI_Gatherv(x.data(), count, MPI_DOUBLE, data.solution, counts.data(), first.data(), MPI_DOUBLE,
              0, session_.comm());
  if (data.result) *data.result = result;
  return 0;
}

MatrixRows RankTeam::HandOutRows(const LowerTriangleView& lower) {
  for (int r = 1; r < session_.num_ranks(); ++r) {
    const MatrixRows rows =
        ExtractRows(lower, FirstRow(r, lower.size), FirstRow(r + 1, lower.size));
    Send(rows.start, MPI_INT, r, kStarts, session_.comm());
    Send(rows.column, MPI_INT, r, kColumns, session_.comm());
    Send(rows.value, MPI_DOUBLE, r, kValues, session_.comm());
  }
  return ExtractRows(lower, 0, FirstRow(1, lower.size));
}

MatrixRows RankTeam::ReceiveRows(int size) {
  MatrixRows rows;
  rows.size = size;
  const int first = FirstRow(session_.rank(), size), last = FirstRow(session_.rank() + 1, size);
  Receive(last - first + 1, MPI_INT, kStarts, session_.comm(), &rows.start);
  Receive(rows.start.back(), MPI_INT, kColumns, session_.comm(), &rows.column);
  Receive(rows.start.back(), MPI_DOUBLE, kValues, session_.comm(), &rows.value);
  return rows;
}

}  // namespace cirque
