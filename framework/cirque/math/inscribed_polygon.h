#pragma once

#include <vector>

namespace cirque {

/// Half the central angles [rad] of the edges of a polygon of these edge lengths (> 0, three or more)
/// that is inscribed in a circle and runs round its centre or past it, once:
///   sin(phi_i) = l_i / (2 R),   sum phi_i = pi;
/// the phi of an edge longer than all others allow about the centre is more than pi / 2. At the vertex
/// between the edges i and j the polygon turns by phi_i + phi_j. A length of which the others fall
/// short counts as just shorter than their sum, which closes.
std::vector<double> HalfCentralAngles(std::vector<double> lengths);

}  // namespace cirque
