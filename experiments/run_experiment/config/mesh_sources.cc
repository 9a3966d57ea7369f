#include "experiments/run_experiment/config/mesh_sources.h"

#include <glob.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <map>
#include <sstream>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "cirque/io/io.h"

#include "experiments/run_experiment/config/file_content.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

/// The folder that $MESHES stands for: collections of meshes lie elsewhere on every machine.
fs::path MeshFolder(const std::string& root) {
  const char* folder = std::getenv("CIRQUE_MESHES");
  return folder && *folder ? fs::absolute(folder) : fs::path(root) / "meshes";
}

bool IsMeshFile(const std::string& path) {
  static const std::vector<std::string> kKnown = ReadableExtensions();
  return std::find(kKnown.begin(), kKnown.end(), MeshExtension(path)) != kKnown.end();
}

MeshSpec FromFile(const std::string& path) {
  MeshSpec mesh;
  mesh.file = path;
  return mesh;
}

StatusOr<std::vector<MeshSpec>> InFolder(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code error;
  using Iterator = fs::recursive_directory_iterator;
  for (Iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    std::error_code unreadable;
    if (i->is_regular_file(unreadable) && IsMeshFile(i->path())) files.push_back(i->path());
  }
  if (error) return Status::InvalidInput(folder + ": cannot be read: " + error.message());
  std::sort(files.begin(), files.end());
  std::vector<MeshSpec> meshes;
  for (const std::string& file : files) meshes.push_back(FromFile(file));
  return meshes;
}

StatusOr<std::vector<MeshSpec>> InArchive(const std::string& archive) {
  StatusOr<std::vector<std::string>> members = ArchiveMembers(archive);
  if (!members.ok()) return members.status();
  std::sort(members->begin(), members->end());
  std::vector<MeshSpec> meshes;
  for (std::string& member : *members) {
    if (!IsMeshFile(member)) continue;
    MeshSpec mesh;
    mesh.archive = archive;
    mesh.member = std::move(member);
    meshes.push_back(std::move(mesh));
  }
  return meshes;
}

StatusOr<std::vector<MeshSpec>> InList(const std::string& path) {
  const StatusOr<std::string> text = ReadWholeFile(path);
  if (!text.ok()) return text.status();
  std::istringstream lines(*text);
  std::vector<MeshSpec> meshes;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.ends_with('\r')) line.pop_back();
    if (line.empty() || line.starts_with('#')) continue;
    const std::string file = AbsolutePath(fs::path(path).parent_path().string(), line);
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
      return Status::InvalidInput(fmt::format("{}:{}: there is no file '{}'", path, number, file));
    }
    meshes.push_back(FromFile(file));
  }
  return meshes;
}

StatusOr<std::vector<MeshSpec>> InPlace(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return InFolder(path);
  if (!fs::is_regular_file(path, error)) {
    return Status::InvalidInput(fmt::format("there is no corpus '{}'; known by name: {}", path,
                                            fmt::join(Corpora().Names(), ", ")));
  }
  return path.ends_with(".txt") ? InList(path) : InArchive(path);
}

/// What may name a mesh, the shortest first: its file without extension, with one more folder each
/// time, with its extension, with its archive.
std::vector<std::string> NamesOf(const MeshSpec& mesh) {
  const fs::path path = mesh.member.empty() ? mesh.file : mesh.member;
  std::vector<std::string> names = {path.stem().string()};
  for (fs::path p = path.parent_path(); p.has_filename(); p = p.parent_path()) {
    names.push_back(p.filename().string() + "-" + names.back());
  }
  names.push_back(names.back() + path.extension().string());
  names.push_back(fs::path(mesh.archive).filename().string() + "-" + names.back());
  return names;
}

}  // namespace

std::string AbsolutePath(const std::string& root, const std::string& path) {
  constexpr std::string_view kMeshes = "$MESHES/";
  const fs::path whole = path.starts_with(kMeshes) ? MeshFolder(root) / path.substr(kMeshes.size())
                                                   : fs::path(root) / path;
  return whole.lexically_normal().string();
}

const Registry<std::vector<std::string>>& Corpora() {
  static const Registry<std::vector<std::string>> kTable(
      "corpus",
      {{"libcgal-demo",
        {"/usr/share/doc/libcgal-dev/data.tar.gz", "/usr/share/doc/libcgal-dev/demo.tar.gz"}}});
  return kTable;
}

std::vector<MeshSpec> MatchFiles(const std::string& pattern) {
  std::vector<MeshSpec> meshes;
  std::error_code error;  // of links that lead in a circle
  glob_t matches{};
  if (glob(pattern.c_str(), 0, nullptr, &matches) == 0) {
    for (std::size_t i = 0; i < matches.gl_pathc; ++i) {
      const std::string path = matches.gl_pathv[i];
      if (fs::is_regular_file(path, error)) meshes.push_back(FromFile(path));
    }
  }
  globfree(&matches);
  if (meshes.empty() && fs::is_regular_file(pattern, error)) meshes.push_back(FromFile(pattern));
  return meshes;
}

StatusOr<std::vector<MeshSpec>> MeshesOfCorpus(const std::string& root, const std::string& corpus) {
  const StatusOr<std::vector<std::string>> named = Corpora().Find(corpus);
  const std::vector<std::string> places =
      named.ok() ? *named : std::vector<std::string>{AbsolutePath(root, corpus)};
  std::vector<MeshSpec> meshes;
  for (const std::string& place : places) {
    StatusOr<std::vector<MeshSpec>> found = InPlace(place);
    if (!found.ok()) return found;
    std::move(found->begin(), found->end(), std::back_inserter(meshes));
  }
  if (meshes.empty()) {
    return Status::InvalidInput(fmt::format("corpus '{}' has no mesh files", corpus));
  }
  return meshes;
}

void NameMeshes(std::vector<MeshSpec>* meshes) {
  std::vector<std::vector<std::string>> names;
  for (const MeshSpec& mesh : *meshes) names.push_back(NamesOf(mesh));
  std::map<std::string, int> uses;
  for (const auto& of_one : names) {
    for (const std::string& name : of_one) ++uses[name];
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto own = std::find_if(names[i].begin(), names[i].end(),
                                  [&](const std::string& name) { return uses[name] == 1; });
    MeshSpec& mesh = (*meshes)[i];
    mesh.family = mesh.name = own == names[i].end() ? names[i].back() : *own;
  }
}

}  // namespace cirque
