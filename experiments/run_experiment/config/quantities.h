#pragma once

#include <string>
#include <vector>

namespace cirque {

/// A part of a record that figures can show.
struct Quantity {
  std::string name;
  std::string pointer;  ///< JSON pointer into the record
  std::string label;    ///< of an axis, with the unit
};

/// Numbers, for axes: size, times, memory, iterations, evidence, measures, and the methods' own
/// numbers.
const std::vector<Quantity>& Quantities();
std::vector<std::string> QuantityNames();

/// Texts and numbers that runs can have in common: mesh, method and its fields.
const std::vector<Quantity>& Groups();
std::vector<std::string> GroupNames();

/// The entry of that name, which there must be.
const Quantity& FindQuantity(const std::vector<Quantity>& table, const std::string& name);

}  // namespace cirque
