#include <fmt/format.h>

#include "cirque/pipeline/certificate.h"

namespace cirque {
namespace {

using C = Certificate;

/// The member of a summary that may be absent.
template <auto Group, auto Member>
std::optional<double> Read(const Certificate& certificate) {
  const auto& summary = certificate.*Group;
  if (!summary) return std::nullopt;
  const auto& value = *summary.*Member;
  if constexpr (requires { value.has_value(); }) {
    return value ? std::optional<double>(*value) : std::nullopt;
  } else {
    return static_cast<double>(value);
  }
}

template <auto Member>
std::optional<double> ReadSeconds(const Certificate& certificate) {
  return certificate.seconds.*Member;
}

/// A line of the table: CertificateField as it stands in the program.
struct Row {
  const char *name, *summary, *unit, *meaning;
  std::optional<double> (*value)(const Certificate&);
};

constexpr char kFlips[] = "triangulation";
constexpr char kAngles[] = "angle fit";
constexpr char kRadii[] = "log radii";
constexpr char kBudget[] = "number of cones";
constexpr char kLadder[] = "ladder";
constexpr char kRepair[] = "repair of cones";
constexpr char kRefinedCones[] = "refinement of cones";
constexpr char kLayout[] = "layout";
constexpr char kSeams[] = "seams";
constexpr char kRefinedMap[] = "refinement of the map";
constexpr char kDistortion[] = "distortion";
constexpr char kSphere[] = "sphere";
constexpr char kDisk[] = "disk";
constexpr char kHalfPlane[] = "half-plane";
constexpr char kPolygon[] = "polygon";
constexpr char kProcess[] = "process";

constexpr Row kNumbers[] = {
    {"flips", kFlips, "", "intrinsic flips", Read<&C::triangulation, &TriangulationSummary::flips>},
    {"delaunay_rounds", kFlips, "",
     "rounds of flips: solved, edges of flipped triangles locked, solved again",
     Read<&C::triangulation, &TriangulationSummary::delaunay_rounds>},
    {"flipped_in_chart", kFlips, "",
     "triangles of the input that came out flipped in the last round, before untangling",
     Read<&C::triangulation, &TriangulationSummary::flipped_in_chart>},
    {"moved_vertices", kFlips, "", "vertices moved to untangle flipped triangles",
     Read<&C::triangulation, &TriangulationSummary::moved_vertices>},
    {"flip_back_stuck", kFlips, "",
     "flips that the flat metric does not let be undone, where that was asked for",
     Read<&C::triangulation, &TriangulationSummary::flip_back_stuck>},
    {"smallest_angle", kAngles, "rad", "smallest angle",
     Read<&C::angle_fit, &AngleFitSummary::smallest_angle>},
    {"smallest_theta", kAngles, "rad", "smallest intersection angle",
     Read<&C::angle_fit, &AngleFitSummary::smallest_theta>},
    {"epsilon", kAngles, "rad", "margin asked for, of corner and intersection angles",
     Read<&C::angle_fit, &AngleFitSummary::epsilon>},
    {"triangle_sum_residual", kAngles, "rad", "largest error of a triangle's angle sum",
     Read<&C::angle_fit, &AngleFitSummary::triangle_sum_residual>},
    {"vertex_sum_residual", kAngles, "rad", "largest error of a vertex's angle sum",
     Read<&C::angle_fit, &AngleFitSummary::vertex_sum_residual>},
    {"angle_primal", kAngles, "", "objective of the angle fit",
     Read<&C::angle_fit, &AngleFitSummary::angle_primal>},
    {"angle_dual", kAngles, "", "its dual", Read<&C::angle_fit, &AngleFitSummary::angle_dual>},
    {"angle_gap", kAngles, "", "duality gap of the angle fit",
     Read<&C::angle_fit, &AngleFitSummary::angle_gap>},
    {"angle_iterations", kAngles, "", "iterations of the angle fit",
     Read<&C::angle_fit, &AngleFitSummary::angle_iterations>},
    {"angle_factorizations", kAngles, "", "factorizations of the angle fit",
     Read<&C::angle_fit, &AngleFitSummary::angle_factorizations>},
    {"angle_cg_iterations", kAngles, "", "CG steps of the angle fit",
     Read<&C::angle_fit, &AngleFitSummary::angle_cg_iterations>},
    {"angle_fit_retried", kAngles, "",
     "1: the interior point decided what the first solver could not",
     Read<&C::angle_fit, &AngleFitSummary::angle_fit_retried>},
    {"radii_gradient", kRadii, "rad", "gradient of the log radii",
     Read<&C::radii, &RadiiSummary::radii_gradient>},
    {"radii_primal", kRadii, "", "energy of the log radii",
     Read<&C::radii, &RadiiSummary::radii_primal>},
    {"radii_dual", kRadii, "", "its dual", Read<&C::radii, &RadiiSummary::radii_dual>},
    {"radii_gap", kRadii, "", "duality gap of the log radii",
     Read<&C::radii, &RadiiSummary::radii_gap>},
    {"radii_iterations", kRadii, "", "iterations of the log radii",
     Read<&C::radii, &RadiiSummary::radii_iterations>},
    {"radii_factorizations", kRadii, "", "factorizations of the log radii",
     Read<&C::radii, &RadiiSummary::radii_factorizations>},
    {"radii_cg_iterations", kRadii, "", "CG steps of the log radii",
     Read<&C::radii, &RadiiSummary::radii_cg_iterations>},
    {"log_radius_range", kRadii, "", "range of the log radii",
     Read<&C::radii, &RadiiSummary::log_radius_range>},
    {"cones_asked", kBudget, "", "cones asked for, fewer than there must be",
     Read<&C::cone_budget, &ConeBudgetSummary::cones_asked>},
    {"cones_needed", kBudget, "", "cones taken instead",
     Read<&C::cone_budget, &ConeBudgetSummary::cones_needed>},
    {"cone_repairs", kRepair, "", "rounds of repair of infeasible cones",
     Read<&C::cone_repair, &ConeRepairSummary::cone_repairs>},
    {"cones_moved", kRepair, "", "cones moved to a neighbour",
     Read<&C::cone_repair, &ConeRepairSummary::cones_moved>},
    {"cones_widened", kRepair, "", "cones whose angle was given a range",
     Read<&C::cone_repair, &ConeRepairSummary::cones_widened>},
    {"rungs_tried", kLadder, "", "other roads tried where the one asked for led to no map",
     Read<&C::ladder, &LadderSummary::rungs_tried>},
    {"refinement_steps", kRefinedCones, "", "steps of the cones' angles",
     Read<&C::cone_refinement, &ConeRefinementSummary::refinement_steps>},
    {"refinement_solves", kRefinedCones, "", "solves for them",
     Read<&C::cone_refinement, &ConeRefinementSummary::refinement_solves>},
    {"refinement_area_distortion_before", kRefinedCones, "",
     "log_area_ratio_l2 where it was solved, before",
     Read<&C::cone_refinement, &ConeRefinementSummary::refinement_area_distortion_before>},
    {"refinement_area_distortion_after", kRefinedCones, "", "the same after",
     Read<&C::cone_refinement, &ConeRefinementSummary::refinement_area_distortion_after>},
    {"layout_closure", kLayout, "", "largest mismatch of a laid out edge with its length",
     Read<&C::layout, &LayoutSummary::layout_closure>},
    {"flipped_triangles", kLayout, "", "flipped triangles",
     Read<&C::layout, &LayoutSummary::flipped_triangles>},
    {"cones", kLayout, "", "cones", Read<&C::layout, &LayoutSummary::cones>},
    {"patches", kLayout, "", "patches", Read<&C::layout, &LayoutSummary::patches>},
    {"rotation_order", kLayout, "",
     "n: rotations across seams are exact multiples of 2 pi / n; 0: they are not",
     Read<&C::layout, &LayoutSummary::rotation_order>},
    {"cut_length", kLayout, "", "length of the cut over the square root of the area",
     Read<&C::layout, &LayoutSummary::cut_length>},
    {"float32_vanishing_triangles", kLayout, "",
     "triangles that vanish or flip for who reads the coordinates as 32-bit floats",
     Read<&C::layout, &LayoutSummary::float32_vanishing_triangles>},
    {"seams", kSeams, "", "seams", Read<&C::seams, &SeamSummary::seams>},
    {"seam_length_mismatch", kSeams, "", "largest difference of the two lengths of an opened edge",
     Read<&C::seams, &SeamSummary::seam_length_mismatch>},
    {"seam_rotation_mismatch", kSeams, "rad",
     "largest difference of an edge's rotation from its seam's",
     Read<&C::seams, &SeamSummary::seam_rotation_mismatch>},
    {"seam_gap", kSeams, "",
     "largest distance of a side from where its seam's motion takes the other",
     Read<&C::seams, &SeamSummary::seam_gap>},
    {"cone_rotation_mismatch", kSeams, "rad",
     "largest difference of the rotation around a cone from its angle",
     Read<&C::seams, &SeamSummary::cone_rotation_mismatch>},
    {"map_refinement_flagged", kRefinedMap, "", "outliers among the triangles before it",
     Read<&C::map_refinement, &MapRefinementSummary::map_refinement_flagged>},
    {"map_refinement_patches", kRefinedMap, "", "patches refined, over all rounds",
     Read<&C::map_refinement, &MapRefinementSummary::map_refinement_patches>},
    {"map_refinement_rounds", kRefinedMap, "", "rounds of patches",
     Read<&C::map_refinement, &MapRefinementSummary::map_refinement_rounds>},
    {"map_refinement_patch_steps", kRefinedMap, "", "steps in all patches",
     Read<&C::map_refinement, &MapRefinementSummary::map_refinement_patch_steps>},
    {"map_refinement_steps", kRefinedMap, "", "steps on the whole map",
     Read<&C::map_refinement, &MapRefinementSummary::map_refinement_steps>},
    {"map_refinement_before", kRefinedMap, "", "its objective before",
     Read<&C::map_refinement, &MapRefinementSummary::map_refinement_before>},
    {"map_refinement_after", kRefinedMap, "", "its objective after",
     Read<&C::map_refinement, &MapRefinementSummary::map_refinement_after>},
    {"quasi_conformal_mean", kDistortion, "", "quasi conformal mean",
     Read<&C::distortion, &DistortionSummary::quasi_conformal_mean>},
    {"quasi_conformal_max", kDistortion, "", "quasi conformal max",
     Read<&C::distortion, &DistortionSummary::quasi_conformal_max>},
    {"log_area_ratio_l2", kDistortion, "", "log area ratio l2",
     Read<&C::distortion, &DistortionSummary::log_area_ratio_l2>},
    {"log_area_ratio_min", kDistortion, "", "log area ratio min",
     Read<&C::distortion, &DistortionSummary::log_area_ratio_min>},
    {"log_area_ratio_max", kDistortion, "", "log area ratio max",
     Read<&C::distortion, &DistortionSummary::log_area_ratio_max>},
    {"pole_vertex", kSphere, "", "vertex that the solve sent to infinity",
     Read<&C::sphere, &SphereSummary::pole_vertex>},
    {"pole_corners", kSphere, "", "triangles at it",
     Read<&C::sphere, &SphereSummary::pole_corners>},
    {"pole_attempts", kSphere, "", "vertices tried",
     Read<&C::sphere, &SphereSummary::pole_attempts>},
    {"link_margin", kSphere, "rad", "pi less the largest angle sum allowed at its link",
     Read<&C::sphere, &SphereSummary::link_margin>},
    {"delaunay_margin", kSphere, "rad",
     "smallest intersection angle of two circles on the sphere, those at the pole included",
     Read<&C::sphere, &SphereSummary::delaunay_margin>},
    {"normalization_residual", kSphere, "", "centre of mass, or gradient of the area distortion",
     Read<&C::sphere, &SphereSummary::normalization_residual>},
    {"centre_of_mass", kSphere, "", "its distance from 0",
     Read<&C::sphere, &SphereSummary::centre_of_mass>},
    {"degree", kSphere, "", "times that the image covers the sphere",
     Read<&C::sphere, &SphereSummary::degree>},
    {"normalization_iterations", kSphere, "", "steps of the normalisation",
     Read<&C::sphere, &SphereSummary::normalization_iterations>},
    {"angle_distortion_mean", kSphere, "rad",
     "mean change of an angle, between flat triangles of surface and image",
     Read<&C::sphere, &SphereSummary::angle_distortion_mean>},
    {"angle_distortion_max", kSphere, "rad", "largest change of an angle",
     Read<&C::sphere, &SphereSummary::angle_distortion_max>},
    {"pole_vertex", kDisk, "", "vertex that the solve sent to infinity; -1: none",
     Read<&C::disk, &DiskSummary::pole_vertex>},
    {"centre_vertex", kDisk, "", "vertex at 0; -1: none",
     Read<&C::disk, &DiskSummary::centre_vertex>},
    {"angle_zero_vertex", kDisk, "", "vertex at (1, 0)",
     Read<&C::disk, &DiskSummary::angle_zero_vertex>},
    {"overhanging_faces", kDisk, "", "faces beyond an edge that joins two boundary vertices",
     Read<&C::disk, &DiskSummary::overhanging_faces>},
    {"boundary_spread", kDisk, "",
     "share by which the boundary was spread out; 0: the map is conformal",
     Read<&C::disk, &DiskSummary::boundary_spread>},
    {"boundary_straightness", kDisk, "",
     "largest distance of the half-plane's boundary from its line",
     Read<&C::disk, &DiskSummary::boundary_straightness>},
    {"boundary_circle_error", kDisk, "", "largest distance of a boundary vertex from the circle",
     Read<&C::disk, &DiskSummary::boundary_circle_error>},
    {"boundary_centre_of_mass", kDisk, "", "distance of the boundary's centre of mass from 0",
     Read<&C::disk, &DiskSummary::boundary_centre_of_mass>},
    {"area_centre_of_mass", kDisk, "", "distance of the area's centre of mass from 0",
     Read<&C::disk, &DiskSummary::area_centre_of_mass>},
    {"centre_error", kDisk, "", "distance of the centre vertex from 0",
     Read<&C::disk, &DiskSummary::centre_error>},
    {"core_quasi_conformal_mean", kDisk, "",
     "mean quasi-conformal distortion of the faces that no chord cuts off",
     Read<&C::disk, &DiskSummary::core_quasi_conformal_mean>},
    {"core_quasi_conformal_max", kDisk, "", "the largest",
     Read<&C::disk, &DiskSummary::core_quasi_conformal_max>},
    {"pole_vertex", kHalfPlane, "", "vertex that belongs at infinity",
     Read<&C::half_plane, &HalfPlaneSummary::pole_vertex>},
    {"pole_height", kHalfPlane, "", "its finite height",
     Read<&C::half_plane, &HalfPlaneSummary::pole_height>},
    {"boundary_straightness", kHalfPlane, "", "largest distance of the boundary from its line",
     Read<&C::half_plane, &HalfPlaneSummary::boundary_straightness>},
    {"shortest_side", kPolygon, "", "shortest side",
     Read<&C::polygon, &PolygonSummary::shortest_side>},
    {"longest_side", kPolygon, "", "longest side",
     Read<&C::polygon, &PolygonSummary::longest_side>},
    {"conformal_modulus", kPolygon, "", "conformal modulus: width over height of the rectangle",
     Read<&C::polygon, &PolygonSummary::conformal_modulus>},
    {"opposite_side_mismatch", kPolygon, "",
     "relative difference of opposite sides before they were made equal",
     Read<&C::polygon, &PolygonSummary::opposite_side_mismatch>},
    {"peak_memory_mib", kProcess, "MiB", "peak memory of the process",
     Read<&C::process, &ProcessSummary::peak_memory_mib>},
};

constexpr Row kTimes[] = {
    {"read", "seconds", "s", "time of reading the mesh", ReadSeconds<&StageSeconds::read>},
    {"preflight", "seconds", "s", "time of checking it and making the surface",
     ReadSeconds<&StageSeconds::preflight>},
    {"subdivide", "seconds", "s", "time of subdividing it", ReadSeconds<&StageSeconds::subdivide>},
    {"pole", "seconds", "s", "time of choice of the pole", ReadSeconds<&StageSeconds::pole>},
    {"corners", "seconds", "s", "time of choice of the corners",
     ReadSeconds<&StageSeconds::corners>},
    {"cones", "seconds", "s", "time of placement of the cones", ReadSeconds<&StageSeconds::cones>},
    {"triangulation", "seconds", "s", "time of flips", ReadSeconds<&StageSeconds::triangulation>},
    {"angles", "seconds", "s", "time of angle fit", ReadSeconds<&StageSeconds::angles>},
    {"radii", "seconds", "s", "time of log radii", ReadSeconds<&StageSeconds::radii>},
    {"refine_cones", "seconds", "s", "time of refinement of the cones",
     ReadSeconds<&StageSeconds::refine_cones>},
    {"layout", "seconds", "s", "time of cut and layout", ReadSeconds<&StageSeconds::layout>},
    {"measures", "seconds", "s", "time of measures", ReadSeconds<&StageSeconds::measures>},
    {"write", "seconds", "s", "time of writing", ReadSeconds<&StageSeconds::write>},
    {"total", "seconds", "s", "time of the map", ReadSeconds<&StageSeconds::total>},
    {"process", "seconds", "s", "time of the whole process", ReadSeconds<&StageSeconds::process>},
};

template <std::size_t N>
std::vector<CertificateField> FieldsOf(const Row (&rows)[N]) {
  std::vector<CertificateField> fields;
  for (const Row& row : rows) {
    fields.push_back({row.name, row.summary, row.unit, row.meaning, row.value});
  }
  return fields;
}

std::map<std::string, double> Read(const std::vector<CertificateField>& fields,
                                   const Certificate& certificate) {
  std::map<std::string, double> numbers;
  for (const CertificateField& field : fields) {
    if (const std::optional<double> value = field.value(certificate)) {
      numbers.emplace(field.name, *value);
    }
  }
  return numbers;
}

}  // namespace

const std::vector<CertificateField>& CertificateFields() {
  static const std::vector<CertificateField> kTable = FieldsOf(kNumbers);
  return kTable;
}

const std::vector<CertificateField>& SecondsFields() {
  static const std::vector<CertificateField> kTable = FieldsOf(kTimes);
  return kTable;
}

std::map<std::string, double> NumbersOf(const Certificate& certificate) {
  std::map<std::string, double> numbers = Read(CertificateFields(), certificate);
  if (!certificate.polygon) return numbers;
  const std::vector<Index>& corners = certificate.polygon->corner_vertices;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    numbers.emplace(fmt::format("corner_vertex_{}", k), corners[k]);
  }
  return numbers;
}

std::map<std::string, double> SecondsOf(const Certificate& certificate) {
  return Read(SecondsFields(), certificate);
}

}  // namespace cirque
