#pragma once

#include <array>
#include <functional>
#include <string>

#include <Eigen/Core>

#include "cirque/core/registry.h"
#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"

namespace cirque {

/// What a generator is asked for. Equal options give equal meshes: everything random comes from the
/// standard's own generator with our own mapping, every geometric decision is exact. (Between
/// machines the C library's sin, exp and log may differ in the last bit, and with them positions.)
struct GeneratorOptions {
  Index triangles = 2000;  ///< about how many
  unsigned seed = 1;       ///< of the irregular vertex positions
};

/// Makes a mesh that is manifold, connected, free of isolated vertices and oriented
/// counter-clockwise as seen from outside or above. The irregular ones have within 10 % the number
/// of triangles asked for, from the minimum below up; smaller numbers give the minimum.
/// Vertices are numbered as the faces first name them.
using MeshGenerator = std::function<PolygonSoup(const GeneratorOptions&)>;

/// The least number of triangles of every generator: disks, rings and spheres; closed surfaces with
/// handles, and the plate.
inline constexpr Index kMinTriangles = 20, kMinTrianglesWithHandles = 400;

/// The most that GenerateMesh makes: 32-bit halfedge numbers hold a little more.
inline constexpr Index kMaxTriangles = 500'000'000;

/// The table of generators, one line an entry in generators.cc; each is described below.
const Registry<MeshGenerator>& MeshGenerators();

/// The mesh of the generator of that name. Errors (invalid input): unknown name (the known ones are
/// listed), a number of triangles below 1 or above kMaxTriangles.
StatusOr<PolygonSoup> GenerateMesh(const std::string& name, const GeneratorOptions& options);

// The generators. V - E + F is the Euler characteristic; "loops" are boundary loops. Conformal maps
// named here are those of known_maps.h.

/// The square [-1, 1]^2 at z = 0, vertices closer together near (0.4, 0.3) (edge lengths 1 : 3),
/// exactly Delaunay. V - E + F = 1, one loop. Conformal map: the identity.
PolygonSoup FlatDelaunayPatch(const GeneratorOptions& options);

/// The graph of 25 Gaussian bumps over [-1, 1]^2, of standard deviations 0.1 to 0.35 and slopes up
/// to about 0.5 each, heights of either sign, all from the seed. Delaunay in (x, y), as a range
/// scan is. V - E + F = 1, one loop. No conformal map in closed form.
PolygonSoup BumpyTerrain(const GeneratorOptions& options);

/// The part of the unit sphere within 60 degrees of the north pole, Delaunay on the sphere.
/// V - E + F = 1, one loop. Conformal map: stereographic.
PolygonSoup SphericalCap(const GeneratorOptions& options);

/// The northern unit hemisphere, Delaunay on the sphere. V - E + F = 1, one loop. Conformal map:
/// stereographic, onto the unit disk.
PolygonSoup Hemisphere(const GeneratorOptions& options);

/// Enneper's minimal surface over the unit disk of its parameters, Delaunay there. V - E + F = 1,
/// one loop. Conformal map: its parameters.
PolygonSoup EnneperPatch(const GeneratorOptions& options);

/// A cylinder of radius 1 and length 8 under a hemisphere: a limb, open at its end. V - E + F = 1,
/// one loop. Conformal map: a disk of radius e^8, in which the cap is the unit disk.
PolygonSoup CappedTube(const GeneratorOptions& options);

/// The same of length 50. Its conformal map, a disk of radius e^50 = 5e21, spans more than doubles
/// resolve from one origin: the case for kUnrepresentable. Below about 750 triangles, edges are
/// longer than the tube's radius.
PolygonSoup LongCappedTube(const GeneratorOptions& options);

/// The equilateral triangulation of a regular hexagon of k rings with edges of length 1: 6 k^2
/// triangles, k the number of rings that comes nearest to what is asked for (at least 1); the seed
/// is ignored. V - E + F = 1, one loop. Conformal map: the identity.
PolygonSoup HexagonalFan(const GeneratorOptions& options);

/// The plane ring between the circles of radius 0.4 and 1. V - E + F = 0, two loops. Conformal map:
/// the identity.
PolygonSoup Annulus(const GeneratorOptions& options);

/// The plane ring between the unit circle and the circle of radius 0.3 about (0.4, 0). V - E + F = 0,
/// two loops. Conformal map: the concentric ring (EccentricAnnulusMap).
PolygonSoup EccentricAnnulus(const GeneratorOptions& options);

/// The plate x^4 + y^4 <= 1 at z = 0 with five elliptic holes (PlateHoles). V - E + F = -4, six loops.
/// Conformal map: the identity.
PolygonSoup PlateWithHoles(const GeneratorOptions& options);

/// An ellipse of the plane by its centre, its semi-axes and the angle of the first with the x axis
/// [rad].
struct EllipticHole {
  Eigen::Vector2d centre, axes;
  double angle;

  /// 1 on the ellipse grown outwards by that much along its axes, less inside.
  double Norm(const Eigen::Vector2d& point, double grown = 0) const;
};
const std::array<EllipticHole, 5>& PlateHoles();

/// The catenoid (cosh z cos p, cosh z sin p, z), |z| <= 1.2. V - E + F = 0, two loops. Conformal
/// map: the ring between the radii e^-1.2 and e^1.2.
PolygonSoup Catenoid(const GeneratorOptions& options);

/// The unit sphere, Delaunay on it: the convex hull of its vertices, of which (0, 0, -1) is one.
/// V - E + F = 2, closed, genus 0. Conformal map (of all but that vertex): stereographic.
PolygonSoup Sphere(const GeneratorOptions& options);

/// A star-shaped bumpy sphere: direction n at distance exp(sum_k a_k exp(b_k (c_k.n - 1))), with 12
/// bumps, -0.2 <= a_k <= 0.3, 4 <= b_k <= 12, from the seed. V - E + F = 2, closed, genus 0.
PolygonSoup Blob(const GeneratorOptions& options);

/// The torus of radii 1 and 0.4, Delaunay on the flat torus that it is conformal to. V - E + F = 0,
/// closed, genus 1. Conformal map: a rectangle of ratio sqrt(1 / 0.4^2 - 1) = 2.29, opposite sides
/// identified.
PolygonSoup Torus(const GeneratorOptions& options);

/// The torus of radii 1 and 0.4 about (-1.15, 0, 0), as far as x <= 0, with its mirror image in
/// x = 0, where they meet in a crease. V - E + F = -2, closed, genus 2.
PolygonSoup DoubleTorus(const GeneratorOptions& options);

}  // namespace cirque
