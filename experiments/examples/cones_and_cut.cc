// A closed surface, opened through cones: chosen by a heuristic, or by hand with a cut of one's own.
#include <iostream>

#include "cirque/cirque.h"

using cirque::kPi;

int main() {
  Eigen::MatrixXd V(8, 3);  // a cube, its faces as quadrilaterals
  V << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1;
  Eigen::MatrixXi F(6, 4);
  F << 3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7;

  cirque::MapOptions by_hand;  // every corner of a cube has three right angles
  for (int v = 0; v < 8; ++v) by_hand.cones.push_back({v, 1.5 * kPi, 1.5 * kPi});
  by_hand.cut = {{0, 1}, {1, 2}, {2, 3}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};
  const auto map = cirque::MapSurface(V, F, by_hand);
  if (!map.ok()) return std::cerr << map.status().message() << "\n", 1;
  std::cout << "a cube unfolds into " << map->mesh.texture.size() << " points\n"
            << map->uv() << "\n";

  const auto blob = cirque::GenerateMesh("blob", {.triangles = 2000});
  if (!blob.ok()) return 2;
  cirque::MapOptions by_heuristic;
  const cirque::Status set = by_heuristic.Set({{"cones", "greedy"}, {"cone_budget", "12"}});
  if (!set.ok()) return std::cerr << set.message() << "\n", 3;
  const auto cut_open = cirque::MapSurface(cirque::ArraysOf(*blob), by_heuristic);
  if (!cut_open.ok()) return std::cerr << cut_open.status().message() << "\n", 4;
  std::cout << "a blob through cones: " << cut_open->certificate.overlap << "\n";
}
