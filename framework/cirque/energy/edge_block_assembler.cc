#include "cirque/energy/edge_block_assembler.h"

#include <algorithm>
#include <utility>

#include "cirque/core/parallel.h"

namespace cirque {
namespace {

constexpr int kUncoupled = -2;  ///< a place of corners without a coupling across their edge

}  // namespace

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

void EdgeBlockAssembler::Clear() {
  ParallelFor(t_.num_halfedges(), [&](Index h) { own_[h] = shared_[h] = 0; });
  diagonal_.resize(0);
}

bool EdgeBlockAssembler::CouplesAsBefore() const {
  if (places_.empty()) return false;
  for (Index h = 0; h < t_.num_halfedges(); ++h) {
    if ((shared_[h] != 0) == (places_[h].other_face == kUncoupled)) return false;
  }
  return true;
}

void EdgeBlockAssembler::FindPlaces(const SparseMatrix& lower) {
  const int* rows = lower.innerIndexPtr();
  const auto place = [&](int column, int row) {
    const int* end = rows + lower.outerIndexPtr()[column + 1];
    return static_cast<int>(std::lower_bound(rows + lower.outerIndexPtr()[column], end, row) -
                            rows);
  };
  coupling_ = CoupledVertices();
  places_.resize(t_.num_halfedges());
  ParallelFor(t_.num_halfedges(), [&](Index h) {
    const Index f = Triangulation::Face(h);
    const int own = constraints_.VertexRow(h);
    places_[h] = {own == kNone ? kNone : place(f, own), kUncoupled, kNone, kNone};
    if (shared_[h] == 0) return;
    const Index g = t_.twin[h], other = Triangulation::Face(g);
    const int vertex = constraints_.VertexRow(g), column = VertexColumn(h);
    places_[h].other_face = other >= f ? place(f, other) : kNone;
    places_[h].other_vertex = vertex == kNone ? kNone : place(f, vertex);
    places_[h].vertices = column == kNone ? kNone : place(column, vertex);
  });
}

/// Every entry is the sum of the same terms in the same order as FaceColumn's and those of
/// FillVertexColumns.
void EdgeBlockAssembler::FillPlaces(SparseMatrix* lower) const {
  const int faces = t_.num_faces(), rows = constraints_.num_rows();
  const int* outer = lower->outerIndexPtr();
  double* value = lower->valuePtr();
  const auto add = [&](int place, double x) {
    if (place != kNone) value[place] += x;
  };
  ParallelFor(faces, [&](Index f) {
    std::fill(value + outer[f], value + outer[f + 1], 0.0);
    value[outer[f]] = AddedToDiagonal(f);
    for (Index h = 3 * f; h < 3 * f + 3; ++h) {
      add(outer[f], own_[h]);
      add(places_[h].own_vertex, own_[h]);
      if (shared_[h] == 0) continue;
      add(places_[h].other_face, shared_[h]);
      add(places_[h].other_vertex, shared_[h]);
    }
  });
  std::fill(value + outer[faces], value + outer[rows], 0.0);
  for (int row = faces; row < rows; ++row) value[outer[row]] = AddedToDiagonal(row);
  for (Index h = 0; h < t_.num_halfedges(); ++h) {
    if (const int row = constraints_.VertexRow(h); row != kNone) value[outer[row]] += own_[h];
  }
  for (const Index h : coupling_) value[places_[h].vertices] += shared_[h];
}

void EdgeBlockAssembler::AssembleAgain(SparseMatrix* lower) {
  if (CouplesAsBefore()) return FillPlaces(lower);
  Assemble(lower);
  FindPlaces(*lower);
}

}  // namespace cirque
