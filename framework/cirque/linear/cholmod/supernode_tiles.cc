#include "cirque/linear/cholmod/supernode_tiles.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>
#include <vector>

#include "cirque/core/lanes.h"

namespace cirque {
namespace {

constexpr int kRows = SupernodeTiles::kRows;
constexpr int kAhead = 512;  ///< numbers; fewer come too late, the factor lies in main memory

[[gnu::always_inline]] inline void ReadAhead(const float* numbers) {
#ifdef __GNUC__
  __builtin_prefetch(numbers);
#endif
}

/// Of a tile, as double: what is added up is never single.
[[gnu::always_inline]] inline double At(const float* tile, int row, int column) {
  return static_cast<double>(tile[kRows * column + row]);
}

template <int kWidth>
[[gnu::always_inline]] inline void SolvePanel(const float* tile, int num_tiles, double* w) {
  std::array<double, kWidth> x;
  for (int j = 0; j < kWidth; ++j) {
    x[j] = w[j];
    for (int i = 0; i < j; ++i) x[j] -= At(tile, j, i) * x[i];
    x[j] /= At(tile, j, j);
  }
  double* const own = w;
  for (int t = 0; t < num_tiles; ++t, tile += kRows * kWidth, w += kRows) {
    ReadAhead(tile + kAhead);
    for (int j = 0; j < kWidth; ++j) {
      for (int row = 0; row < kRows; ++row) w[row] -= At(tile, row, j) * x[j];
    }
  }
  std::copy(x.begin(), x.end(), own);
}

template <int kWidth>
[[gnu::always_inline]] inline void SolvePanelTransposed(const float* first_tile, int num_tiles,
                                                        double* w) {
  double sum[kWidth][kRows] = {};
  for (int t = num_tiles; --t > 0;) {
    const float* tile = first_tile + kRows * kWidth * t;
    ReadAhead(tile - kAhead);
    for (int j = 0; j < kWidth; ++j) {
      for (int row = 0; row < kRows; ++row) sum[j][row] += At(tile, row, j) * w[kRows * t + row];
    }
  }
  for (int j = kWidth; j-- > 0;) {
    double rest = w[j] - ((sum[j][0] + sum[j][1]) + (sum[j][2] + sum[j][3]));
    for (int row = j + 1; row < kRows; ++row) rest -= At(first_tile, row, j) * w[row];
    w[j] = rest / At(first_tile, j, j);
  }
}

/// Calls body(width) with the constant that width is.
template <class Body>
[[gnu::always_inline]] inline void WithWidth(int width, const Body& body) {
  switch (width) {
    case 1:
      return body(std::integral_constant<int, 1>());
    case 2:
      return body(std::integral_constant<int, 2>());
    case 3:
      return body(std::integral_constant<int, 3>());
    default:
      return body(std::integral_constant<int, 4>());
  }
}

}  // namespace

int SupernodeTiles::Width(int first_column) const {
  return std::min(kPanelColumns, columns_ - first_column);
}

std::size_t SupernodeTiles::Size() const {
  std::size_t size = 0;
  for (int k = 0; k < columns_; k += kPanelColumns) size += PanelSize(k);
  return size;
}

void SupernodeTiles::Store(const double* dense, float* tiles) const {
  std::vector<float> panel;
  for (int k = 0; k < columns_; k += kPanelColumns) {
    const int width = Width(k);
    panel.assign(PanelSize(k), 0);
    for (int j = 0; j < width; ++j) {
      const double* column = dense + static_cast<std::size_t>(k + j) * rows_ + k;
      for (int i = j; i < rows_ - k; ++i) {
        panel[(i / kRows * width + j) * kRows + i % kRows] = static_cast<float>(column[i]);
      }
    }
    std::memcpy(tiles, panel.data(), panel.size() * sizeof(float));
    tiles += panel.size();
  }
}

void SupernodeTiles::Solve(const float* tiles, double* w) const {
  OnWideLanes([&]() __attribute__((always_inline)) {
    for (int k = 0; k < columns_; k += kPanelColumns) {
      WithWidth(
          Width(k), [&](auto width) __attribute__((always_inline)) {
            SolvePanel<width>(tiles, NumTiles(k), w + k);
          });
      tiles += PanelSize(k);
    }
  });
}

void SupernodeTiles::SolveTransposed(const float* tiles, double* w) const {
  const float* end = tiles + Size();
  OnWideLanes([&]() __attribute__((always_inline)) {
    for (int k = (columns_ - 1) / kPanelColumns * kPanelColumns; k >= 0; k -= kPanelColumns) {
      end -= PanelSize(k);
      WithWidth(
          Width(k), [&](auto width) __attribute__((always_inline)) {
            SolvePanelTransposed<width>(end, NumTiles(k), w + k);
          });
    }
  });
}

}  // namespace cirque
