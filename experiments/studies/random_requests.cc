#include "experiments/studies/random_requests.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glog/logging.h>

#include "cirque/cones/registry.h"
#include "cirque/core/triangulation.h"

namespace cirque {

namespace {

/// Angle sums of the boundary that spread towards 0 and pi a corner; inner vertices stay flat.
/// sum corners s^(exponent) with random s in (0, 1) takes every total between.
ConeTargets NearLimits(const Triangulation& t, Dice* dice) {
  ConeTargets targets = FreeBoundaryTargets(t);
  const std::vector<Index> corners = CornersPerVertex(t);
  std::vector<Index> boundary;
  double total = t.num_faces();  // of the boundary's sums, in pi
  for (Index v = 0; v < t.num_vertices; ++v) {
    if (targets.lower[v] == targets.upper[v]) {
      total -= 2;
    } else {
      boundary.push_back(v);
    }
  }
  std::vector<double> base(boundary.size());
  for (double& b : base) b = dice->Uniform(0.01, 0.99);
  double least = 1e-3, most = 1e3;
  for (int step = 0; step < 200; ++step) {
    const double exponent = std::sqrt(least * most);
    double sum = 0;
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      const double sum_here = corners[boundary[i]] * std::pow(base[i], exponent);
      targets.lower[boundary[i]] = targets.upper[boundary[i]] = sum_here * kPi;
      sum += sum_here;
    }
    (sum > total ? least : most) = exponent;
  }
  return targets;
}

const std::string& Pick(const std::vector<std::string>& words, Dice* dice) {
  return words[dice->Below(static_cast<int>(words.size()))];
}

OptionMap DrawOptions(const Domain& domain, Dice* dice) {
  OptionMap options;
  for (const OptionInfo& option : ParameterizeOptionTable().Infos()) {
    if (option.name != "pattern" && !option.words.empty() && dice->Chance(0.15)) {
      options[option.name] = Pick(option.words, dice);
    }
  }
  if (dice->Chance(0.2)) options["cones"] = Pick(ConeHeuristics().Names(), dice);
  if (dice->Chance(0.1)) options["refine_map"] = "mips";
  if (dice->Chance(0.15)) options["epsilon"] = std::to_string(dice->Power(-5, -0.6));
  // Reads a file that is not there.
  if (options["cones"] == "given") options.erase("cones");
  if (options["cones"].empty()) options.erase("cones");
  // As the programs refuse them.
  std::erase_if(options, [&](const auto& option) {
    return IsReadBySomeDomain(option.first) && !domain.Reads(option.first);
  });
  return options;
}

}  // namespace

std::string FlagsOf(const MapRequest& request) {
  std::string flags = "-domain=" + request.domain;
  const OptionMap plain = ParameterizeOptionTable().Values({});
  for (const auto& [name, value] : ParameterizeOptionTable().Values(request.options)) {
    if (value != plain.at(name)) flags += fmt::format(" -{}={}", name, value);
  }
  if (request.domain == "polygon") flags += fmt::format(" -sides={}", request.shape.sides);
  return request.targets ? flags + ", angle sums" : flags;
}

MapRequest DrawRequest(const Surface& surface, Dice* dice) {
  MapRequest request;
  if (dice->Chance(0.5)) request.domain = Pick(Domains().Names(), dice);
  const Domain domain = *Domains().Find(request.domain);
  const Status drawn = ParameterizeOptionTable().Set(DrawOptions(domain, dice), &request.options);
  CHECK(drawn.ok()) << drawn.message();
  request.shape.sides = dice->Between(3, 6);
  const Triangulation& t = surface.triangulation;
  const bool has_boundary = std::find(t.twin.begin(), t.twin.end(), kNone) != t.twin.end();
  if (has_boundary && domain.Reads("targets") && dice->Chance(0.2)) {
    request.targets = NearLimits(t, dice);
  }
  // Last, so that what was drawn before there was a choice is drawn still.
  const bool has_choice = domain.Reads("pattern") && request.options.refine_cones == 0 &&
                          request.options.triangulation == SolvedTriangulation::kDelaunay;
  if (has_choice && dice->Chance(0.2)) request.options.pattern = PatternKind::kEquivalence;
  return request;
}

namespace {

std::vector<Index> Draw(std::vector<Index> from, int count, Dice* dice) {
  std::vector<Index> drawn;
  for (; count > 0 && !from.empty(); --count) {
    std::swap(from[dice->Below(static_cast<int>(from.size()))], from.back());
    drawn.push_back(from.back());
    from.pop_back();
  }
  return drawn;
}

}  // namespace

ConeTargets DrawCones(const Triangulation& t, Dice* dice) {
  ConeTargets targets = FreeBoundaryTargets(t);
  std::vector<Index> inner, boundary;
  const std::vector<bool> on_boundary = BoundaryVertices(t);
  for (Index v = 0; v < t.num_vertices; ++v) (on_boundary[v] ? boundary : inner).push_back(v);
  const bool free = dice->Chance(0.5);
  const int least = boundary.empty() ? std::max(1, EulerCharacteristic(t) + 1) : 0;
  std::vector<Index> cones = Draw(inner, dice->Between(least, std::max(least, 8)), dice);
  double total = kPi * t.num_faces() - 2 * kPi * static_cast<double>(inner.size() - cones.size());
  cones.insert(cones.end(), boundary.begin(), boundary.end());
  std::vector<double> share(cones.size());
  double all = 0;
  for (double& s : share) all += s = dice->Power(-1, 0.5);
  for (std::size_t i = 0; i < cones.size(); ++i) {
    if (free && on_boundary[cones[i]]) continue;
    targets.lower[cones[i]] = targets.upper[cones[i]] = total * share[i] / all;
  }
  return targets;
}

}  // namespace cirque
