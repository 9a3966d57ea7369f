#include "cirque/core/status.h"

namespace cirque {

Status Status::In(const std::string& where) const {
  return ok() ? *this : Status(code_, where + ": " + message_);
}

std::string ToString(StatusCode code) {
  switch (code) {
    case StatusCode::kOk:
      return "ok";
    case StatusCode::kInvalidInput:
      return "invalid_input";
    case StatusCode::kInfeasible:
      return "infeasible";
    case StatusCode::kUnrepresentable:
      return "unrepresentable";
    case StatusCode::kNotConverged:
      return "not_converged";
    case StatusCode::kCancelled:
      return "cancelled";
    case StatusCode::kResource:
      return "resource";
  }
  return "unknown";
}

int ExitStatus(StatusCode code) {
  switch (code) {
    case StatusCode::kOk:
      return 0;
    case StatusCode::kInvalidInput:
    case StatusCode::kResource:
      return 2;
    case StatusCode::kInfeasible:
      return 3;
    case StatusCode::kUnrepresentable:
      return 4;
    case StatusCode::kNotConverged:
    case StatusCode::kCancelled:
      return 1;
  }
  return 1;
}

}  // namespace cirque
