#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace cirque {

class SharedSystem;

/// The processes that mpirun has started, as one of them sees them. Every function is collective
/// unless it says otherwise: all ranks call it in the same order with the same arguments but for
/// what is theirs. Nothing depends on timing. An error on one rank ends the processes of all.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int num_ranks() const = 0;

  /// The first rank's bytes, to all.
  virtual void Broadcast(void* data, std::size_t bytes) = 0;

  /// From one rank to another, which receives as many. Of these two alone.
  virtual void Send(int to, const void* data, std::size_t bytes) = 0;
  virtual void Receive(int from, void* data, std::size_t bytes) = 0;

  /// Sends to one rank what it receives of this one, and receives of another what that one sends.
  virtual void SendReceive(int to, const void* sent, std::size_t sent_bytes, int from,
                           void* received, std::size_t received_bytes) = 0;

  /// The bytes of all ranks, in their order, on each of them.
  virtual void AllGather(const void* mine, std::size_t bytes, void* all) = 0;

  /// A linear system whose rows are distributed: rank r has those behind rank r - 1's.
  virtual std::unique_ptr<SharedSystem> MakeSystem() = 0;

  template <class T>
  std::vector<T> AllOf(const T& mine) {
    std::vector<T> all(num_ranks());
    AllGather(&mine, sizeof(T), all.data());
    return all;
  }

  /// Added in the order of the ranks.
  double Sum(double mine) {
    double sum = 0;
    for (const double x : AllOf(mine)) sum += x;
    return sum;
  }

  /// On any rank.
  double Largest(double mine) {
    const std::vector<double> all = AllOf(mine);
    return *std::max_element(all.begin(), all.end());
  }

  /// Whether it is so on every rank.
  bool All(bool mine) { return Sum(mine ? 0 : 1) == 0; }

  /// Arrays with their lengths; of two ranks alone, as Send and Receive.
  template <class T>
  void SendArray(int to, const std::vector<T>& values) {
    const std::size_t size = values.size();
    Send(to, &size, sizeof(size));
    if (size > 0) Send(to, values.data(), size * sizeof(T));
  }
  template <class T>
  std::vector<T> ReceiveArray(int from) {
    std::size_t size = 0;
    Receive(from, &size, sizeof(size));
    std::vector<T> values(size);
    if (size > 0) Receive(from, values.data(), size * sizeof(T));
    return values;
  }
};

/// Work that the ranks share, each with a part of its own.
class RankWork {
 public:
  virtual ~RankWork() = default;

  /// One of its tasks. Collective.
  virtual void Do(int task) = 0;
};

/// Makes one rank's part. Collective.
using RankWorkFactory = std::function<std::unique_ptr<RankWork>(Ranks& ranks)>;

/// What the ranks of a program know to do, by name.
using RankWorks = std::map<std::string, RankWorkFactory>;

}  // namespace cirque
