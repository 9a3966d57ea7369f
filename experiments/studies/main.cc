// Studies of single questions, each a subcommand: what experiments on meshes and methods cannot ask.
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gflags/gflags.h>

#include "cirque/core/text.h"

#include "experiments/common/blas_threads.h"
#include "experiments/common/flag_parsing.h"
#include "experiments/common/program.h"
#include "experiments/studies/studies.h"

DECLARE_bool(help);

namespace cirque {
namespace {

constexpr char kSource[] = "experiments/studies/";
constexpr char kCommonSource[] = "experiments/studies/studies.cc";

/// Every line but the first begins with so many blanks.
std::string Indented(const std::string& text, int blanks) {
  std::string indented;
  for (const char c : text) {
    indented += c;
    if (c == '\n') indented.append(static_cast<std::size_t>(blanks), ' ');
  }
  return indented;
}

std::string Usage() {
  std::string text =
      "studies NAME [FLAGS] [MESH ...]\n"
      "Each study asks one question; studies NAME --help explains it and its flags.\n"
      "Exit status: 0 done, 1 interrupted, 2 bad input, 3 infeasible.\n\n";
  for (const Study& study : Studies()) {
    text += fmt::format("  {}\n      {}\n", study.name, Indented(study.what, 6));
  }
  return text;
}

std::string Usage(const Study& study) {
  return fmt::format("studies {} {}\n{}\n\n{}{}", study.name, study.usage, study.what,
                     FlagHelp(study.source), FlagHelp(kCommonSource));
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
  StatusOr<std::vector<std::string>> words = ParseFlags(argc, argv, kSource);
  if (!words.ok()) return Complain("studies", words.status());
  if (words->empty()) {
    if (!FLAGS_help) {
      return Complain("studies", Status::InvalidInput("which study? See studies --help"));
    }
    fmt::print("{}", Usage());
    return 0;
  }
  const StatusOr<const Study*> study = FindStudy(words->front());
  if (!study.ok()) return Complain("studies", study.status());
  if (FLAGS_help) {
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
