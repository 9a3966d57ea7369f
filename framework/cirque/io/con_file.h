#pragma once

#include <array>
#include <string>
#include <string_view>

#include "cirque/core/enum_words.h"
#include "cirque/core/metric.h"
#include "cirque/core/status.h"
#include "cirque/core/triangulation.h"

namespace cirque {

/// CON, the file of an intrinsic metric: connectivity and edge lengths, no points. Text; '#' starts
/// a comment.
///
///   V F                             numbers of vertices and faces
///   f v0 v1 v2 l0 l1 l2 n0 n1 n2    F lines, one a face
///
///   v_k   the vertex at corner k, counted from 1, counter-clockwise;
///   l_k   the length of side k, which lies opposite corner k and so runs from v_(k+1) to v_(k+2);
///   n_k   the side of another (or the same) face that side k is glued to, 0 on the boundary.
///
/// Sides are numbered 1, 2, ..., 3 F in the order of the faces, so side k of the i-th face has
/// number 3 (i - 1) + k + 1. Two faces can share several sides, so their numbers would not do.
///
/// L. Kharevych's thesis has the numbers of vertices and faces and, for each face, a line of three
/// vertices and one of three lengths, in an order that it does not define and that is taken to be
/// this one. Reading takes lines without `f`, files whose lines all end after l2, and lengths on the
/// next line: sides are then glued where exactly two run between the same two vertices, in opposite
/// directions.
struct ConMesh {
  Triangulation triangulation;
  EdgeLengths lengths;
};

/// How a CON file is written.
enum class ConForm {
  kNeighbours,  ///< as above: any gluing
  kThesis,  ///< as the thesis has it: no legend, no `f`, no neighbours, lengths on their own line
};
template <>
inline constexpr auto kEnumWords<ConForm> = std::to_array<EnumWord<ConForm>>(
    {{ConForm::kNeighbours, "neighbours"}, {ConForm::kThesis, "thesis"}});

/// The metric as CON: lengths in the fewest digits that read back to the same bits, halfedge
/// numbering kept.
std::string FormatCon(const Triangulation& triangulation, const EdgeLengths& lengths,
                      ConForm form = ConForm::kNeighbours);

/// Parses CON. Errors are "path:line: ..." and say what to do: a malformed or missing line, a
/// vertex or side that does not exist, a length that is not positive and finite, lengths that no
/// triangle has, sides glued to themselves, one-sidedly, in the same direction or with lengths that
/// differ by more than 1e-12 of them, a vertex of no face or of several fans, a disconnected
/// surface.
StatusOr<ConMesh> ParseCon(const std::string& path, std::string_view content);

/// The same from and to a file, which may be packed by gzip and is written whole or not at all. A
/// gluing that kThesis cannot tell (several edges between the same vertices) is refused.
StatusOr<ConMesh> ReadCon(const std::string& path);
Status WriteCon(const std::string& path, const Triangulation& triangulation,
                const EdgeLengths& lengths, ConForm form = ConForm::kNeighbours);

}  // namespace cirque
