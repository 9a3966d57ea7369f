// Maps every mesh of a folder: batch IN_FOLDER OUT_FOLDER. One that fails does not stop the others.
#include <filesystem>
#include <iostream>

#include "cirque/cirque.h"

int main(int argc, char** argv) {
  if (argc != 3) return std::cerr << "usage: batch IN_FOLDER OUT_FOLDER\n", 2;
  int failed = 0;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
    const std::string name = entry.path().filename();
    const auto mesh = cirque::ReadMesh(entry.path());
    if (!mesh.ok()) {
      std::cout << mesh.status().message() << "\n";
      ++failed;
      continue;
    }
    const auto map = cirque::MapSurface(cirque::ArraysOf(*mesh));
    cirque::Status status = map.status();
    const auto out = std::filesystem::path(argv[2]) / (entry.path().stem().string() + ".obj");
    if (map.ok()) status = cirque::WriteMesh(out, map->mesh);
    std::cout << name << ": " << (status.ok() ? map->certificate.outcome : status.message())
              << "\n";
    failed += status.ok() ? 0 : 1;
  }
  return failed;
}
