#pragma once

#include <string>
#include <vector>

namespace cirque {

/// C++ source `text` with comments, literals and preprocessor lines blanked out: what is left of
/// braces and words is code. Line breaks stay, so that lines keep their numbers.
std::string CodeOf(const std::string& text);

/// A function body at the level of namespaces and classes.
struct FunctionSpan {
  int first_line = 0;  // of its signature, from 1
  int num_lines = 0;   // from there to its closing brace
};

/// The functions that a source defines, in order. Lambdas belong to the function around them;
/// tables and other initialisers are none.
std::vector<FunctionSpan> FunctionsOf(const std::string& text);

/// A class and one of its base classes, both without namespaces and template arguments.
struct Derivation {
  std::string derived, base;
};

/// The names of the classes and structs that a source defines (not those it only declares).
std::vector<std::string> ClassesOf(const std::string& text);

/// The types that a source defines for others to see, with their namespaces ("cirque::Registry"): those
/// at the level of namespaces, of which none is without a name.
std::vector<std::string> VisibleTypesOf(const std::string& text);

/// What the classes of a source derive from.
std::vector<Derivation> DerivationsOf(const std::string& text);

}  // namespace cirque
