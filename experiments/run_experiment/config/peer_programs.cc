#include "experiments/run_experiment/config/peer_programs.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>

#include <fmt/format.h>

#include "experiments/run_experiment/config/mesh_sources.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

bool IsProgram(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
}

/// Beside this program, then in the folders of PATH.
std::optional<std::string> FindInPath(const std::string& name) {
  std::error_code error;
  std::vector<fs::path> folders = {fs::read_symlink("/proc/self/exe", error).parent_path()};
  const char* path = std::getenv("PATH");
  std::istringstream stream(path == nullptr ? "" : path);
  for (std::string folder; std::getline(stream, folder, ':');) folders.emplace_back(folder);
  for (const fs::path& folder : folders) {
    if (!folder.empty() && IsProgram(folder / name)) return (folder / name).string();
  }
  return std::nullopt;
}

std::optional<std::string> FindProgram(const std::string& root, const std::string& name) {
  if (name.find('/') == std::string::npos) return FindInPath(name);
  std::string path = AbsolutePath(root, name);
  if (!IsProgram(path)) return std::nullopt;
  return path;
}

/// Problems of a command, of which the first word is the program.
void CheckPlaces(const YAML::Node& command, Diagnostics* problems) {
  for (const std::string place : {"{in}", "{out}"}) {
    if (command.Scalar().find(place) != std::string::npos) continue;
    problems->Add(PlaceOf(command),
                  fmt::format("'command' needs {}, which stands for the {} (.obj)", place,
                              place == "{in}" ? "mesh" : "map, the mesh with texture coordinates"));
  }
}

}  // namespace

Schema PeerFields() {
  using enum FieldKind;
  return {
      {.path = "peer",
       .kind = kSections,
       .help = "other programs, which map every mesh too: methods whose maps are judged by "
               "cirque/verify, and whose times are those of the whole process",
       .list = true},
      {.path = "peer.name", .help = "its name in tables", .required = true},
      {.path = "peer.command",
       .help = "its command line, without a shell, such as bff-command-line {in} {out}: a mesh "
               "(.obj) to read, the mesh with texture coordinates (.obj) to write",
       .required = true,
       .check = [](const std::string& text) { return SplitCommand(text).status(); }},
      {.path = "peer.optional",
       .kind = kBoolean,
       .help = "whether it is left out where there is no such program",
       .default_text = "false"},
  };
}

StatusOr<std::vector<std::string>> SplitCommand(const std::string& command) {
  std::vector<std::string> words;
  bool inside = false;
  char quote = 0;
  for (const char c : command) {
    if (quote == 0 && (c == ' ' || c == '\t' || c == '\n')) {
      inside = false;
      continue;
    }
    if (!inside) words.emplace_back();
    inside = true;
    if (c == quote) {
      quote = 0;
    } else if (quote == 0 && (c == '\'' || c == '"')) {
      quote = c;
    } else {
      words.back() += c;
    }
  }
  if (quote != 0) {
    return Status::InvalidInput(fmt::format("the quote {} is not closed in: {}", quote, command));
  }
  if (words.empty() || words[0].empty()) return Status::InvalidInput("names no program");
  return words;
}

std::vector<MethodSpec> ReadPeers(const YAML::Node& value, const std::string& root,
                                  Diagnostics* problems, std::vector<std::string>* notes) {
  std::vector<MethodSpec> peers;
  for (const YAML::Node& entry : EntriesOf(value)) {
    const YAML::Node command = entry["command"];
    StatusOr<std::vector<std::string>> words = SplitCommand(command.Scalar());
    if (!words.ok()) continue;  // the schema has said so
    CheckPlaces(command, problems);
    const std::string name = entry["name"].Scalar();
    const std::optional<std::string> program = FindProgram(root, words->front());
    if (program) {
      words->front() = *program;
      peers.push_back({.name = name, .options = {}, .peer = *std::move(words)});
    } else if (TextOr(entry, "optional", "false") == "true") {
      notes->push_back(
          fmt::format("peer '{}' left out: there is no program '{}'", name, words->front()));
    } else {
      problems->Add(PlaceOf(command),
                    fmt::format("there is no program '{}' in PATH; give its path, or 'optional: "
                                "true' to leave it out",
                                words->front()));
    }
  }
  return peers;
}

}  // namespace cirque
