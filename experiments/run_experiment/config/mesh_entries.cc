#include <glob.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "cirque/generators/known_maps.h"

#include "experiments/run_experiment/config/config_text.h"
#include "experiments/run_experiment/config/entries.h"
#include "experiments/run_experiment/config/file_content.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

std::string TextOf(const YAML::Node& entry, const std::string& key) {
  const YAML::Node value = entry[key];
  return value && value.IsScalar() ? value.Scalar() : "";
}

/// The folder that $MESHES stands for: collections of meshes lie elsewhere on every machine.
fs::path MeshFolder(const std::string& root) {
  const char* folder = std::getenv("CIRQUE_MESHES");
  return folder && *folder ? fs::absolute(folder) : fs::path(root) / "meshes";
}

std::string Absolute(const std::string& root, const std::string& path) {
  constexpr std::string_view kMeshes = "$MESHES/";
  const fs::path whole = path.starts_with(kMeshes) ? MeshFolder(root) / path.substr(kMeshes.size())
                                                   : fs::path(root) / path;
  return whole.lexically_normal().string();
}

/// The files that match, sorted; a path without wildcards matches itself if it exists.
std::vector<std::string> MatchFiles(const std::string& pattern) {
  std::vector<std::string> files;
  std::error_code error;  // of links that lead in a circle
  glob_t matches{};
  if (glob(pattern.c_str(), 0, nullptr, &matches) == 0) {
    for (std::size_t i = 0; i < matches.gl_pathc; ++i) {
      if (fs::is_regular_file(matches.gl_pathv[i], error)) files.emplace_back(matches.gl_pathv[i]);
    }
  }
  globfree(&matches);
  if (files.empty() && fs::is_regular_file(pattern, error)) files.push_back(pattern);
  return files;
}

/// A text that the schema has refused says nothing.
void Subdivide(const std::string& text, MeshSpec* mesh) {
  mesh->subdivisions = static_cast<int>(ParseInteger(text).value_or(0));
  if (mesh->subdivisions > 0) mesh->name += fmt::format("-sub{}", mesh->subdivisions);
}

class Resolver {
 public:
  Resolver(std::string root, std::vector<std::string> seeds, Diagnostics* problems)
      : root_(std::move(root)), seeds_(std::move(seeds)), problems_(*problems) {}

  void Add(const YAML::Node& entry);
  MeshEntries Take() { return std::move(result_); }

 private:
  void AddFiles(const YAML::Node& entry);
  void AddMember(const YAML::Node& entry);
  void AddGenerated(const YAML::Node& entry);
  void AddMissing(const YAML::Node& entry, const YAML::Node& value, const std::string& path);
  void AddFinenesses(const MeshSpec& mesh, const YAML::Node& entry);
  void AddMesh(MeshSpec mesh, const YAML::Node& entry);
  void NoteWithoutSeeds(const YAML::Node& entry);
  std::vector<Axis> GeneratorAxes(const YAML::Node& entry);

  std::string root_;
  std::vector<std::string> seeds_;
  Diagnostics& problems_;
  std::map<std::string, Place> first_of_name_;
  MeshEntries result_;
};

void Resolver::Add(const YAML::Node& entry) {
  if (!entry.IsMap()) return;
  if (!TextOf(entry, "file").empty()) AddFiles(entry);
  if (!TextOf(entry, "archive").empty() && !TextOf(entry, "member").empty()) AddMember(entry);
  if (!TextOf(entry, "generator").empty()) AddGenerated(entry);
}

void Resolver::AddFiles(const YAML::Node& entry) {
  const std::string path = Absolute(root_, TextOf(entry, "file"));
  const std::vector<std::string> files = MatchFiles(path);
  if (files.empty()) return AddMissing(entry, entry["file"], path);
  const std::string name = TextOf(entry, "name");
  for (const std::string& file : files) {
    MeshSpec mesh;
    mesh.name = name.empty() ? fs::path(file).stem().string() : name;
    if (files.size() > 1 && !name.empty())
      mesh.name += fmt::format("-{}", fs::path(file).stem().string());
    mesh.file = file;
    mesh.family = mesh.name;
    AddFinenesses(mesh, entry);
  }
  NoteWithoutSeeds(entry);
}

void Resolver::AddMember(const YAML::Node& entry) {
  MeshSpec mesh;
  mesh.archive = Absolute(root_, TextOf(entry, "archive"));
  mesh.member = TextOf(entry, "member");
  const std::string name = TextOf(entry, "name");
  mesh.family = mesh.name = name.empty() ? fs::path(mesh.member).stem().string() : name;
  std::error_code error;
  if (!fs::is_regular_file(mesh.archive, error)) {
    return AddMissing(entry, entry["archive"], mesh.archive);
  }
  if (const Status status = FindArchiveMember(mesh.archive, mesh.member); !status.ok()) {
    return problems_.Add(PlaceOf(entry["member"]), status.message());
  }
  AddFinenesses(mesh, entry);
  NoteWithoutSeeds(entry);
}

/// The mesh with every number of subdivisions that the entry lists.
void Resolver::AddFinenesses(const MeshSpec& mesh, const YAML::Node& entry) {
  std::vector<Axis> axes = AxesOf(entry, ConfigSchema(), "meshes");
  std::erase_if(axes, [](const Axis& axis) { return axis.key != "subdivisions"; });
  for (const Combination& combination : Combine(axes)) {
    MeshSpec fine = mesh;
    for (const auto& setting : combination.settings) Subdivide(setting.value, &fine);
    AddMesh(std::move(fine), entry);
  }
}

void Resolver::NoteWithoutSeeds(const YAML::Node& entry) {
  if (seeds_.empty()) return;
  result_.notes.push_back(
      fmt::format("{}: run without seeds: nothing of a mesh that is not "
                  "generated is random",
                  problems_.Locate(PlaceOf(entry))));
}

/// Those of the entry, with the seeds that hold for all.
std::vector<Axis> Resolver::GeneratorAxes(const YAML::Node& entry) {
  std::vector<Axis> axes = AxesOf(entry, ConfigSchema(), "meshes");
  if (seeds_.empty()) return axes;
  if (const YAML::Node own = entry["seed"]) {
    problems_.Add(PlaceOf(own),
                  "'seeds' makes every generated mesh with its own seeds: remove one "
                  "of 'seed' and 'seeds'");
    return axes;
  }
  axes.push_back({"seed", seeds_});
  return axes;
}

void Resolver::AddGenerated(const YAML::Node& entry) {
  const std::vector<Axis> axes = GeneratorAxes(entry);
  const std::string name = TextOf(entry, "name");
  for (const Combination& combination : Combine(axes)) {
    MeshSpec mesh;
    mesh.generator = TextOf(entry, "generator");
    mesh.family = mesh.name = name.empty() ? mesh.generator : name;
    for (const auto& [key, text, varies] : combination.settings) {
      if (key == "boundary") {
        mesh.known_boundary = text == "known_map";
        if (mesh.known_boundary && !KnownConformalMaps().Find(mesh.generator).ok()) {
          return problems_.Add(PlaceOf(entry["boundary"]),
                               "no conformal map of " + mesh.generator + " is known");
        }
        if (varies || mesh.known_boundary) mesh.name += "-" + text;
        continue;
      }
      if (key == "subdivisions") {
        Subdivide(text, &mesh);
        continue;
      }
      const std::optional<long long> value = ParseInteger(text);
      if (!value) return;  // The schema has refused it.
      if (key == "triangles") mesh.generator_options.triangles = static_cast<Index>(*value);
      if (key == "seed") mesh.generator_options.seed = static_cast<unsigned>(*value);
      if (varies || name.empty()) {
        mesh.name += fmt::format("-{}{}", key == "seed" ? "s" : "", text);
      }
    }
    if (mesh.known_boundary && mesh.subdivisions > 0) {
      problems_.Add(PlaceOf(entry["subdivisions"]),
                    "midpoints do not lie on the smooth surface, so that no conformal map of them "
                    "is known: leave out 'boundary: known_map'");
    }
    AddMesh(std::move(mesh), entry);
  }
}

void Resolver::AddMissing(const YAML::Node& entry, const YAML::Node& value,
                          const std::string& path) {
  const bool is_pattern = path.find_first_of("*?[") != std::string::npos;
  const std::string what =
      fmt::format("{} '{}'", is_pattern ? "no file matches" : "there is no file", path);
  if (TextOf(entry, "optional") == "true") {
    result_.some_skipped = true;
    result_.notes.push_back(fmt::format("{}: skipped, {}", problems_.Locate(PlaceOf(value)), what));
  } else {
    problems_.Add(PlaceOf(value), what + "; put it there, or skip it with 'optional: true'");
  }
}

void Resolver::AddMesh(MeshSpec mesh, const YAML::Node& entry) {
  const auto [first, is_new] = first_of_name_.emplace(mesh.name, PlaceOf(entry));
  if (is_new) {
    result_.meshes.push_back(std::move(mesh));
  } else {
    problems_.Add(PlaceOf(entry),
                  fmt::format("two meshes are named '{}' (first on line {}); give one a 'name'",
                              mesh.name, first->second.line));
  }
}

}  // namespace

MeshEntries ResolveMeshes(const YAML::Node& list, const std::string& root,
                          const std::vector<std::string>& seeds, Diagnostics* problems) {
  Resolver resolver(root, seeds, problems);
  if (list && list.IsSequence()) {
    for (const YAML::Node& entry : list) resolver.Add(entry);
  }
  return resolver.Take();
}

}  // namespace cirque
