#include "cirque/energy/dual_laplacian.h"

#include <algorithm>
#include <array>

#include "cirque/core/parallel.h"
#include "cirque/energy/assemble_lower.h"

namespace cirque {

void LaplacianAssembler::Assemble(SparseMatrix* lower) const {
  AssembleLower(
      num_nodes_,
      [&](const auto& add) {
        for (int i = 0; i < num_nodes_; ++i) add(i, i, 0.0);
        for (const auto& [i, j, weight] : edges_) {
          add(i, i, weight);
          add(j, j, weight);
          add(std::max(i, j), std::min(i, j), -weight);
        }
      },
      lower);
}

namespace {

/// The larger faces across the edges of f, each once, in increasing order.
class LargerNeighbours {
 public:
  LargerNeighbours(const Triangulation& t, Index f) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (t.twin[h] == kNone) continue;
      const Index g = Triangulation::Face(t.twin[h]);
      if (g > f && std::find(begin(), end(), g) == end()) Insert(g);
    }
  }

  int size() const { return size_; }
  const Index* begin() const { return face_.data(); }
  const Index* end() const { return face_.data() + size_; }
  int Rank(Index g) const { return static_cast<int>(std::find(begin(), end(), g) - begin()); }

 private:
  void Insert(Index g) {
    int k = size_++;
    for (; k > 0 && face_[k - 1] > g; --k) face_[k] = face_[k - 1];
    face_[k] = g;
  }

  std::array<Index, 3> face_;
  int size_ = 0;
};

}  // namespace

DualLaplacian::DualLaplacian(const Triangulation& t)
    : pattern_(t.num_faces(), t.num_faces()), slot_(t.num_halfedges(), kNone) {
  const int faces = t.num_faces();
  int* outer = pattern_.outerIndexPtr();
  pattern_.resizeNonZeros(faces + t.num_edges());
  int* const inner = pattern_.innerIndexPtr();
  int entries = 0;
  for (Index f = 0; f < faces; ++f) {
    outer[f] = entries;
    const LargerNeighbours neighbours(t, f);
    inner[entries++] = f;
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      const Index g = t.twin[h] == kNone ? f : Triangulation::Face(t.twin[h]);
      if (g > f) slot_[h] = entries + neighbours.Rank(g);
    }
    entries =
        static_cast<int>(std::copy(neighbours.begin(), neighbours.end(), inner + entries) - inner);
  }
  outer[faces] = entries;
  pattern_.resizeNonZeros(entries);
  std::fill_n(pattern_.valuePtr(), entries, 0.0);
  couples_.reserve(t.num_halfedges());
  for (Index h = 0; h < t.num_halfedges(); ++h) {
    couples_.push_back(t.twin[h] != kNone &&
                       Triangulation::Face(t.twin[h]) != Triangulation::Face(h));
  }
}

void DualLaplacian::Assemble(const Eigen::VectorXd& weight, SparseMatrix* lower) const {
  *lower = pattern_;
  double* value = lower->valuePtr();
  const int* outer = lower->outerIndexPtr();
  ParallelFor(static_cast<int>(pattern_.cols()), [&](int f) {
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      if (!couples_[h]) continue;
      value[outer[f]] += weight[h];
      if (slot_[h] != kNone) value[slot_[h]] -= weight[h];
    }
  });
}

}  // namespace cirque
