#pragma once

#include <cstddef>

namespace cirque {

/// The triangular solves of one supernode of a Cholesky factor with its numbers in single
/// precision. Its lower trapezoid of `rows` rows and `columns` columns is stored by panels of four
/// columns, the last of as many as are left; a panel from its diagonal down by tiles of four rows,
/// and a tile by columns. So memory is read as it lies, forwards or backwards, and nothing is read
/// that is not needed but what fills up the last tile: zeros.
class SupernodeTiles {
 public:
  static constexpr int kRows = 4;          ///< of a tile
  static constexpr int kPanelColumns = 4;  ///< at most

  SupernodeTiles(int rows, int columns) : rows_(rows), columns_(columns) {}

  /// How many numbers they are.
  std::size_t Size() const;

  /// Stores the trapezoid of a dense matrix, whose rows are contiguous in each column. `tiles` may
  /// lie where the matrix does, or before, if that has three rows.
  void Store(const double* dense, float* tiles) const;

  /// How many numbers of a vector of the rows the solves touch: those of whole tiles.
  int NumPadded() const { return rows_ + kRows - 1; }

  /// w of the columns becomes L^-1 w, and is taken out of that of the rows below.
  void Solve(const float* tiles, double* w) const;

  /// w of the columns becomes L^-T w, given that of the rows below.
  void SolveTransposed(const float* tiles, double* w) const;

 private:
  int Width(int first_column) const;
  int NumTiles(int first_column) const { return (rows_ - first_column + kRows - 1) / kRows; }
  std::size_t PanelSize(int first_column) const {
    return static_cast<std::size_t>(Width(first_column)) * kRows * NumTiles(first_column);
  }

  int rows_, columns_;
};

}  // namespace cirque
