#pragma once

#include <string>
#include <vector>

#include "cirque/core/infeasibility.h"
#include "cirque/core/status.h"
#include "cirque/io/polygon_soup.h"
#include "cirque/verify/angle_targets.h"
#include "cirque/verify/topology.h"

namespace cirque::verify {

/// What became of a certificate that a mesh has no coherent angles.
struct InfeasibilityReport {
  std::vector<std::string> errors;  ///< why it is rejected; empty for an accepted one
  Index num_triangles = 0;
  bool names_triangles = false;  ///< whether the certificate says which triangles the faces are in
  Index num_faces_left_out = 0;  ///< faces that it does not name: parts of another component
  double epsilon_over_pi = 0;
  Index removed_vertex = kNone;    ///< if any, the one without whose triangles all this is meant
  double link_upper_over_pi = 1;   ///< the least that its neighbours' angle sums are limited to
  bool straight_boundary = false;  ///< with a removed vertex: a map to the half-plane is denied
  Index num_beyond_chords = 0;     ///< triangles that such a map leaves out
  bool evaluated = false;  ///< whether it was well-formed, so that what follows was computed
  double left = 0;         ///< sum_f y_f + sum_v y_v (y_v > 0 ? lower : upper), rounded for display
  double right = 0;        ///< sum_e max over Q_e of (A'y)_e . a, likewise
  double margin = 0;       ///< left - right, rounded once from its exact value
  Index num_flat = 0;      ///< inner vertices constrained to exactly 2 pi
  std::vector<Index> cones;       ///< inner vertices constrained to anything else
  std::vector<Index> prescribed;  ///< boundary vertices held to less than (0, corners * pi)
  bool targets_given = false;     ///< whether the targets asked about were named, or the default's
  /// Vertices whose targets in the certificate do not follow from those asked about.
  std::vector<Index> own_targets;
  std::vector<AngleInterval> own_intervals;  ///< what the certificate asks of them
  bool proves_asked = false;  ///< whether the inequality holds with the targets asked about too

  /// Whether the certificate shows that its own targets cannot be met.
  bool accepted() const { return errors.empty(); }
  std::string Verdict() const;
};

/// Checks the inequality of core/infeasibility.h in exact arithmetic on the triangles of `in`: those
/// that the certificate names, which must fill their faces, or else fans of the polygons; adjacency
/// is found here. Faces that it does not name are no part of its claim. All numbers in the
/// certificate are taken to be exactly the doubles they are.
///
/// Epsilon > 0: coherent angles with that margin lie in the closed sets Q_e, so the left side must
/// be strictly larger. Epsilon = 0: coherent angles are positive and alpha_l + alpha_r < pi (at the
/// boundary: alpha < pi), so every alpha_e lies in the interior of Q_e. A linear function that is
/// not zero takes its maximum over Q_e at the rim only; so as soon as (A'y)_e is not zero on some
/// edge, coherent angles make sum_e (A'y)_e . alpha_e strictly smaller than the right side, and
/// left >= right is already a contradiction.
///
/// With a removed vertex the claim is about `in`, closed, without that vertex and its triangles
/// (whose multipliers must be 0), where the vertices next to it are limited to `link_upper_over_pi`
/// or more: no circle pattern on the sphere has the triangles of `in` and these margins, with that
/// vertex at infinity. (Without margins it would not matter which vertex is removed: such patterns
/// are ideal hyperbolic polyhedra. I. Rivin, A characterization of ideal polyhedra in hyperbolic
/// 3-space, 1996.)
///
/// Where `in` has a boundary, the removed vertex lies on it, and the claim is about the largest
/// part that no chord (an inner edge between two boundary vertices) cuts off: its boundary, but
/// along the removed vertex's link, is held to pi, the link's ends to half of what limits the link.
/// Glued to its mirror image that is the claim above, so there is no pattern with the boundary on
/// one circle.
///
/// A certificate names targets of its own, and it is easy to name some that nothing meets. So the
/// inequality is evaluated once more with the multipliers that it has and the targets `asked`
/// about: 2 pi inside and a free boundary, unless the user names others. (At vertices next to a
/// removed one and on a straight boundary these are the certificate's, which are those of the
/// domain, as said above.) Where it then fails, the certificate says nothing of the targets asked
/// about.
///
/// A status is returned when `in` is not an orientable manifold.
StatusOr<InfeasibilityReport> CheckInfeasibility(const InfeasibilityCertificate& certificate,
                                                 const PolygonSoup& in,
                                                 const AngleTargets& asked = DefaultTargets());

/// Reads the "infeasibility" member of a certificate. Errors name the key and what was expected.
StatusOr<InfeasibilityCertificate> ReadInfeasibilityCertificate(const std::string& path);
StatusOr<InfeasibilityCertificate> ParseInfeasibilityCertificate(const std::string& json);

std::string ToText(const InfeasibilityReport& report);
std::string ToJson(const InfeasibilityReport& report);

/// Takes the triangles at the certificate's removed vertex out of both surface and certificate, and
/// of a surface with boundary those beyond chords, as CheckInfeasibility says. False, with errors
/// in the report, where certificate or surface do not allow it.
/// @pre the certificate has the form that the surface needs.
bool RemoveVertex(Surface* surface, InfeasibilityCertificate* certificate,
                  InfeasibilityReport* report);

}  // namespace cirque::verify
