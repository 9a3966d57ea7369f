#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cirque/core/infeasibility.h"
#include "cirque/verify/map_check.h"

namespace cirque::verify {

/// Something to be judged: a map with what is asked of it, or a certificate.
struct Scene {
  PolygonSoup in, out;
  VerifyOptions options;
  InfeasibilityCertificate certificate;
};

/// A fault to plant in it, and a part of the verdict that must tell of it.
struct Fault {
  const char* name;
  const char* finding;
  std::function<void(Scene*)> plant;
};

/// The good scene has a verdict that begins so; with any one of the faults it has not, and tells
/// which.
void ExpectEachIsFound(const Scene& good, const std::function<std::string(const Scene&)>& verdict,
                       const std::string& good_verdict, const std::vector<Fault>& faults);

/// All faces listed the other way round, with their UVs.
void ReverseFaces(PolygonSoup* mesh);

void RemoveLastFace(PolygonSoup* mesh);

}  // namespace cirque::verify
