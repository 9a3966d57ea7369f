// Judges the texture coordinates that another program gave a mesh: verify_uvs MESH.obj MAPPED.obj
#include <iostream>

#include "cirque/cirque.h"

int main(int argc, char** argv) {
  if (argc != 3) return std::cerr << "usage: verify_uvs MESH.obj MAPPED.obj\n", 2;
  const auto mesh = cirque::ReadMesh(argv[1]);
  const auto mapped = cirque::ReadMesh(argv[2]);
  for (const cirque::Status& status : {mesh.status(), mapped.status()}) {
    if (!status.ok()) return std::cerr << status.message() << "\n", 2;
  }
  const auto verdict = cirque::JudgeMap(*mesh, *mapped);
  if (!verdict.ok()) return std::cerr << verdict.status().message() << "\n", 2;
  std::cout << verdict->verdict << "\n";
  for (const std::string& error : verdict->errors) std::cout << "  " << error << "\n";
  return verdict->valid ? 0 : 1;
}
