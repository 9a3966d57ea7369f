// Reading and writing a mesh in every format, from and to the file system.
#include <unistd.h>

#include <filesystem>

#include <glog/logging.h>

#include "cirque/core/atomic_file.h"
#include "cirque/generators/generators.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"

#include "bench/registration.h"

namespace cirque {
namespace {

namespace fs = std::filesystem;

/// A file of this process that ends with it.
class ScratchFile {
 public:
  explicit ScratchFile(const std::string& extension)
      : path_((fs::temp_directory_path() /
               ("cirque_bench_" + std::to_string(getpid()) + "." + extension))
                  .string()) {}
  ~ScratchFile() {
    std::error_code error;
    fs::remove(path_, error);
  }
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

PolygonSoup Terrain(int triangles) { return *GenerateMesh("bumpy_terrain", {triangles, 1}); }

void CountBytes(benchmark::State& state, const std::string& path) {
  const auto bytes = static_cast<double>(fs::file_size(path));
  state.counters["bytes"] = bytes;
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes) * state.iterations());
}

void TimeWrite(benchmark::State& state, const std::string& extension, int triangles) {
  const ScratchFile file(extension);
  const PolygonSoup soup = Terrain(triangles);
  Status status;
  for (auto _ : state) status = WriteMesh(file.path(), soup);
  if (!status.ok()) return state.SkipWithError(status.message().c_str());
  CountBytes(state, file.path());
}

/// Binary STL, which the framework only reads: 80 bytes of header, the number of triangles, and for
/// each a normal (here 0), three points and two bytes.
Status WriteStl(const std::string& path, const PolygonSoup& soup) {
  std::string bytes(80, ' ');
  const auto append = [&](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  append(static_cast<std::uint32_t>(soup.num_polygons()));
  for (std::size_t c = 0; c < soup.corner.size(); ++c) {
    if (c % 3 == 0) bytes.append(12, '\0');
    for (const double x : soup.position[soup.corner[c]]) append(static_cast<float>(x));
    if (c % 3 == 2) bytes.append(2, '\0');
  }
  return WriteFileAtomically(path, bytes);
}

Status WriteFor(const std::string& extension, const std::string& path, const PolygonSoup& soup) {
  return extension == "stl" ? WriteStl(path, soup) : WriteMesh(path, soup);
}

void TimeRead(benchmark::State& state, const std::string& extension, int triangles) {
  const ScratchFile file(extension);
  const Status written = WriteFor(extension, file.path(), Terrain(triangles));
  if (!written.ok()) return state.SkipWithError(written.message().c_str());
  StatusOr<PolygonSoup> soup = PolygonSoup();
  for (auto _ : state) soup = ReadMesh(file.path());
  if (!soup.ok()) return state.SkipWithError(soup.status().message().c_str());
  CountBytes(state, file.path());
}

void TimePreflight(benchmark::State& state, int triangles) {
  const PolygonSoup soup = Terrain(triangles);
  PreflightReport report;
  for (auto _ : state) benchmark::DoNotOptimize(Preflight(soup, &report).ok());
}

using Timed = void (*)(benchmark::State&, const std::string&, int);

void Register(const std::string& what, const std::string& extension, Timed time) {
  RegisterBySize(what + "/" + extension, {kLarge}, [=](benchmark::State& state, int triangles) {
    time(state, extension, triangles);
    CountFaces(state, triangles);
  });
}

[[maybe_unused]] const bool kRegistered = [] {
  for (const std::string& extension : WritableExtensions()) {
    Register("write", extension, TimeWrite);
  }
  for (const std::string& extension : ReadableExtensions()) {
    Register("read", extension, TimeRead);
  }
  RegisterBySize("preflight", {kLarge}, [](benchmark::State& state, int triangles) {
    TimePreflight(state, triangles);
    CountFaces(state, triangles);
  });
  return true;
}();

}  // namespace
}  // namespace cirque
