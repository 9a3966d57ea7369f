#include "cirque/remesh/remesh_surface.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "cirque/lattice/flat_domain.h"
#include "cirque/lattice/lattice_map.h"
#include "cirque/remesh/even_triangles.h"
#include "cirque/remesh/flat_mesh.h"
#include "cirque/remesh/lattice_mesh.h"
#include "cirque/remesh/solved_pieces.h"

namespace cirque {
namespace {

constexpr double kTriangle = 0.8660254037844386;  ///< area per vertex of the lattice of edges 1

class SurfaceRemesher {
 public:
  SurfaceRemesher(const Surface& surface, const Parameterization& map, const RemeshOptions& options,
                  const SolveControl& control)
      : surface_(surface),
        options_(options),
        control_(control),
        domain_(map.flat.exact->intrinsic.triangulation, map.flat.exact->lengths),
        pieces_(surface, domain_, *map.exact_map) {
    MeasureScale();
  }

  StatusOr<RemeshedSurface> Run() {
    if (Status s = Check(); !s.ok()) return s;
    if (options_.lattice != MeshLattice::kFree) return MakeLattice();
    // Edges are split and collapsed about a length, which need not be their mean, and those near the
    // boundary, cones and corners are not as the lattice has them: what comes of a length says by how
    // much to ask for another.
    double edge = FirstEdge();
    for (int trial = 0;; ++trial) {
      double excess = 1;
      StatusOr<RemeshedSurface> made = Make(edge, &excess);
      if (!made.ok() || trial == kTrials || std::abs(excess - 1) < kNearEnough) return made;
      edge *= std::clamp(excess, 0.5, 2.);
    }
  }

 private:
  static constexpr int kTrials = 4;
  static constexpr double kNearEnough = 0.005;

  /// Half the log of the flat area over the surface's, at every vertex by its triangles.
  void MeasureScale() {
    const Triangulation& t = domain_.triangulation();
    const Eigen::VectorXd areas = pieces_.SurfaceAreas();
    Eigen::VectorXd flat = Eigen::VectorXd::Zero(t.num_vertices), on_surface = flat;
    for (Index c = 0; c < t.num_halfedges(); ++c) {
      const Index f = Triangulation::Face(c);
      flat[t.vertex[c]] +=
          Cross(domain_.Corner(3 * f), domain_.Corner(3 * f + 1), domain_.Corner(3 * f + 2)) / 2;
      on_surface[t.vertex[c]] += areas[f];
    }
    area_ = areas.sum();
    log_density_ = Eigen::VectorXd::Zero(t.num_vertices);
    if (options_.density.size() > 0) log_density_ = options_.density.array().log();
    if (options_.even_on == EvenOn::kMap) {
      log_scale_.setConstant(t.num_vertices, std::log(domain_.area() / area_) / 2);
    } else {
      log_scale_ = (flat.array() / on_surface.array()).log() / 2;
    }
    weighted_area_ = on_surface.dot(log_density_.array().exp().matrix()) / 3;
  }

  double FirstEdge() const {
    if (options_.edge > 0) return options_.edge;
    return std::sqrt(weighted_area_ / (kTriangle * options_.vertices));
  }

  Status Check() const {
    const double edge = FirstEdge();
    const double expected = weighted_area_ / (kTriangle * edge * edge);
    if (expected <= kMostNewVertices) return Status();
    return Status::InvalidInput(
        fmt::format("edges of {:.3g} on an area of {:.3g} would be {:.2g} vertices; at most {:.2g} "
                    "can be",
                    edge, area_, expected, kMostNewVertices));
  }

  /// Vertices of the boundary where the surface's own turns by more than the option says.
  std::vector<bool> Corners() const {
    const Triangulation& t = surface_.triangulation;
    std::vector<bool> corner(t.num_vertices, false);
    const double least = std::cos(options_.corners * kPi / 180);
    for (const std::vector<Index>& loop : BoundaryLoops(t)) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index before = loop[i], after = loop[(i + 1) % loop.size()];
        const auto& at = surface_.position;
        const Eigen::Vector3d in = (at[t.Tip(before)] - at[t.Tail(before)]).normalized();
        const Eigen::Vector3d out = (at[t.Tip(after)] - at[t.Tail(after)]).normalized();
        if (in.dot(out) < least) corner[t.Tip(before)] = true;
      }
    }
    return corner;
  }

  /// `excess`: by what factor edges should have been longer.
  StatusOr<RemeshedSurface> Make(double edge, double* excess) {
    control_.BeginStage("remeshing");
    FlatMesh mesh(domain_, Corners());
    const SizeField size(domain_,
                         ((log_scale_ - log_density_ / 2).array() + std::log(edge)).matrix());
    if (Status s = MakeEvenTriangles(size, options_.rounds, control_, &mesh); !s.ok()) return s;
    *excess = options_.edge > 0
                  ? options_.edge / (edge * MeanLengthRatio(size, mesh))
                  : std::sqrt(static_cast<double>(mesh.num_alive()) / options_.vertices);
    return OnSurface(mesh, edge * MeanLengthRatio(size, mesh));
  }

  StatusOr<RemeshedSurface> MakeLattice() {
    control_.BeginStage("lattice");
    const bool squares = options_.lattice == MeshLattice::kSquares;
    const LatticeKind kind = squares ? LatticeKind::kSquares : LatticeKind::kTriangles;
    const double scale = std::sqrt(domain_.area() / area_);
    const double edge = options_.edge > 0
                            ? options_.edge
                            : std::sqrt(area_ / (squares ? 1 : kTriangle) / options_.vertices);
    const StatusOr<LatticeMap> map = MakeLatticeMap(domain_, kind, scale * edge);
    if (!map.ok()) return map.status();
    const FlatDomain cells = DomainOf(domain_.triangulation(), map->uv);
    const StatusOr<FlatMesh> mesh = MakeLatticeMesh(cells, kind, *map, control_);
    if (!mesh.ok()) return mesh.status();
    RemeshedSurface made = OnSurface(*mesh, edge);
    if (squares) made.squares = NumberedSquares(*mesh);
    return made;
  }

  static std::vector<std::array<Index, 4>> NumberedSquares(const FlatMesh& mesh) {
    std::vector<Index> kept, number(mesh.num_vertices(), kNone);
    mesh.MakeTriangulation(&kept);
    for (std::size_t i = 0; i < kept.size(); ++i) number[kept[i]] = static_cast<Index>(i);
    std::vector<std::array<Index, 4>> squares = SquaresOf(mesh);
    for (std::array<Index, 4>& square : squares) {
      for (Index& corner : square) corner = number[mesh.VertexAt(corner)];
    }
    return squares;
  }

  RemeshedSurface OnSurface(const FlatMesh& mesh, double edge) const {
    RemeshedSurface made;
    made.edge = edge;
    std::vector<Index> kept;
    made.triangulation = mesh.MakeTriangulation(&kept);
    for (const Index v : kept) {
      const FlatPoint& point = mesh.vertex(v).point;
      const Eigen::Vector3d weight = mesh.domain().Barycentric(point).cwiseMax(0);
      if (mesh.vertex(v).kind == FlatMesh::Kind::kCone)
        made.cones.push_back(static_cast<Index>(made.point.size()));
      made.point.push_back(pieces_.OnSurface(point.face, weight / weight.sum()));
      made.position.push_back(PositionOf(surface_, made.point.back()));
    }
    return made;
  }

  const Surface& surface_;
  const RemeshOptions& options_;
  const SolveControl& control_;
  FlatDomain domain_;
  SolvedPieces pieces_;
  Eigen::VectorXd log_scale_, log_density_;  ///< V
  double area_ = 0, weighted_area_ = 0;      ///< on the surface; the latter times the density
};

Status CheckOptions(const Surface& surface, const Parameterization& map,
                    const RemeshOptions& options) {
  if (!(options.edge > 0) == !(options.vertices > 0)) {
    return Status::InvalidInput("one of a length of edges and a number of vertices is needed");
  }
  if (options.vertices > kMostNewVertices || !std::isfinite(options.edge)) {
    return Status::InvalidInput(
        fmt::format("at most {:.2g} vertices can be asked for", kMostNewVertices));
  }
  const Eigen::Index densities = options.density.size();
  if (densities > 0 && (densities != surface.triangulation.num_vertices ||
                        !(options.density.minCoeff() > 0) || !options.density.allFinite())) {
    return Status::InvalidInput("densities: a positive number a vertex is needed");
  }
  if (!map.exact_map || !map.flat.exact ||
      map.flat.exact->intrinsic.triangulation.num_vertices != surface.triangulation.num_vertices) {
    return {StatusCode::kNotConverged,
            "remeshing: there is no flat metric of the whole surface; leave out free seams"};
  }
  return Status();
}

}  // namespace

const OptionTable<RemeshOptions>& RemeshOptionTable() {
  using O = RemeshOptions;
  static const OptionTable<O> kTable(
      "remesh",
      {Option<O>("edge", &O::edge, "length of edges on the surface")
           .Between(0, 1e300)
           .About("Mesh"),
       Option<O>("vertices", &O::vertices, "about how many vertices, instead of --edge")
           .Between(0, kMostNewVertices)
           .About("Mesh"),
       Option<O>("even", &O::even_on,
                 "where edges are of one length: on the surface, or in the flat metric")
           .About("Mesh"),
       Option<O>("lattice", &O::lattice,
                 "the mesh is this lattice of the flat metric, irregular at cones only; of closed "
                 "surfaces, with --holonomy=pi/2 or pi/3, which it sets")
           .About("Mesh"),
       Option<O>("corners", &O::corners, "vertices stay where the boundary turns by more")
           .Between(0, 180)
           .Unit("degrees")
           .About("Mesh"),
       Option<O>("rounds", &O::rounds, "of splitting, collapsing, turning and moving")
           .Between(1, 1000)
           .About("Mesh")});
  return kTable;
}

StatusOr<RemeshedSurface> RemeshSurface(const Surface& surface, const Parameterization& map,
                                        const RemeshOptions& options, const SolveControl& control) {
  if (Status s = CheckOptions(surface, map, options); !s.ok()) return s;
  return SurfaceRemesher(surface, map, options, control).Run();
}

}  // namespace cirque
