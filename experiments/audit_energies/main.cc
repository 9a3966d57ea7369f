// Audits every registered energy: derivatives, digits, convexity, agreement of its forms, domain.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/atomic_file.h"

#include "experiments/audit_energies/audit.h"
#include "experiments/common/flag_parsing.h"
#include "experiments/common/program.h"

DEFINE_string(json, "", "write the findings as JSON too; without =FILE, print it instead");
DECLARE_bool(help);

namespace cirque::audit_energies {
namespace {

constexpr int kSound = 0, kUnsound = 1, kBadInput = 2;

const char kUsage[] =
    "Audits every registered energy at usual and at fragile points and prints a table: energy x "
    "check,\n\"ok\" or the worst figure. Exit status: 0 all is well, 1 a check failed, 2 bad "
    "input.\n";

int Complain(const Status& status) {
  fmt::print(stderr, "audit_energies: {}\n", status.message());
  return kBadInput;
}

int Main(int argc, char** argv) {
  // The one flag whose value may be left out.
  std::vector<std::string> words(argv, argv + argc);
  std::replace(words.begin(), words.end(), std::string("--json"), std::string("--json=-"));
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  const auto others = ParseFlags(argc, pointers.data(), "experiments/audit_energies/");
  if (!others.ok()) return Complain(others.status());
  if (!others->empty()) {
    return Complain(Status::InvalidInput("unexpected argument '" + others->front() +
                                         "'; the program takes flags only"));
  }
  if (FLAGS_help) {
    fmt::print("{}{}", kUsage, FlagHelp("experiments/audit_energies/"));
    return kSound;
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
