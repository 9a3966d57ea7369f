// Audits every registered energy: derivatives, digits, convexity, agreement of its forms, domain.
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/atomic_file.h"

#include "experiments/audit_energies/audit.h"
#include "experiments/common/flag_parsing.h"
#include "experiments/common/manual.h"
#include "experiments/common/program.h"

DEFINE_string(json, "", "write the findings as JSON too; without =FILE, print it instead");

namespace cirque::audit_energies {
namespace {

constexpr int kSound = 0, kUnsound = 1, kBadInput = 2;

Manual ProgramManual() {
  return {"audit_energies",
          "checks every registered energy at usual and at fragile points",
          {{"[FLAGS]", "a table of energy x check: 'ok' or the worst figure"}},
          {},
          {{"0", "all is well"}, {"1", "a check failed"}, {"2", "bad input"}}};
}

int Complain(const Status& status) {
  fmt::print(stderr, "audit_energies: {}\n", status.message());
  return kBadInput;
}

int Main(int argc, char** argv) {
  CommandLine line = GflagsOf("experiments/audit_energies/", {"json"});
  const auto others = line.Parse({argv + 1, argv + argc});
  if (!others.ok()) return Complain(others.status());
  if (const auto answered = AnswerQuestions(ProgramManual(), line, *others)) return *answered;
  if (!others->empty()) {
    return Complain(Status::InvalidInput("unexpected argument '" + others->front() +
                                         "'; the program takes flags only"));
  }
  const std::vector<AuditRow> rows = AuditRegistry(Energies(), Samples());
  fmt::print("{}", FLAGS_json == "-" ? ToJson(rows) : ToText(rows));
  if (!FLAGS_json.empty() && FLAGS_json != "-") {
    if (const Status s = WriteFileAtomically(FLAGS_json, ToJson(rows)); !s.ok()) return Complain(s);
  }
  return AllOk(rows) ? kSound : kUnsound;
}

}  // namespace
}  // namespace cirque::audit_energies

int main(int argc, char** argv) {
  return cirque::RunMain("audit_energies", argc, argv, cirque::audit_energies::Main);
}
