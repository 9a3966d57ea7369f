// Makes a libFuzzer program of a table of targets, the function CIRQUE_FUZZ_TARGETS:
//   PROGRAM --target=NAME [flags of libFuzzer] [CORPUS ...]
//   PROGRAM --list             the names of its targets
//   PROGRAM --sources=NAME     where that target's parser stands, a beginning of paths a line
//   PROGRAM --prepare=FOLDER   writes the dictionaries FOLDER/NAME.dict, the seeds FOLDER/NAME/
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "cirque/core/atomic_file.h"

#include "tests/fuzz/fuzz_target.h"

namespace cirque::testing {
namespace {

namespace fs = std::filesystem;

const std::vector<FuzzTarget>& Targets() {
  static const std::vector<FuzzTarget> targets = CIRQUE_FUZZ_TARGETS();
  return targets;
}

/// The one of the command line; found once, before the first input.
const FuzzTarget*& Chosen() {
  static const FuzzTarget* chosen = nullptr;
  return chosen;
}

[[noreturn]] void Fail(const std::string& message) {
  fmt::print(stderr, "{}\n", message);
  std::exit(2);
}

void Write(const fs::path& path, const std::string& content) {
  const Status status = WriteFileAtomically(path.string(), content);
  if (!status.ok()) Fail(status.message());
}

/// As libFuzzer reads dictionaries: quoted, every byte by its number.
std::string Dictionary(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += '"';
    for (const char c : word) text += fmt::format("\\x{:02X}", static_cast<unsigned char>(c));
    text += "\"\n";
  }
  return text;
}

void Prepare(const fs::path& folder) {
  for (const FuzzTarget& target : Targets()) {
    fs::create_directories(folder / target.name);
    Write(folder / (target.name + ".dict"), Dictionary(target.words));
    for (std::size_t i = 0; i < target.seeds.size(); ++i) {
      Write(folder / target.name / fmt::format("seed-{}", i + 1), target.seeds[i]);
    }
  }
}

void Choose(std::string_view name) {
  for (const FuzzTarget& target : Targets()) {
    if (target.name == name) Chosen() = &target;
  }
  if (!Chosen()) Fail(fmt::format("no target '{}'; --list names them", name));
}

void Read(std::string_view argument) {
  constexpr std::string_view kTarget = "--target=", kPrepare = "--prepare=",
                             kSources = "--sources=";
  if (argument.starts_with(kTarget)) return Choose(argument.substr(kTarget.size()));
  if (argument.starts_with(kSources)) {
    Choose(argument.substr(kSources.size()));
    for (const std::string& beginning : Chosen()->sources) fmt::print("{}\n", beginning);
    std::exit(0);
  }
  if (argument == "--list") {
    for (const FuzzTarget& target : Targets()) fmt::print("{}\n", target.name);
    std::exit(0);
  }
  if (argument.starts_with(kPrepare)) {
    Prepare(argument.substr(kPrepare.size()));
    std::exit(0);
  }
}

}  // namespace
}  // namespace cirque::testing

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  for (int i = 1; i < *argc; ++i) cirque::testing::Read((*argv)[i]);
  if (!cirque::testing::Chosen()) cirque::testing::Fail("which --target=NAME?");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  cirque::testing::Chosen()->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
