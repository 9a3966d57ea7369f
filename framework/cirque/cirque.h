#pragma once

/// The library's public interface: this header and those that it reaches, which are the ones that
/// are installed (framework/public_headers.txt). All angles are in radians; vertices, faces and
/// halfedges count from 0; what can fail for a reason that a user should hear returns a Status.
///
///   MapSurface(V, F)         arrays to their map, one call       domains/map_arrays.h
///   JudgeMap                 anybody's map, judged               verify/judge_map.h
///   SurfaceFromTriangles     a surface of two arrays             mesh/preflight.h
///   ReadMesh, Preflight      a surface from a file               io/io.h, mesh/preflight.h
///   SurfacesOf               its components, repaired           mesh/preflight.h
///   GenerateMesh             one made by a formula               generators/generators.h
///   MapSurface               a surface to its map                domains/domain.h
///   MapOptions               how, repair and atlas included      domains/map_options.h
///   TransferTexture          from one map to another             domains/transfer.h
///   ParameterizeOptions      how                                 pipeline/options.h
///   MeasureMap               how good a map is                   metrics/measure_map.h
///   AttachUv, WriteMesh      a map into a file                   mesh/surface.h, io/io.h
///   Energy, Energies         the energies, and one's own         energy/energy.h, energy/registry.h
///   CirclePatternEnergy      that of circle patterns             energy/circle_pattern_energy.h
///   ConeHeuristics           where cones lie, and one's own      cones/registry.h
///   CutHeuristics            where it is opened, and one's own   cuts/registry.h
///   AngleObjective           what angles are fitted by           energy/angle_objective.h
///   SolverStrategies         what minimises them                 solver/solver_strategy.h
///   AuditEnergy              what judges them                    audit/audit_energy.h
///
/// A registry is a value: `Energies().With("mine", factory)` is one with an energy more.
/// The mathematics is in docs/mathematics.md, the structure in docs/architecture.md.

#include "cirque/audit/audit_energy.h"
#include "cirque/cones/registry.h"
#include "cirque/core/version.h"
#include "cirque/cuts/registry.h"
#include "cirque/domains/domain.h"
#include "cirque/domains/map_arrays.h"
#include "cirque/domains/map_options.h"
#include "cirque/domains/transfer.h"
#include "cirque/energy/angle_objective.h"
#include "cirque/energy/circle_pattern_energy.h"
#include "cirque/energy/registry.h"
#include "cirque/generators/generators.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/io/con_file.h"
#include "cirque/io/io.h"
#include "cirque/mesh/preflight.h"
#include "cirque/metrics/measure_map.h"
#include "cirque/solver/solver_strategy.h"
#include "cirque/verify/judge_map.h"
