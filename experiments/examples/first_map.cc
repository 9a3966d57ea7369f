// The least there is: points and triangles in, a map out.
#include <iostream>

#include "cirque/cirque.h"

int main() {
  Eigen::MatrixXd V(7, 3);  // a tent: six points around a seventh above them
  V << 2, 0, 0, 1, 2, 0, -1, 2, 0, -2, 0, 0, -1, -2, 0, 1, -2, 0, 0, 0, 1;
  Eigen::MatrixXi F(6, 3);
  F << 0, 1, 6, 1, 2, 6, 2, 3, 6, 3, 4, 6, 4, 5, 6, 5, 0, 6;

  const auto map = cirque::MapSurface(V, F);
  if (!map.ok()) {
    std::cerr << map.status().message() << "\n";
    return cirque::ExitStatus(map.status().code());
  }
  std::cout << "uv\n" << map->uv() << "\nf_uv\n" << map->f_uv() << "\n";
  std::cout << "outcome " << map->certificate.outcome << "\n";
}
