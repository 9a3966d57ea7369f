#include "cirque/domains/map_mesh.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "cirque/core/count.h"
#include "cirque/core/text.h"
#include "cirque/domains/atlas.h"
#include "cirque/domains/map_components.h"
#include "cirque/domains/mesh_pieces.h"
#include "cirque/intrinsic/intrinsic_surface.h"
#include "cirque/mesh/holes.h"
#include "cirque/pipeline/exact_layout.h"
#include "cirque/pipeline/finish_layout.h"

namespace cirque {
namespace {

/// The mesh on its way to its map.
class MeshMapper {
 public:
  MeshMapper(std::shared_ptr<const MeshParts> mesh, const MeshOptions& options,
             const SolveControl& control)
      : mesh_(std::move(mesh)), options_(options), control_(control) {
    for (const MeshComponent& part : mesh_->components) {
      ComponentSummary component{part.first_polygon, part.num_polygons, 0};
      if (part.surface.ok()) component.vertices = part.surface->triangulation.num_vertices;
      pieces_.push_back({part, component});
    }
  }

  StatusOr<MappedMesh> Map(const SurfaceRequest& request) {
    if (Status s = FillHolesOfAll(); !s.ok()) return s;
    if (Status s = MapAll(request); !s.ok()) return s;
    if (mesh_->IsOne()) {
      GatherOne();
    } else {
      GatherSeveral();
    }
    Certificate& certificate = result_.map.certificate;
    if (!mesh_->repair.ChangesNothing()) certificate.mesh_repair = mesh_->repair;
    certificate.seconds.preflight = mesh_->seconds;
    return std::move(result_);
  }

 private:
  Status FillHolesOfAll() {
    if (!options_.fill_holes) return Status();
    for (MeshPiece& piece : pieces_) {
      if (!piece.IsSurface()) continue;
      StatusOr<FilledSurface> filled = FillHoles(*piece.of.surface, KeptLoops::kLongest);
      if (!filled.ok()) return filled.status();
      result_.num_filled_loops += filled->num_filled_loops;
      piece.filled = *std::move(filled);
    }
    return Status();
  }

  Status MapAll(const SurfaceRequest& request) {
    std::vector<MeshPiece*> sound;
    for (MeshPiece& piece : pieces_) {
      if (piece.IsSurface()) {
        sound.push_back(&piece);
      } else {
        Refuse(&piece);
      }
    }
    const Timer timer;
    if (!sound.empty()) {
      if (Status s = MapSound(request, sound); !s.ok()) return s;
    }
    seconds_ = timer.Seconds();
    for (MeshPiece& piece : pieces_) {
      if (piece.mapped.status.code() == StatusCode::kCancelled) return piece.mapped.status;
      if (piece.HasMap()) mapped_.push_back(&piece);
    }
    return Status();
  }

  Status MapSound(const SurfaceRequest& request, const std::vector<MeshPiece*>& sound) {
    std::vector<const Surface*> surfaces;
    for (const MeshPiece* piece : sound) surfaces.push_back(&piece->Solved());
    StatusOr<std::vector<MapRequest>> requests = RequestsOf(request, surfaces);
    if (!requests.ok()) return requests.status();
    if (Status s = CheckSeveral(requests->front()); !s.ok()) return s;
    for (std::size_t i = 0; i < sound.size(); ++i) sound[i]->request = std::move((*requests)[i]);
    MapPieces(sound, control_);
    return Status();
  }

  Status CheckSeveral(const MapRequest& request) const {
    if (mesh_->IsOne()) return Status();
    const StatusOr<Domain> domain = Domains().Find(request.domain);
    if (!domain.ok()) return domain.status();
    if (!request.shape.pins.empty()) {
      return Status::InvalidInput(fmt::format(
          "pins take one component; the mesh has {}: keep one of them", mesh_->Sizes()));
    }
    if (domain->Gives("uv")) return Status();
    return Status::InvalidInput(
        fmt::format("the domain {} takes one component; the mesh has {}: keep one of them, or map "
                    "them to the plane",
                    request.domain, mesh_->Sizes()));
  }

  static void Refuse(MeshPiece* piece) {
    piece->mapped.status = piece->of.surface.status();
    Certificate& certificate = piece->mapped.map.certificate;
    certificate.outcome = ToString(piece->mapped.status.code());
    certificate.message = piece->mapped.status.message();
    certificate.component = piece->component;
  }

  void GatherOne() {
    MeshPiece& piece = pieces_[0];
    ArrangedAtlas atlas;
    if (piece.HasMap() && !piece.mapped.map.IsOnSphere()) {
      atlas = ArrangePieces(FrameOf(options_), control_, &mapped_);
    } else if (piece.HasMap() && piece.filled) {
      piece.mapped.map.uv = WithoutFill(*piece.filled, piece.mapped.map.uv);
    }
    result_.status = piece.mapped.status;
    result_.map = std::move(piece.mapped.map);
    SurfaceMap& map = result_.map;
    if (piece.HasMap()) {
      result_.surface = {mesh_, &*piece.of.surface};
      if (!map.IsOnSphere()) Fill(&map.certificate.layout).area_used = atlas.area_used;
      if (map.exact_map && !map.IsOnSphere()) ArrangeExact({{piece.Solved(), &*map.exact_map}});
      result_.solved_surface =
          piece.filled ? std::make_shared<const Surface>(std::move(piece.filled->surface))
                       : result_.surface;
    }
    if (!map.certificate.infeasibility.empty()) KeepProofSurface(&piece);
  }

  void GatherSeveral() {
    const ArrangedAtlas atlas = ArrangePieces(FrameOf(options_), control_, &mapped_);
    std::vector<Certificate> certificates;
    for (MeshPiece& piece : pieces_) {
      certificates.push_back(std::move(piece.mapped.map.certificate));
    }
    Certificate& certificate = result_.map.certificate;
    certificate = SummarizeComponents(std::move(certificates));
    certificate.atlas->atlas_patches = atlas.patches;
    if (!mapped_.empty()) Fill(&certificate.layout).area_used = atlas.area_used;
    certificate.seconds.total = seconds_;
    result_.status = WorstOfSeveral(certificate);
    TakeProof(&certificate);
    if (!mapped_.empty()) JoinMaps();
  }

  /// Puts exact maps into the frame; false, and none is left, where rounding forbids it.
  bool ArrangeExact(const std::vector<ExactPiece>& pieces) {
    const Status status = ArrangeAtlas(FrameOf(options_), pieces);
    if (status.ok()) return true;
    result_.status = status;
    result_.map.certificate.outcome = ToString(status.code());
    result_.map.certificate.message = status.message();
    result_.map.exact_map.reset();
    return false;
  }

  void JoinMaps() {
    std::vector<const Surface*> surfaces;
    std::vector<const CornerUv*> uvs;
    for (const MeshPiece* piece : mapped_) {
      surfaces.push_back(&*piece->of.surface);
      uvs.push_back(&piece->mapped.map.uv);
    }
    auto joined = std::make_shared<const Surface>(Joined(surfaces));
    result_.map.uv = Joined(uvs);
    result_.map.certificate.distortion =
        DistortionOf(joined->triangulation, MeasureEdgeLengths(*joined), result_.map.uv);
    result_.surface = result_.solved_surface = std::move(joined);
    if (mapped_.front()->mapped.map.exact_map) JoinExactMaps();
  }

  void JoinExactMaps() {
    std::vector<ExactPiece> pieces;
    std::vector<const Surface*> surfaces;
    double faces = 0;
    for (MeshPiece* piece : mapped_) {
      pieces.push_back({piece->Solved(), &*piece->mapped.map.exact_map});
      surfaces.push_back(&piece->Solved());
      const Certificate& own = result_.map.certificate.components[piece - pieces_.data()];
      faces += own.exact_map->exact_faces_ratio * piece->Solved().triangulation.num_faces();
    }
    if (!ArrangeExact(pieces)) return;
    result_.map.exact_map = Joined(pieces);
    auto joined = std::make_shared<const Surface>(Joined(surfaces));
    const EdgeLengths lengths = MeasureEdgeLengths(*joined);
    const DistortionSummary distortion =
        DistortionOf(MeasureSurface(joined->triangulation, lengths), *result_.map.exact_map);
    ExactMapSummary& summary = Fill(&result_.map.certificate.exact_map);
    summary.exact_quasi_conformal_mean = distortion.quasi_conformal_mean;
    summary.exact_quasi_conformal_max = distortion.quasi_conformal_max;
    summary.exact_log_area_ratio_l2 = distortion.log_area_ratio_l2;
    summary.exact_faces_ratio = faces / joined->triangulation.num_faces();
    result_.solved_surface = std::move(joined);
  }

  Status WorstOfSeveral(const Certificate& all) const {
    for (const MeshPiece& piece : pieces_) {
      const Status& own = piece.mapped.status;
      if (own.ok() || ToString(own.code()) != all.outcome || own.message() != all.message) continue;
      return {own.code(), fmt::format("{} of {} components without a map; {} from face {} on: {}",
                                      pieces_.size() - mapped_.size(), pieces_.size(),
                                      Count(piece.component.faces, "face"),
                                      piece.component.first_face + 1, own.message())};
    }
    return Status();
  }

  /// The first proof of a component's is that of the whole.
  void TakeProof(Certificate* all) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      if (all->components[i].infeasibility.empty()) continue;
      all->infeasibility = all->components[i].infeasibility;
      return KeepProofSurface(&pieces_[i]);
    }
  }

  void KeepProofSurface(MeshPiece* piece) {
    result_.proof_surface = piece->filled
                                ? std::make_shared<const Surface>(std::move(piece->filled->surface))
                                : std::shared_ptr<const Surface>(mesh_, &*piece->of.surface);
  }

  std::shared_ptr<const MeshParts> mesh_;
  const MeshOptions& options_;
  const SolveControl& control_;
  std::vector<MeshPiece> pieces_;
  std::vector<MeshPiece*> mapped_;
  double seconds_ = 0;
  MappedMesh result_;
};

}  // namespace

std::vector<const Surface*> MeshParts::Surfaces() const {
  std::vector<const Surface*> surfaces;
  for (const MeshComponent& component : components) {
    if (component.surface.ok()) surfaces.push_back(&*component.surface);
  }
  return surfaces;
}

std::string MeshParts::Sizes() const {
  constexpr std::size_t kListed = 10;
  std::vector<std::string> words;
  for (std::size_t i = 0; i < std::min(components.size(), kListed); ++i) {
    words.push_back(fmt::format("{} from face {} on", Count(components[i].num_polygons, "face"),
                                components[i].first_polygon + 1));
  }
  if (components.size() > kListed) {
    words.push_back(fmt::format("and {} more", components.size() - kListed));
  }
  return fmt::format("{} ({})", components.size(), Join(words));
}

Status TakeApart(const PolygonSoup& soup, const std::string& repair, MeshParts* parts) {
  const Timer timer;
  const StatusOr<RepairOptions> options = ParseRepair(repair);
  if (!options.ok()) return options.status();
  StatusOr<std::vector<MeshComponent>> components =
      SurfacesOf(soup, *options, &parts->report, &parts->repair);
  if (components.ok()) parts->components = *std::move(components);
  parts->seconds = timer.Seconds();
  return components.status();
}

StatusOr<MappedMesh> MapMesh(const std::shared_ptr<const MeshParts>& mesh,
                             const MeshOptions& options, const SurfaceRequest& request,
                             const SolveControl& control) {
  return MeshMapper(mesh, options, control).Map(request);
}

}  // namespace cirque
