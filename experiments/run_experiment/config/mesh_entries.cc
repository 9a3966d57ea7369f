#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/generators/known_maps.h"

#include "experiments/run_experiment/config/config_text.h"
#include "experiments/run_experiment/config/entries.h"
#include "experiments/run_experiment/config/file_content.h"
#include "experiments/run_experiment/config/mesh_condition.h"
#include "experiments/run_experiment/config/mesh_sources.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

std::string TextOf(const YAML::Node& entry, const std::string& key) {
  const YAML::Node value = entry[key];
  return value && value.IsScalar() ? value.Scalar() : "";
}

/// Sets how it is repaired and how coarse or fine it is made; false: another key. A text that the schema has refused
/// says nothing.
bool SetFineness(const std::string& key, const std::string& text, MeshSpec* mesh) {
  const auto number = static_cast<int>(ParseInteger(text).value_or(0));
  if (key == "subdivision") {
    mesh->subdivision = text;
  } else if (key == "subdivisions") {
    mesh->subdivisions = number;
  } else if (key == "decimate") {
    mesh->decimate = number;
  } else if (key == "repair") {
    mesh->repair = text;
  } else {
    return false;
  }
  return true;
}

void NameFineness(MeshSpec* mesh) {
  if (mesh->repair != MeshSpec().repair) mesh->name += "-" + mesh->repair;
  if (mesh->decimate > 0) mesh->name += fmt::format("-to{}", mesh->decimate);
  if (mesh->subdivisions == 0) return;
  const bool plain = mesh->subdivision == MeshSpec().subdivision;
  mesh->name += fmt::format("-{}{}", plain ? "sub" : mesh->subdivision, mesh->subdivisions);
}

std::string NoFile(const std::string& path) {
  const bool is_pattern = path.find_first_of("*?[") != std::string::npos;
  return fmt::format("{} '{}'", is_pattern ? "no file matches" : "there is no file", path);
}

class Resolver {
 public:
  Resolver(std::string root, std::vector<std::string> seeds, Diagnostics* problems)
      : root_(std::move(root)), seeds_(std::move(seeds)), problems_(*problems) {}

  void Add(const YAML::Node& entry);
  MeshEntries Take() { return std::move(result_); }

 private:
  void AddFiles(const YAML::Node& entry);
  void AddCorpus(const YAML::Node& entry);
  void AddFound(std::vector<MeshSpec> found, const YAML::Node& entry);
  bool Select(const YAML::Node& entry, std::vector<MeshSpec>* found);
  void AddMember(const YAML::Node& entry);
  void AddGenerated(const YAML::Node& entry);
  void AddMissing(const YAML::Node& entry, const YAML::Node& value, const std::string& what);
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
  if (!TextOf(entry, "corpus").empty()) AddCorpus(entry);
  if (!TextOf(entry, "archive").empty() && !TextOf(entry, "member").empty()) AddMember(entry);
  if (!TextOf(entry, "generator").empty()) AddGenerated(entry);
}

void Resolver::AddFiles(const YAML::Node& entry) {
  const std::string path = AbsolutePath(root_, TextOf(entry, "file"));
  std::vector<MeshSpec> files = MatchFiles(path);
  if (files.empty()) return AddMissing(entry, entry["file"], NoFile(path));
  AddFound(std::move(files), entry);
}

void Resolver::AddCorpus(const YAML::Node& entry) {
  StatusOr<std::vector<MeshSpec>> meshes = MeshesOfCorpus(root_, TextOf(entry, "corpus"));
  if (!meshes.ok()) return AddMissing(entry, entry["corpus"], meshes.status().message());
  AddFound(*std::move(meshes), entry);
}

/// One or several meshes of an entry: an entry's name is that of the one, or begins those of several.
void Resolver::AddFound(std::vector<MeshSpec> found, const YAML::Node& entry) {
  const std::string name = TextOf(entry, "name");
  NameMeshes(&found);
  const bool is_one = found.size() == 1;
  if (!Select(entry, &found)) return;
  for (MeshSpec& mesh : found) {
    if (!name.empty()) mesh.family = mesh.name = is_one ? name : name + "-" + mesh.name;
    AddFinenesses(mesh, entry);
  }
  NoteWithoutSeeds(entry);
}

/// Keeps those that the entry's condition is for; false: it cannot be told.
bool Resolver::Select(const YAML::Node& entry, std::vector<MeshSpec>* found) {
  const std::string text = TextOf(entry, "where");
  if (text.empty()) return true;
  const StatusOr<MeshCondition> condition = ParseMeshCondition(text);
  if (!condition.ok()) return false;  // The schema has refused it.
  int num_no_surface = 0;
  StatusOr<std::vector<MeshSpec>> selected = SelectMeshes(*found, *condition, &num_no_surface);
  if (!selected.ok()) {
    problems_.Add(PlaceOf(entry["where"]), selected.status().message());
    return false;
  }
  std::string note =
      fmt::format("{}: {} of {} meshes, those with {}", problems_.Locate(PlaceOf(entry["where"])),
                  selected->size(), found->size(), text);
  if (num_no_surface > 0) note += fmt::format("; {} are no surfaces", num_no_surface);
  result_.notes.push_back(std::move(note));
  *found = *std::move(selected);
  return true;
}

void Resolver::AddMember(const YAML::Node& entry) {
  MeshSpec mesh;
  mesh.archive = AbsolutePath(root_, TextOf(entry, "archive"));
  mesh.member = TextOf(entry, "member");
  std::error_code error;
  if (!fs::is_regular_file(mesh.archive, error)) {
    return AddMissing(entry, entry["archive"], NoFile(mesh.archive));
  }
  if (const Status status = FindArchiveMember(mesh.archive, mesh.member); !status.ok()) {
    return problems_.Add(PlaceOf(entry["member"]), status.message());
  }
  AddFound({std::move(mesh)}, entry);
}

/// The mesh as coarse and fine as the entry lists.
void Resolver::AddFinenesses(const MeshSpec& mesh, const YAML::Node& entry) {
  std::vector<Axis> axes = AxesOf(entry, ConfigSchema(), "meshes");
  std::erase_if(axes, [](const Axis& axis) {
    MeshSpec ignored;
    return !SetFineness(axis.key, "", &ignored);
  });
  for (const Combination& combination : Combine(axes)) {
    MeshSpec fine = mesh;
    for (const auto& setting : combination.settings) {
      SetFineness(setting.key, setting.value, &fine);
    }
    NameFineness(&fine);
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
      if (SetFineness(key, text, &mesh)) continue;
      const std::optional<long long> value = ParseInteger(text);
      if (!value) return;  // The schema has refused it.
      if (key == "triangles") mesh.generator_options.triangles = static_cast<Index>(*value);
      if (key == "seed") mesh.generator_options.seed = static_cast<unsigned>(*value);
      if (varies || name.empty()) {
        mesh.name += fmt::format("-{}{}", key == "seed" ? "s" : "", text);
      }
    }
    NameFineness(&mesh);
    if (mesh.known_boundary && (mesh.subdivisions > 0 || mesh.decimate > 0)) {
      const char* key = mesh.subdivisions > 0 ? "subdivisions" : "decimate";
      problems_.Add(
          PlaceOf(entry[key]),
          "new vertices do not lie on the smooth surface, so that no conformal map of them "
          "is known: leave out 'boundary: known_map'");
    }
    AddMesh(std::move(mesh), entry);
  }
}

void Resolver::AddMissing(const YAML::Node& entry, const YAML::Node& value,
                          const std::string& what) {
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
