#include "tests/linear/thread_ranks.h"

#include <condition_variable>
#include <cstring>
#include <deque>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

namespace cirque {
namespace {

/// What has been sent and not yet received, by sender and receiver.
class Post {
 public:
  void Send(int from, int to, const void* data, std::size_t bytes) {
    const auto* begin = static_cast<const char*>(data);
    const std::lock_guard lock(mutex_);
    letters_[{from, to}].emplace_back(begin, begin + bytes);
    arrived_.notify_all();
  }

  void Receive(int from, int to, void* data, std::size_t bytes) {
    std::unique_lock lock(mutex_);
    auto& letters = letters_[{from, to}];
    arrived_.wait(lock, [&] { return !letters.empty(); });
    EXPECT_EQ(letters.front().size(), bytes);
    if (bytes > 0) std::memcpy(data, letters.front().data(), bytes);
    letters.pop_front();
  }

 private:
  std::mutex mutex_;
  std::condition_variable arrived_;
  std::map<std::pair<int, int>, std::deque<std::vector<char>>> letters_;
};

/// Every rank has the whole matrix, and solves the whole system for its rows of it.
class DenseSystem final : public SharedSystem {
 public:
  explicit DenseSystem(Ranks* ranks) : ranks_(*ranks) {}

  bool SetRows(const MatrixRows& rows) override {
    counts_ = ranks_.AllOf(rows.num_rows());
    Eigen::MatrixXd mine = Eigen::MatrixXd::Zero(rows.size, rows.num_rows());
    for (int i = 0; i < rows.num_rows(); ++i) {
      for (int k = rows.start[i]; k < rows.start[i + 1]; ++k)
        mine(rows.column[k], i) = rows.value[k];
    }
    matrix_ = Gather(mine.reshaped(), rows.size).reshaped(rows.size, rows.size);
    EXPECT_LT((matrix_ - matrix_.transpose()).lpNorm<Eigen::Infinity>(), 1e-14 * matrix_.norm());
    return true;
  }

  bool SetUp(const std::string&) override { return true; }

  bool Solve(const double* b, double, int, double* x, MultigridResult* result) override {
    const Eigen::LLT<Eigen::MatrixXd> factor(matrix_);
    const int count = counts_[ranks_.rank()];
    const Eigen::VectorXd solution =
        factor.solve(Gather(Eigen::Map<const Eigen::VectorXd>(b, count), 1));
    int first = 0;
    for (int r = 0; r < ranks_.rank(); ++r) first += counts_[r];
    Eigen::Map<Eigen::VectorXd>(x, count) = solution.segment(first, count);
    *result = {1, factor.info() == Eigen::Success};
    return true;
  }

 private:
  /// `mine` of all ranks, of so many numbers a row, behind one another.
  Eigen::VectorXd Gather(const Eigen::VectorXd& mine, int per_row) {
    Eigen::VectorXd all(0);
    for (int r = 0; r < ranks_.num_ranks(); ++r) {
      if (r != ranks_.rank()) ranks_.Send(r, mine.data(), mine.size() * sizeof(double));
    }
    for (int r = 0; r < ranks_.num_ranks(); ++r) {
      Eigen::VectorXd of_rank = mine;
      if (r != ranks_.rank()) {
        of_rank.resize(counts_[r] * per_row);
        ranks_.Receive(r, of_rank.data(), of_rank.size() * sizeof(double));
      }
      all.conservativeResize(all.size() + of_rank.size());
      all.tail(of_rank.size()) = of_rank;
    }
    return all;
  }

  Ranks& ranks_;
  std::vector<int> counts_;
  Eigen::MatrixXd matrix_;
};

class ThreadRanks final : public Ranks {
 public:
  ThreadRanks(int rank, int num_ranks, Post* post)
      : rank_(rank), num_ranks_(num_ranks), post_(*post) {}

  int rank() const override { return rank_; }
  int num_ranks() const override { return num_ranks_; }

  void Broadcast(void* data, std::size_t bytes) override {
    if (rank_ > 0) return Receive(0, data, bytes);
    for (int r = 1; r < num_ranks_; ++r) Send(r, data, bytes);
  }
  void Send(int to, const void* data, std::size_t bytes) override {
    post_.Send(rank_, to, data, bytes);
  }
  void Receive(int from, void* data, std::size_t bytes) override {
    post_.Receive(from, rank_, data, bytes);
  }
  void SendReceive(int to, const void* sent, std::size_t sent_bytes, int from, void* received,
                   std::size_t received_bytes) override {
    Send(to, sent, sent_bytes);
    Receive(from, received, received_bytes);
  }
  void AllGather(const void* mine, std::size_t bytes, void* all) override {
    for (int r = 0; r < num_ranks_; ++r) Send(r, mine, bytes);
    for (int r = 0; r < num_ranks_; ++r) Receive(r, static_cast<char*>(all) + r * bytes, bytes);
  }
  std::unique_ptr<SharedSystem> MakeSystem() override {
    return std::make_unique<DenseSystem>(this);
  }

 private:
  const int rank_, num_ranks_;
  Post& post_;
};

}  // namespace

void RunOnThreadRanks(int num_ranks, const std::function<void(Ranks& ranks)>& body) {
  Post post;
  std::vector<std::thread> threads;
  for (int r = 0; r < num_ranks; ++r) {
    threads.emplace_back([&, r] {
      ThreadRanks ranks(r, num_ranks, &post);
      body(ranks);
    });
  }
  for (std::thread& thread : threads) thread.join();
}

}  // namespace cirque
