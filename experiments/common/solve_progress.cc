#include "experiments/common/solve_progress.h"

#include <unistd.h>

#include <fmt/format.h>

namespace cirque {
namespace {

constexpr char kEraseLine[] = "\r\033[K";
constexpr double kQuietSeconds = 1;

}  // namespace

SolveProgress::SolveProgress(std::FILE* out)
    : out_(out != nullptr && isatty(fileno(out)) != 0 ? out : nullptr) {}

IterationCallback SolveProgress::Callback() {
  return [this](const IterationRecord& record, const Eigen::VectorXd&) {
    if (timer_.Seconds() > kQuietSeconds) Draw(record);
    return CallbackAction::kContinue;
  };
}

void SolveProgress::Draw(const IterationRecord& record) {
  if (out_ == nullptr) return;
  fmt::print(out_, "{}{}", kEraseLine, ProgressText(record));
  std::fflush(out_);
  is_drawn_ = true;
}

void SolveProgress::Erase() {
  if (!is_drawn_) return;
  fmt::print(out_, "{}", kEraseLine);
  std::fflush(out_);
  is_drawn_ = false;
}

std::string ProgressText(const IterationRecord& record) {
  return fmt::format("iteration {}, gradient {:.1e}, {:.1f} s", record.iteration,
                     record.gradient_max, record.seconds);
}

}  // namespace cirque
