// Studies of single questions, each a subcommand: what experiments on meshes and methods cannot ask.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/text.h"
#include "cirque/linear/blas_threads.h"

#include "experiments/common/flag_parsing.h"
#include "experiments/common/manual.h"
#include "experiments/common/program.h"
#include "experiments/studies/studies.h"

namespace cirque {
namespace {

constexpr char kSource[] = "experiments/studies/";
constexpr char kCommonSource[] = "experiments/studies/studies.cc";

Manual ProgramManual() {
  Manual manual = {
      "studies",
      "answers single questions that experiments on meshes and methods cannot ask",
      {{"NAME [FLAGS] [MESH ...]", "one study"}, {"NAME --help", "what it asks, and its flags"}},
      {},
      {{"0", "done"}, {"1", "interrupted"}, {"2", "bad input"}, {"3", "infeasible"}}};
  for (const Study& study : Studies()) manual.rules.push_back(study.name + ": " + study.what);
  return manual;
}

/// Of one study.
std::string Usage(const Study& study) {
  std::vector<CommandLine::Flag> flags;
  for (const std::string& source : {study.source, std::string(kCommonSource)}) {
    const CommandLine line = GflagsOf(source);
    flags.insert(flags.end(), line.flags().begin(), line.flags().end());
  }
  std::erase_if(flags, [](const auto& flag) { return !flag.info.group.empty(); });
  return fmt::format("studies {} {}\n{}\n\n{}", study.name, study.usage, study.what,
                     FlagHelp(flags));
}

int Complain(const std::string& name, const Status& status) {
  if (!status.ok()) fmt::print(stderr, "{}: {}\n", name, status.message());
  return ExitStatus(status.code());
}

StatusOr<const Study*> FindStudy(const std::string& name) {
  std::vector<std::string> names;
  for (const Study& study : Studies()) {
    if (study.name == name) return &study;
    names.push_back(study.name);
  }
  return Status::InvalidInput(UnknownName("study", name, names));
}

/// The program knows the flags of all studies; those of another one would say nothing here.
Status CheckFlags(const Study& study) {
  std::vector<gflags::CommandLineFlagInfo> all;
  gflags::GetAllFlags(&all);
  for (const gflags::CommandLineFlagInfo& flag : all) {
    const bool foreign = flag.filename.find(kSource) != std::string::npos &&
                         flag.filename.find(kCommonSource) == std::string::npos &&
                         flag.filename.find(study.source) == std::string::npos;
    if (flag.is_default || !foreign) continue;
    return Status::InvalidInput(fmt::format("--{} is no flag of {}; see studies {} --help",
                                            flag.name, study.name, study.name));
  }
  return Status();
}

std::string CommandOf(int argc, char** argv) {
  std::string command = "studies";
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (!argument.starts_with("--json")) command += " " + argument;
  }
  return command;
}

int Main(int argc, char** argv) {
  CommandLine line = GflagsOf(kSource);
  StatusOr<std::vector<std::string>> words = line.Parse({argv + 1, argv + argc});
  if (!words.ok()) return Complain("studies", words.status());
  if (words->empty() || line.IsGiven("version")) {
    if (const auto answered = AnswerQuestions(ProgramManual(), line, *words)) return *answered;
    return Complain("studies", Status::InvalidInput("which study? See studies --help"));
  }
  const StatusOr<const Study*> study = FindStudy(words->front());
  if (!study.ok()) return Complain("studies", study.status());
  if (line.help_topic()) {
    fmt::print("{}", Usage(**study));
    return 0;
  }
  words->erase(words->begin());
  Status status = CheckFlags(**study);
  if (status.ok()) status = (*study)->run({*words, CommandOf(argc, argv)});
  return Complain("studies " + (*study)->name, status);
}

}  // namespace
}  // namespace cirque

int main(int argc, char** argv) { return cirque::RunMain("studies", argc, argv, cirque::Main); }
