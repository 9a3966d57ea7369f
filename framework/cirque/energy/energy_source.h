#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "cirque/energy/mesh_part.h"

namespace cirque {

/// What an energy on a part of a surface is made of, beside the triangulation.
struct EnergyData {
  std::string objective;      ///< its name; empty: none
  double epsilon = 0;         ///< [rad]
  Eigen::VectorXd angles;     ///< 3F [rad]
  std::vector<double> lower;  ///< per vertex its angle sum, fixed, or 0 [rad]; empty: none
  std::vector<double> upper;  ///< the same, or what no sum exceeds

  void Send(Ranks* ranks, int to) const;
  static EnergyData Receive(Ranks* ranks);
};

/// An energy that ranks can take in parts: a sum over the edges of a triangulation. What a part
/// says of its own parameters is what the whole says, to the last bit.
class EnergySource {
 public:
  virtual ~EnergySource() = default;

  /// Of RankWorks: that of parts of such an energy.
  virtual const char* Work() const = 0;
  virtual const Triangulation& triangulation() const = 0;

  /// As of Energy.
  virtual int NumParameters() const = 0;
  virtual std::vector<int> GaugeParameters() const = 0;

  /// Per vertex, kNone without; empty: none has one. Those of the faces are their numbers.
  virtual std::vector<int> VertexParameters() const = 0;
  virtual EnergyData DataOf(const MeshPart& part) const = 0;
};

/// The names of CirclePatternEnergy's and DualAngleEnergy's works.
inline constexpr char kCirclePatternWork[] = "circle pattern";
inline constexpr char kDualAngleWork[] = "dual angles";

/// The entries of `of_halfedges` at a part's halfedges.
Eigen::VectorXd AtHalfedges(const MeshPart& part, const Eigen::VectorXd& of_halfedges);

}  // namespace cirque
