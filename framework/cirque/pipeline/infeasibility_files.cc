#include "cirque/pipeline/infeasibility_files.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "cirque/io/mesh_formats.h"

namespace cirque {
namespace {

constexpr double kCarries = 1e-3;  ///< share of the largest multiplier
constexpr double kGrey = 200;

double Largest(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// `id(i)` numbers the i-th multiplier.
template <class Id>
void AppendCarriers(const char* kind, const std::vector<double>& multipliers, const Id& id,
                    std::string* csv) {
  const double least = kCarries * Largest(multipliers);
  for (std::size_t i = 0; i < multipliers.size(); ++i) {
    if (std::abs(multipliers[i]) <= least) continue;
    fmt::format_to(std::back_inserter(*csv), "{},{},{}\n", kind, id(i), multipliers[i]);
  }
}

/// Multipliers divided by the largest: in [-1, 1].
std::vector<double> Relative(std::vector<double> multipliers) {
  const double largest = Largest(multipliers);
  for (double& multiplier : multipliers) multiplier = largest > 0 ? multiplier / largest : 0;
  return multipliers;
}

/// Per face its strongest relative multiplier.
std::vector<double> FaceStrengths(const Surface& surface, const InfeasibilityCertificate& proof) {
  const Triangulation& t = surface.triangulation;
  const std::vector<double> of_constrained = Relative(proof.vertex_multiplier);
  std::vector<double> strength = Relative(proof.face_multiplier);
  std::vector<double> of_vertex(t.num_vertices, 0.0);
  for (Index v = 0; v < t.num_vertices; ++v) {
    const auto found = std::lower_bound(proof.constrained_vertex.begin(),
                                        proof.constrained_vertex.end(), surface.soup_vertex[v]);
    if (found == proof.constrained_vertex.end() || *found != surface.soup_vertex[v]) continue;
    of_vertex[v] = of_constrained[found - proof.constrained_vertex.begin()];
  }
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    double& of_face = strength[Triangulation::Face(h)];
    if (std::abs(of_vertex[t.vertex[h]]) > std::abs(of_face)) of_face = of_vertex[t.vertex[h]];
  }
  return strength;
}

Colour ColourOf(double strength) {
  const double share = std::abs(strength) <= kCarries ? 0 : std::sqrt(std::abs(strength));
  const int strong = static_cast<int>(std::lround(kGrey + (255 - kGrey) * share));
  const int weak = static_cast<int>(std::lround(kGrey * (1 - share)));
  return strength > 0 ? Colour{strong, weak, weak} : Colour{weak, weak, strong};
}

}  // namespace

std::string InfeasibilityCsv(const InfeasibilityCertificate& proof) {
  std::string csv = "kind,id,multiplier\n";
  const std::vector<Index>& face = proof.triangle_face;
  AppendCarriers(
      "face", proof.face_multiplier,
      [&](std::size_t i) { return face.empty() ? static_cast<Index>(i) : face[i]; }, &csv);
  AppendCarriers(
      "vertex", proof.vertex_multiplier, [&](std::size_t i) { return proof.constrained_vertex[i]; },
      &csv);
  return csv;
}

std::string InfeasibilityPly(const Surface& surface, const InfeasibilityCertificate& proof) {
  std::vector<Colour> colours;
  for (const double strength : FaceStrengths(surface, proof)) {
    colours.push_back(ColourOf(strength));
  }
  return FormatColouredPly(surface.position, surface.triangulation.vertex, colours);
}

}  // namespace cirque
