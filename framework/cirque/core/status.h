#pragma once

#include <optional>
#include <string>
#include <utility>

namespace cirque {

/// What kind of outcome an operation had. A broken caller is none of these: that is a CHECK.
enum class StatusCode {
  kOk,
  kInvalidInput,  ///< file, config, mesh or cone list: the message says what, where and what to do
  kInfeasible,    ///< it is proven that no solution exists; a certificate goes with it
  kUnrepresentable,  ///< a solution exists but exceeds what doubles hold in one chart
  kNotConverged,     ///< a limit of iterations or time, or of floating point, was met first
  kCancelled,        ///< the caller asked to stop
  kResource,         ///< the machine failed: a full or failing disk, no memory; again may help
};

/// The outcome of an operation that can fail for a reason its caller should tell the user.
class [[nodiscard]] Status {
 public:
  Status() = default;
  Status(StatusCode code, std::string message) : code_(code), message_(std::move(message)) {}

  static Status InvalidInput(std::string message) {
    return {StatusCode::kInvalidInput, std::move(message)};
  }

  bool ok() const { return code_ == StatusCode::kOk; }
  StatusCode code() const { return code_; }
  const std::string& message() const { return message_; }

  /// The same outcome, its message led by `where` and ": ".
  Status In(const std::string& where) const;

 private:
  StatusCode code_ = StatusCode::kOk;
  std::string message_;
};

/// "ok", "invalid_input", ...: the word used in records and tables.
std::string ToString(StatusCode code);

/// The process exit status of a program that ends with this code: 0 ok, 1 not converged or
/// cancelled, 2 invalid input or a failing machine, 3 infeasible, 4 unrepresentable.
int ExitStatus(StatusCode code);

/// A value, or the status that says why there is none.
template <class T>
class [[nodiscard]] StatusOr {
 public:
  StatusOr(T value) : value_(std::move(value)) {}          // NOLINT(google-explicit-constructor)
  StatusOr(Status status) : status_(std::move(status)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return value_.has_value(); }
  const Status& status() const { return status_; }
  T& operator*() & { return *value_; }
  const T& operator*() const& { return *value_; }
  T&& operator*() && { return *std::move(value_); }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }

 private:
  Status status_;
  std::optional<T> value_;
};

}  // namespace cirque
