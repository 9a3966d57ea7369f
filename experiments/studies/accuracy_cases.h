#pragma once

#include <string>
#include <vector>

#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// One refinement level: what a map came to beside what it should.
struct AccuracyRow {
  Index triangles = 0;
  double value = 0;  ///< rms distance from the known map, or modulus
  double error = 0;
};

/// A generated surface whose known image is a disk about 0.
struct DiskCase {
  std::string generator;
  double radius = 1;  ///< of the image
  Index triangles = 0;
  double pole = -1;  ///< part of the way round the boundary, from its first halfedge on, of the
                     ///< vertex that the solve sends to infinity; below 0: chosen
  std::string refine_map = "auto";  ///< MapOptions::refine_map
};

/// How far the unit-disk map of a generated surface is from its known map, which is first followed
/// by the disk automorphism that puts the same vertex at 0 and the same vertex at (1, 0): root mean
/// square over vertices.
StatusOr<AccuracyRow> DiskError(const DiskCase& disk);

/// Points with corner vertices and the conformal modulus that a rectangle map should report.
struct Quadrilateral {
  PolygonSoup soup;
  std::vector<Index> corners;
  double modulus = 0;
};

/// {r <= |z| <= R, 0 <= arg z <= angle}: modulus log(R / r) / angle. 2 n^2 triangles, n even; inner
/// vertices moved by up to a fifth of a cell.
Quadrilateral AnnulusSector(int n, double ratio, double angle);

/// The L of the three unit squares [0, 2] x [0, 1] and [0, 1] x [1, 2], 6 n^2 triangles, n even,
/// its first side from (0, 0) to (2, 0), the opposite one from (1, 2) to (0, 2). By Schwarz and
/// Christoffel f'(z) = z^(1/2) ((z^2 - 1)(z^2 - b^2))^(-1/2), with (1, 1) at z = 0 and (0, 0) at
/// infinity; sides of equal length need b = 2 / sqrt(3), and the cross-ratio of the four corners
/// then gives the modulus sqrt(3).
Quadrilateral LShape(int n);

/// The same L between its ends: (2, 0) to (2, 1) is a side, (1, 2) to (0, 2) the opposite one;
/// modulus K'(k) / (2 K(k)), k = sqrt(3) / 2.
Quadrilateral LShapeBetweenEnds(int n);

StatusOr<AccuracyRow> ModulusError(const Quadrilateral& quadrilateral);

/// A Markdown table with the order of convergence from row to row.
std::string AccuracyTable(const std::string& title, const std::string& value,
                          const std::vector<AccuracyRow>& rows);

}  // namespace cirque
