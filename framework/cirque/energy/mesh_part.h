#pragma once

#include <vector>

#include "cirque/core/triangulation.h"
#include "cirque/linear/ranks.h"

namespace cirque {

/// What one rank has of a triangulated surface and of the parameters on it: one a face, and one for
/// each of some vertices. Its own faces with all around their vertices and across the edges of
/// those, so that whatever an energy says of the rank's own parameters it says from this part as it
/// would from the whole.
struct MeshPart {
  Triangulation triangulation;  ///< faces and vertices in the order of the whole; edges that lead
                                ///< out of the part are boundary
  std::vector<int> number;      ///< by local parameter (those of faces, then of vertices): in the
                                ///< order of the ranks that own them
  std::vector<int> first;       ///< per rank the first number of what it owns, and the end
  std::vector<Index> face;      ///< their numbers in the whole, increasing; on the first rank
  std::vector<Index> vertex;    ///< likewise
  std::vector<int> parameter;   ///< likewise, by local parameter

  /// All but what is the first rank's.
  void Send(Ranks* ranks, int to) const;
  static MeshPart Receive(Ranks* ranks);
};

/// A surface on its way to the ranks. The faces in the order of a breadth-first search from its rim,
/// which a part's border then is short in whatever their numbers are, are shared out in equal runs;
/// to a rank belong the parameters of its faces and of the vertices whose first corner is in one.
class MeshPartition {
 public:
  /// `vertex_parameter`: per vertex, kNone without; increasing, behind those of the faces. All
  /// without: an empty vector, and a part then has only what lies across its own faces' edges.
  MeshPartition(const Triangulation& triangulation, std::vector<int> vertex_parameter,
                int num_ranks);

  MeshPart Part(int rank) const;

  /// Who owns a parameter.
  int OwnerOfFace(Index face) const { return face_owner_[face]; }
  int OwnerOfVertex(Index vertex) const { return vertex_owner_[vertex]; }

 private:
  bool HasParameter(Index vertex) const {
    return !vertex_parameter_.empty() && vertex_parameter_[vertex] != kNone;
  }
  std::vector<bool> FacesOf(int rank) const;
  void TakeFaces(int rank, MeshPart* part) const;
  void NumberParameters(MeshPart* part) const;

  const Triangulation& t_;
  const std::vector<int> vertex_parameter_;
  std::vector<int> face_owner_, face_number_;
  std::vector<int> vertex_owner_, vertex_number_;  ///< numbers of those with a parameter
  std::vector<int> first_;                         ///< as in MeshPart
};

}  // namespace cirque
