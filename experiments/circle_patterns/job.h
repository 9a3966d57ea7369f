#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "cirque/core/option_table.h"
#include "cirque/core/solve_summary.h"
#include "cirque/core/status.h"
#include "cirque/domains/map_options.h"
#include "cirque/io/con_file.h"
#include "cirque/metrics/measure_files.h"
#include "cirque/pipeline/options.h"

namespace cirque {

/// The shape to map onto, as the flags say it.
struct DomainRequest {
  std::string name = "plane";
  OptionMap shape;  ///< of DomainOptionTable(), vertices by their numbers in the file, from 1
};

/// What the program was asked to do.
struct CirclePatternsJob {
  std::string input, output;
  std::string input_con;     ///< an intrinsic metric instead of `input`
  bool layout_only = false;  ///< the metric of `input_con` is flat: cut and lay it out as it is
  std::string cones;         ///< file of `vertex min max` in multiples of pi; empty: none
  std::string angle_sums;    ///< file of one target angle sum [rad] per vertex; empty: none
  std::string cut;           ///< file of edges `from to face` to open; empty: a short cut is found
  std::string cut_paths;  ///< "a-b,c-d": vertices, counted from 1, to open shortest paths between
  std::string rotations;  ///< file of `rotation face face ...`, loops; empty: none
  bool meet_rotations = false;  ///< these are met, not only measured
  std::string con;              ///< where to write the flat intrinsic metric; empty: nowhere
  ConForm con_form = ConForm::kNeighbours;
  bool overwrite = false;   ///< outputs may be inputs
  bool flip_back = false;   ///< `con` after undoing the flips that can be in the flat metric
  std::string certificate;  ///< where to write it; empty: beside the output unless all is well
  std::string view;         ///< .html to write with a viewer of the map; empty: none
  std::string picture;      ///< .svg or .png to write, FILE:MEASURE with its colours; empty: none
  std::string latlong;      ///< .obj to write with latitude and longitude as texture; empty: none
  std::string exact;        ///< where to write the exact map (RefineByExactMap); empty: nowhere
  std::string projective;   ///< .obj with its homogeneous texture coordinates; empty: nowhere
  std::vector<MeasureFile> measures;  ///< of the map that is written, on the triangles written
  ParameterizeOptions options;
  DomainRequest domain;
  MeshOptions mesh;
};

inline bool AsksForExact(const CirclePatternsJob& job) {
  return !job.exact.empty() || !job.projective.empty();
}

/// Reads, checks, repairs, flattens and writes, telling `report` what it finds. Of several
/// components each is mapped by itself; the status is the worst of theirs (SummarizeComponents),
/// and what has a map is written. The output is written only for a map that the checks accept. The
/// certificate is written where the job asks for it, and where the mesh could be read but its
/// outcome is not ok, beside it the carriers of an infeasibility certificate; none of them when
/// `control` cancels.
Status RunOnMesh(const CirclePatternsJob& job, const SolveControl& control, std::ostream& report);

/// The same for an intrinsic metric from a CON file. The output's points are the map's own: (u, v,
/// 0) for every vertex of the surface opened along the cut.
Status RunOnMetric(const CirclePatternsJob& job, const SolveControl& control, std::ostream& report);

}  // namespace cirque
