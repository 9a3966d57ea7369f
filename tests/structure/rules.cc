#include "tests/structure/rules.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

#include "tests/common/paths.h"
#include "tests/structure/code_text.h"

namespace cirque {
namespace {

constexpr int kMostLines = 500;
constexpr int kMostLinesOfAFunction = 100;

// The folders of framework/docs/floors.txt, each with its floor; the headers for users lie on top.
std::map<std::string, int> ReadFloors() {
  std::map<std::string, int> floors;
  std::ifstream file(ProjectPath("framework/docs/floors.txt"));
  std::string line;
  int floor = 0;
  while (std::getline(file, line)) {
    if (line.empty() || line.starts_with("#")) continue;
    std::istringstream folders(line);
    for (std::string folder; folders >> folder;) floors[folder] = floor;
    ++floor;
  }
  floors["cirque.h"] = floors["openmesh.h"] = floor;
  return floors;
}

// The floor of a folder of framework/cirque; folders of one floor are siblings.
std::optional<int> Floor(const std::string& folder) {
  static const std::map<std::string, int> kFloors = ReadFloors();
  const auto found = kFloors.find(folder);
  if (found == kFloors.end()) return std::nullopt;
  return found->second;
}

// The first three components of a path, empty where there is none.
std::array<std::string, 3> Head(const std::string& path) {
  std::array<std::string, 3> head;
  std::istringstream stream(path);
  for (std::string& part : head) std::getline(stream, part, '/');
  return head;
}

// Whether a folder must not include a lower one: numerics see arrays only, and the judge of maps
// shares no code with what makes them.
bool IsForbidden(const std::string& folder, const std::string& target) {
  static const std::set<std::string> kNumerics = {"energy", "solver", "audit"};
  static const std::set<std::string> kSurfaces = {"mesh", "generators"};
  static const std::set<std::string> kOfTheJudge = {"core", "math", "io"};
  if (folder == "verify") return !kOfTheJudge.contains(target);
  return kNumerics.contains(folder) && kSurfaces.contains(target);
}

// Why a file of framework/cirque/`folder` must not include "cirque/`target`/..."; empty when it may.
std::string FloorFault(const std::string& folder, const std::string& target) {
  const auto from = Floor(folder);
  const auto to = Floor(target);
  if (!from) return fmt::format("folder '{}' has no floor in the design", folder);
  if (!to) return fmt::format("includes '{}', which has no floor in the design", target);
  if (folder == target) return "";
  if (IsForbidden(folder, target)) return fmt::format("{} includes {}", folder, target);
  if (*to > *from) return fmt::format("{} includes {}, which lies above it", folder, target);
  if (*to == *from) return fmt::format("{} includes its sibling {}", folder, target);
  return "";
}

// Why a leaf (experiments, bench, tests) must not include `target`, a path from the top.
std::string LeafFault(const std::string& path, const std::string& target) {
  const auto [leaf, folder, file] = Head(path);
  const auto [target_leaf, target_folder, target_file] = Head(target);
  if (leaf == "tests" || leaf == target_leaf) {
    const bool is_other_program =
        leaf == "experiments" && target_folder != folder && target_folder != "common";
    return is_other_program ? fmt::format("program {} includes program {}", folder, target_folder)
                            : "";
  }
  return fmt::format("{} includes {}, a leaf", leaf, target_leaf);
}

bool IsLeaf(const std::string& folder) {
  return folder == "experiments" || folder == "bench" || folder == "tests";
}

std::string IncludeFault(const std::string& path, const std::string& line) {
  static const std::regex kInclude(R"re(^\s*#\s*include\s*["<]([^">]+)[">])re");
  std::smatch match;
  if (!std::regex_search(line, match, kInclude)) return "";
  const std::string target = match[1];
  const auto [top, package, folder] = Head(path);
  const auto [target_top, target_folder, target_file] = Head(target);
  if (top == "framework" && target == "iostream") return "the framework does not print";
  // Python's module stands above all floors.
  if (top == "framework" && package == "python" && target_top == "cirque") return "";
  if (top == "framework" && target_top == "cirque") return FloorFault(folder, target_folder);
  if (IsLeaf(target_top)) return LeafFault(path, target);
  return "";
}

// Faults of a line of C++ wherever it stands.
std::string LineFault(const std::string& path, const std::string& line) {
  static const std::regex kPrints(
      R"re(\b(f?printf|f?puts|putchar|fmt::print)\s*\(|std::(cout|cerr|clog)\b)re");
  // Spelt apart so that this line obeys itself.
  static const std::regex kDeferred(
      "\\b(TO"
      "DO|FIX"
      "ME|XX"
      "X|HA"
      "CK)\\b");
  if (std::regex_search(line, kDeferred)) return "work is deferred in a comment";
  const std::string code = line.substr(0, line.find("//"));
  if (path.starts_with("framework/") && std::regex_search(code, kPrints)) {
    return "the framework does not print";
  }
  return IncludeFault(path, line);
}

bool IsSource(const std::filesystem::path& path) {
  static constexpr std::array<std::string_view, 4> kExtensions = {".h", ".cc", ".cmake", ".sh"};
  return path.filename() == "CMakeLists.txt" ||
         std::find(kExtensions.begin(), kExtensions.end(), path.extension()) != kExtensions.end();
}

// Production code is framework, experiments and bench; a test may read as one long story.
std::vector<std::string> LongFunctions(const std::string& path, const std::string& text) {
  std::vector<std::string> violations;
  if (path.starts_with("tests/") || !(path.ends_with(".h") || path.ends_with(".cc"))) return {};
  for (const FunctionSpan& f : FunctionsOf(text)) {
    if (f.num_lines <= kMostLinesOfAFunction) continue;
    violations.push_back(fmt::format("{}:{}: a function of {} lines, more than {}", path,
                                     f.first_line, f.num_lines, kMostLinesOfAFunction));
  }
  return violations;
}

}  // namespace

std::vector<std::string> Violations(const std::string& path, const std::string& text) {
  std::vector<std::string> violations = LongFunctions(path, text);
  std::istringstream stream(text);
  std::string line;
  int count = 0;
  while (std::getline(stream, line)) {
    ++count;
    const std::string fault = LineFault(path, line);
    if (!fault.empty()) violations.push_back(fmt::format("{}:{}: {}", path, count, fault));
  }
  if (count > kMostLines) {
    violations.push_back(fmt::format("{}:{}: longer than {} lines", path, count, kMostLines));
  }
  if (path.ends_with(".h") && !text.starts_with("#pragma once\n")) {
    violations.push_back(path + ":1: a header begins with #pragma once");
  }
  return violations;
}

std::vector<std::string> SourceFiles(const std::string& project) {
  std::vector<std::string> files;
  for (const char* folder : {"framework", "experiments", "bench", "tests"}) {
    const std::filesystem::path top = std::filesystem::path(project) / folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(top)) {
      if (!entry.is_regular_file() || !IsSource(entry.path())) continue;
      files.push_back(std::filesystem::relative(entry.path(), project).string());
    }
  }
  return files;
}

}  // namespace cirque
