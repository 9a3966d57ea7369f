// A cone heuristic of one's own: registered in a table of the program's, used by a run.
#include <algorithm>
#include <iostream>
#include <memory>

#include "cirque/cirque.h"

struct SharpestCorners final : cirque::ConeHeuristic {  // those of most curvature share all of it
  cirque::StatusOr<std::vector<cirque::Cone>> Choose(
      const cirque::ConeProblem& problem) const override {
    std::vector<cirque::Index> sharpest = problem.candidates();
    const auto sharper = [&](int v, int w) {
      return problem.curvature()[v] > problem.curvature()[w];
    };
    std::stable_sort(sharpest.begin(), sharpest.end(), sharper);
    std::vector<cirque::Cone> cones;
    for (int i = 0; i < 8; ++i) {
      cones.push_back(cirque::ConeOfCurvature(sharpest[i], problem.TotalCurvature() / 8));
    }
    return cones;
  }
};

int main() {
  using Made = cirque::StatusOr<std::shared_ptr<const cirque::ConeHeuristic>>;
  const auto make = [](const cirque::OptionMap&) -> Made {
    return std::shared_ptr<const cirque::ConeHeuristic>(std::make_shared<SharpestCorners>());
  };
  const auto heuristics = cirque::ConeHeuristics().With("sharpest", make);
  const auto made = cirque::MakeConeHeuristic("sharpest", {}, heuristics);
  if (!made.ok()) return 1;
  cirque::MapOptions options;
  options.options.own_cones = *made;
  const auto blob = cirque::GenerateMesh("blob", {.triangles = 2000});
  const auto map = cirque::MapSurface(cirque::ArraysOf(*blob), options);
  if (!map.ok()) return std::cerr << map.status().message() << "\n", 2;
  std::cout << map->certificate.outcome << ": " << map->mesh.texture.size() << " points for "
            << blob->position.size() << " vertices\n";
}
