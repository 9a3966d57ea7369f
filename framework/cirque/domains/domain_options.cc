#include <limits>

#include "cirque/domains/domain.h"
#include "cirque/domains/sphere_normalization.h"

namespace cirque {
namespace {

using O = DomainOptions;

constexpr double kMostVertices = std::numeric_limits<Index>::max();

/// An option of one vertex or several.
template <class Member>
Option<O> Vertex(const std::string& name, Member member, const std::string& help) {
  return Option<O>(name, member, help).Between(kNone, kMostVertices).Unit(kVertexUnit);
}

std::vector<std::string> Normalizations() {
  std::vector<std::string> names = SphereNormalizations();
  for (const char* of_the_disk : {"boundary", "area"}) names.push_back(of_the_disk);
  return names;
}

}  // namespace

const OptionTable<DomainOptions>& DomainOptionTable() {
  static const OptionTable<O> kTable("domain", [] {
    std::vector<Option<O>> rows = {
        Vertex(
            "pole", &O::pole,
            "sphere, disk, half_plane: the vertex that the solve sends to infinity, else chosen"),
        Option<O>(
            "normalization", &O::normalization,
            "sphere, disk: what is at 0 or spread evenly; disk: none, boundary or area, sphere: "
            "all but those two")
            .OneOf(Normalizations()),
        {"principal_axes", &O::principal_axes,
         "sphere: turned to the principal axes of the surface's area"},
        {"inversion", &O::inversion,
         "sphere: fit angles to the surface inverted about the pole, not to its own"},
        Vertex("centre", &O::centre, "disk: inner vertex that goes to 0"),
        Vertex("angle_zero", &O::angle_zero,
               "disk: boundary vertex that goes to (1, 0); curve: to its first point"),
        Vertex("corners", &O::corners,
               "rectangle, polygon, triangle: boundary vertices in order, else chosen"),
        Option<O>("sides", &O::sides, "polygon: how many corners to choose, where none are given")
            .Between(3, 1000),
        {"curve", &O::curve,
         "curve: file of a closed curve for the boundary, 'x y' a line, or ellipse:ratio=R"},
        {"pins", &O::pins,
         "plane: file of where vertices go, 'vertex x y' a line: one moves the map, two turn and "
         "scale it, more bend it without flips"},
        Option<O>(
            "pin_weight", &O::pin_weight,
            "plane, three pins or more: weight of their misses against the map's distortion; 0: "
            "they are met exactly")
            .Between(0, 1e12),
        {"symmetric", &O::symmetric,
         "plane: a disk that is its own mirror image, mesh included, gets a map that is"}};
    for (Option<O>& row : rows) {
      const std::string& name = row.info().name;
      const bool of_sphere = name == "principal_axes" || name == "inversion";
      row = std::move(row).About(of_sphere ? "Sphere" : "Shape");
    }
    return rows;
  }());
  return kTable;
}

}  // namespace cirque
