#include "cirque/domains/mesh_pieces.h"

#include <string>
#include <utility>

namespace cirque {
namespace {

constexpr const char* kConesForFrame[] = {"curvature_peaks:share=0.5", "curvature_peaks:share=1"};

void DropFill(MeshPiece* piece) {
  SurfaceMap& map = piece->mapped.map;
  if (piece->filled) map.uv = WithoutFill(*piece->filled, map.uv);
}

bool MayChooseCones(const MeshPiece& piece) {
  const ParameterizeOptions& options = piece.request.options;
  const bool ours = piece.with_cones_for_frame || !options.AsksForCones();
  return ours && !options.strict && !piece.request.targets && piece.request.domain == "plane";
}

void GiveUp(MeshPiece* piece) {
  MappedComponent& mapped = piece->mapped;
  mapped.status = {StatusCode::kUnrepresentable,
                   "its scale ranges over so much that rounding turns triangles over where the "
                   "frame has them; map this component alone, as_is, or with more cones"};
  mapped.map.certificate.outcome = ToString(mapped.status.code());
  mapped.map.certificate.message = mapped.status.message();
}

/// The pieces again, with cones of a heuristic; null: given up.
void MapAgain(const std::vector<MeshPiece*>& pieces, const char* cones,
              const SolveControl& control) {
  std::vector<MeshPiece*> again;
  for (MeshPiece* piece : pieces) {
    if (cones == nullptr || !MayChooseCones(*piece)) {
      GiveUp(piece);
      continue;
    }
    piece->with_cones_for_frame = true;
    piece->request.options.cones = cones;
    again.push_back(piece);
  }
  if (again.empty()) return;
  MapPieces(again, control);
  for (MeshPiece* piece : again) {
    piece->mapped.map.certificate.component = piece->component;
    if (piece->HasMap()) DropFill(piece);
  }
}

/// One arrangement; where triangles are lost all maps stay where they are.
ArrangedAtlas TryToArrange(const UvFrame& frame, const std::vector<MeshPiece*>& pieces) {
  const bool moves = !LeavesInPlace(frame, pieces.size());
  std::vector<CornerUv> own;
  std::vector<PlanarPiece> planar;
  for (MeshPiece* piece : pieces) {
    SurfaceMap& map = piece->mapped.map;
    if (moves) own.push_back(map.uv);
    planar.emplace_back(*piece->of.surface, map.cut, &map.uv);
  }
  ArrangedAtlas atlas = ArrangeAtlas(frame, planar);
  if (atlas.lost.empty()) return atlas;
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i]->mapped.map.uv = std::move(own[i]);
  return atlas;
}

}  // namespace

void MapPieces(const std::vector<MeshPiece*>& pieces, const SolveControl& control) {
  std::vector<ComponentJob> jobs;
  for (const MeshPiece* piece : pieces) {
    jobs.push_back({piece->Solved(), piece->request, piece->component});
  }
  std::vector<MappedComponent> mapped = MapComponents(jobs, control);
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i]->mapped = std::move(mapped[i]);
}

ArrangedAtlas ArrangePieces(const UvFrame& frame, const SolveControl& control,
                            std::vector<MeshPiece*>* pieces) {
  for (MeshPiece* piece : *pieces) DropFill(piece);
  for (std::size_t round = 0;; ++round) {
    ArrangedAtlas atlas = TryToArrange(frame, *pieces);
    if (atlas.lost.empty()) return atlas;
    std::vector<MeshPiece*> lost;
    for (const std::size_t i : atlas.lost) lost.push_back((*pieces)[i]);
    MapAgain(lost, round < std::size(kConesForFrame) ? kConesForFrame[round] : nullptr, control);
    std::erase_if(*pieces, [](const MeshPiece* piece) { return !piece->HasMap(); });
  }
}

}  // namespace cirque
