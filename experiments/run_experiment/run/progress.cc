#include "experiments/run_experiment/run/progress.h"

#include <unistd.h>

#include <fmt/format.h>

namespace cirque {
namespace {

constexpr char kEraseLine[] = "\r\033[K";

double TotalSeconds(const Record& record) {
  const nlohmann::json::json_pointer pointer("/seconds/total");
  return record.contains(pointer) ? record.at(pointer).get<double>() : 0;
}

}  // namespace

Progress::Progress(std::FILE* out, int total, int reused)
    : out_(out),
      is_terminal_(out != nullptr && isatty(fileno(out)) != 0),
      total_(total),
      reused_(reused) {}

void Progress::Start(const std::string& label) {
  if (!is_terminal_) return;
  fmt::print(out_, "{}{}; {} ...", kEraseLine, State(), label);
  std::fflush(out_);
}

void Progress::Finish(const std::string& label, const Record& record) {
  ++done_;
  if (!IsSettled(record)) ++failed_;
  if (out_ == nullptr) return;
  const std::string message = record.value("message", "");
  fmt::print(out_, "{}[{}/{}] {}: {}, {:.2f} s{}\n", is_terminal_ ? kEraseLine : "",
             reused_ + done_, total_, label, OutcomeOf(record), TotalSeconds(record),
             message.empty() ? "" : "; " + message.substr(0, message.find('\n')));
  if (is_terminal_ && reused_ + done_ < total_) fmt::print(out_, "{}", State());
  std::fflush(out_);
}

std::string Progress::State() const {
  const int left = total_ - reused_ - done_;
  std::string text = fmt::format("{} done, {} failed, {} left", reused_ + done_, failed_, left);
  // Runs side by side need no count of them: this is how fast they end together.
  if (done_ > 0) text += fmt::format(", about {:.0f} s", timer_.Seconds() / done_ * left);
  return text;
}

}  // namespace cirque
