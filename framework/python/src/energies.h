#pragma once

#include <pybind11/pybind11.h>

namespace cirque::python {

/// Energies in Python: the library's own, minimising and auditing any.
void BindEnergies(pybind11::module_* module);

}  // namespace cirque::python
