// A closed surface of genus 0 to the unit sphere, its centre of mass at the origin; then judged.
#include <iostream>

#include "cirque/cirque.h"

int main() {
  const auto blob = cirque::GenerateMesh("blob", {.triangles = 2000});
  if (!blob.ok()) return 1;
  cirque::MapOptions options;
  const cirque::Status set = options.Set({{"domain", "sphere"}, {"principal_axes", "true"}});
  if (!set.ok()) return std::cerr << set.message() << "\n", 2;
  const auto map = cirque::MapSurface(cirque::ArraysOf(*blob), options);
  if (!map.ok()) return std::cerr << map.status().message() << "\n", 3;
  const auto verdict = cirque::JudgeSphereMap(*blob, map->position);
  if (!verdict.ok()) return std::cerr << verdict.status().message() << "\n", 4;
  std::cout << verdict->verdict << "\n";
  return verdict->valid ? 0 : 5;
}
