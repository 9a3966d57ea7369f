#include "cirque/energy/edge_block_assembler.h"

#include <algorithm>
#include <utility>

#include "cirque/core/parallel.h"

namespace cirque {

/// The entries of a triangle's column: itself, triangles across its edges, vertices of both.
class EdgeBlockAssembler::FaceColumn {
 public:
  FaceColumn(const EdgeBlockAssembler& d, Index f) {
    Add(f, d.AddedToDiagonal(f));
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      Add(f, d.own_[h]);
      AddVertex(d, h, d.own_[h]);
      if (d.shared_[h] == 0) continue;
      const Index g = d.t_.twin[h], other = Triangulation::Face(g);
      if (other >= f) Add(other, d.shared_[h]);
      AddVertex(d, g, d.shared_[h]);
    }
  }

  int size() const { return size_; }

  void Write(int* row, double* value) const {
    for (int k = 0; k < size_; ++k) {
      row[k] = entry_[k].first;
      value[k] = entry_[k].second;
    }
  }

 private:
  static constexpr int kMost = 10;  ///< itself, three triangles, six vertices

  void AddVertex(const EdgeBlockAssembler& d, Index h, double x) {
    if (const int row = d.constraints_.VertexRow(h); row != kNone) Add(row, x);
  }

  /// Each entry sinks to its place as it comes; equal ones are added up.
  void Add(int row, double x) {
    int k = size_;
    while (k > 0 && entry_[k - 1].first > row) --k;
    if (k > 0 && entry_[k - 1].first == row) {
      entry_[k - 1].second += x;
      return;
    }
    std::copy_backward(entry_ + k, entry_ + size_, entry_ + size_ + 1);
    entry_[k] = {row, x};
    ++size_;
  }

  std::pair<int, double> entry_[kMost];
  int size_ = 0;
};

EdgeBlockAssembler::EdgeBlockAssembler(const AngleConstraints& constraints)
    : constraints_(constraints),
      t_(constraints.triangulation()),
      own_(t_.num_halfedges()),
      shared_(t_.num_halfedges()) {
  ParallelFor(t_.num_halfedges(), [&](Index h) { own_[h] = shared_[h] = 0; });
}

/// The column of the entry between the vertices at h and across its edge, kNone when there is none
/// or h is not the one that gives it.
int EdgeBlockAssembler::VertexColumn(Index h) const {
  if (shared_[h] == 0) return kNone;
  const int a = constraints_.VertexRow(h), b = constraints_.VertexRow(t_.twin[h]);
  return b == kNone || a == kNone || a > b ? kNone : a;
}

/// The corners that couple two vertices, by their column.
std::vector<int> EdgeBlockAssembler::CoupledVertices() const {
  std::vector<std::vector<std::pair<int, Index>>> of_block(NumBlocks(t_.num_halfedges()));
  ForEachBlock(t_.num_halfedges(), [&](int block, Index begin, Index end) {
    for (Index h = begin; h < end; ++h) {
      if (const int column = VertexColumn(h); column != kNone) {
        of_block[block].emplace_back(column, h);
      }
    }
  });
  std::vector<std::pair<int, Index>> by_column;
  for (const auto& found : of_block) by_column.insert(by_column.end(), found.begin(), found.end());
  std::sort(by_column.begin(), by_column.end(), [&](const auto& a, const auto& b) {
    const auto key = [&](const auto& entry) {
      return std::pair(entry.first, constraints_.VertexRow(t_.twin[entry.second]));
    };
    return key(a) < key(b);
  });
  std::vector<int> corners;
  for (const auto& [column, h] : by_column) corners.push_back(h);
  return corners;
}

int EdgeBlockAssembler::NumInColumn(Index f) const {
  const bool couples = (shared_.segment<3>(3 * f).array() != 0).any();
  if (couples) return FaceColumn(*this, f).size();
  const int a = constraints_.VertexRow(3 * f), b = constraints_.VertexRow(3 * f + 1);
  const int c = constraints_.VertexRow(3 * f + 2);
  return 1 + (a != kNone) + (b != kNone && b != a) + (c != kNone && c != a && c != b);
}

void EdgeBlockAssembler::FillFaceColumns(SparseMatrix* lower) const {
  int* outer = lower->outerIndexPtr();
  ParallelFor(t_.num_faces(), [&](int f) {
    FaceColumn(*this, f).Write(lower->innerIndexPtr() + outer[f], lower->valuePtr() + outer[f]);
  });
}

/// The vertices' columns, one after another: the diagonal, then what active edges couple.
void EdgeBlockAssembler::FillVertexColumns(const std::vector<int>& coupling,
                                           SparseMatrix* lower) const {
  const int faces = t_.num_faces(), rows = constraints_.num_rows();
  Eigen::VectorXd diagonal(rows - faces);
  for (int row = faces; row < rows; ++row) diagonal[row - faces] = AddedToDiagonal(row);
  for (Index h = 0; h < t_.num_halfedges(); ++h) {
    if (const int row = constraints_.VertexRow(h); row != kNone) diagonal[row - faces] += own_[h];
  }
  int *outer = lower->outerIndexPtr(), *inner = lower->innerIndexPtr();
  double* value = lower->valuePtr();
  int end = outer[faces];
  auto next = coupling.begin();
  for (int column = faces; column < rows; ++column) {
    outer[column] = end;
    inner[end] = column;
    value[end++] = diagonal[column - faces];
    for (; next != coupling.end() && constraints_.VertexRow(*next) == column; ++next) {
      const int row = constraints_.VertexRow(t_.twin[*next]);
      if (inner[end - 1] != row) inner[end] = row, value[end++] = 0;
      value[end - 1] += shared_[*next];
    }
  }
  outer[rows] = end;
}

void EdgeBlockAssembler::Assemble(SparseMatrix* lower) const {
  const int faces = t_.num_faces(), rows = constraints_.num_rows();
  const std::vector<int> coupling = CoupledVertices();
  lower->resize(rows, rows);
  int* outer = lower->outerIndexPtr();
  outer[0] = 0;
  ParallelFor(faces, [&](int f) { outer[f + 1] = NumInColumn(f); });
  for (int f = 0; f < faces; ++f) outer[f + 1] += outer[f];
  lower->resizeNonZeros(outer[faces] + (rows - faces) + static_cast<int>(coupling.size()));
  FillFaceColumns(lower);
  FillVertexColumns(coupling, lower);
  lower->resizeNonZeros(outer[rows]);
}

}  // namespace cirque
