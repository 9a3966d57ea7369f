#include "experiments/common/solve_progress.h"

#include <unistd.h>

#include <chrono>

#include <fmt/format.h>

namespace cirque {
namespace {

constexpr char kEraseLine[] = "\r\033[K";
constexpr std::chrono::milliseconds kTick(250);

}  // namespace

/// Hands whole lines on.
class SolveProgress::ReportBuffer : public std::streambuf {
 public:
  ReportBuffer(SolveProgress* progress, std::ostream* out) : progress_(*progress), out_(*out) {}

 protected:
  int_type overflow(int_type c) override {
    if (c == traits_type::eof()) return traits_type::not_eof(c);
    line_ += traits_type::to_char_type(c);
    return line_.back() != '\n' || sync() == 0 ? c : traits_type::eof();
  }

  int sync() override {
    const std::lock_guard lock(progress_.mutex_);
    progress_.EraseLocked();
    out_ << line_ << std::flush;
    line_.clear();
    return out_.good() ? 0 : -1;
  }

 private:
  SolveProgress& progress_;
  std::ostream& out_;
  std::string line_;
};

SolveProgress::SolveProgress(std::FILE* out)
    : out_(out != nullptr && isatty(fileno(out)) != 0 ? out : nullptr) {
  if (out_ != nullptr) ticker_ = std::jthread([this](std::stop_token stop) { Tick(stop); });
}

SolveProgress::~SolveProgress() {
  ticker_.request_stop();
  if (ticker_.joinable()) ticker_.join();
  Erase();
}

void SolveProgress::Tick(std::stop_token stop) {
  while (true) {
    {
      std::unique_lock lock(mutex_);
      woken_.wait_for(lock, stop, kTick, [] { return false; });
    }
    if (stop.stop_requested()) return;
    Draw();
  }
}

SolveControl SolveProgress::Control(const std::atomic<bool>* cancelled) {
  SolveControl control;
  control.cancelled = cancelled;
  if (out_ == nullptr) return control;
  control.callback = [this](const IterationRecord& record, const Eigen::VectorXd&) {
    Note(record);
    return CallbackAction::kContinue;
  };
  control.on_stage = [this](std::string_view stage) { Begin(stage); };
  return control;
}

std::streambuf* SolveProgress::Before(std::ostream& out) {
  report_ = std::make_unique<ReportBuffer>(this, &out);
  return report_.get();
}

void SolveProgress::Begin(std::string_view stage) {
  const std::lock_guard lock(mutex_);
  stage_ = stage;
  record_.reset();
}

void SolveProgress::Note(const IterationRecord& record) {
  const std::lock_guard lock(mutex_);
  record_ = record;
}

void SolveProgress::Draw() {
  if (out_ == nullptr) return;
  const std::lock_guard lock(mutex_);
  const IterationRecord* record = record_ ? &*record_ : nullptr;
  fmt::print(out_, "{}{}", kEraseLine, ProgressText(stage_, record, timer_.Seconds()));
  std::fflush(out_);
  is_drawn_ = true;
}

void SolveProgress::Erase() {
  const std::lock_guard lock(mutex_);
  EraseLocked();
}

void SolveProgress::EraseLocked() {
  if (!is_drawn_) return;
  fmt::print(out_, "{}", kEraseLine);
  std::fflush(out_);
  is_drawn_ = false;
}

std::string ProgressText(std::string_view stage, const IterationRecord* record, double seconds) {
  std::string text(stage);
  if (record != nullptr) {
    text += fmt::format(", iteration {}, gradient {:.1e}", record->iteration, record->gradient_max);
  }
  return text + fmt::format(", {:.1f} s", seconds);
}

}  // namespace cirque
