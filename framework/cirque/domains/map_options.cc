#include "cirque/domains/map_options.h"

#include <variant>

#include <fmt/format.h>

#include "cirque/core/option.h"
#include "cirque/core/text.h"
#include "cirque/mesh/preflight.h"

namespace cirque {
namespace {

/// What of MapOptions has a name and is not in the tables of its members.
const OptionTable<MapOptions>& OwnTable() {
  static const OptionTable<MapOptions> kTable(
      "map", {Option<MapOptions>("domain", &MapOptions::domain, "shape to map onto")
                  .Checked([](const std::string& name) { return Domains().Find(name).status(); })
                  .OneOf(Domains().Names())
                  .About("Domain"),
              Option<MapOptions>("exact", &MapOptions::exact,
                                 "the mesh refined so that the map is linear on the triangles it "
                                 "was solved on, too")
                  .About("Output")});
  return kTable;
}

Status CheckUvSize(const std::string& text) {
  UvFrame frame;
  return SetUvSize(text, &frame);
}

/// Whether the domain reads what is given of the members that not every domain reads.
Status CheckIsRead(const Domain& domain, const std::string& name, const std::string& option) {
  if (!IsReadBySomeDomain(option) || domain.Reads(option)) return Status();
  return Status::InvalidInput(
      fmt::format("the domain {} takes no {}; it takes {}", name, option, Join(domain.reads)));
}

}  // namespace

Status SetUvSize(const std::string& text, UvFrame* frame) {
  frame->scale = 1;
  if (text == "as_is" || text == "unit") {
    frame->size = text == "unit" ? UvSize::kUnit : UvSize::kAsIs;
    return Status();
  }
  OptionInfo number{"scale", OptionKind::kNumber, "", {1e-100, 1e100}};
  if (text.starts_with("scale=")) {
    const StatusOr<OptionValue> value = ParseValue(number, text.substr(6));
    if (!value.ok()) return value.status().In("uv");
    frame->size = UvSize::kScale;
    frame->scale = std::get<double>(*value);
    return Status();
  }
  return Status::InvalidInput("uv = '" + text + "' is none of as_is, unit and scale=NUMBER");
}

const OptionTable<MeshOptions>& MeshOptionTable() {
  using M = MeshOptions;
  static const OptionTable<M> kTable(
      "mesh",
      {Option<M>("repair", &M::repair,
                 "what is done to a mesh that is no surface: none, safe, weld or weld:TOLERANCE; "
                 "safe: faces of no area and duplicates are set aside, vertices and edges split "
                 "where the surface touches itself; weld: first boundary vertices become one "
                 "that lie together (TOLERANCE: of the bounding box). All faces are written")
           .Checked([](const std::string& text) { return ParseRepair(text).status(); })
           .About("Files"),
       Option<M>("fill_holes", &M::fill_holes,
                 "close all boundary loops but the longest for the solve; the fill is not written")
           .About("Shape"),
       Option<M>(
           "uv", &M::uv,
           "the map's size: as_is, unit or scale=S; as_is: true length; unit: within the unit "
           "square; scale: true length times S")
           .Checked(CheckUvSize)
           .About("Output"),
       Option<M>("uv_margin", &M::uv_margin,
                 "free room between patches and, with uv=unit, at the border, as a share of the "
                 "square")
           .Between(0, 0.25)
           .About("Output"),
       Option<M>("scale_pieces", &M::scale_pieces,
                 "several components in their true size to each other, or each in the same size")
           .About("Output")});
  return kTable;
}

UvFrame FrameOf(const MeshOptions& options) {
  UvFrame frame{UvSize::kAsIs, 1, options.uv_margin, options.scale_pieces};
  (void)SetUvSize(options.uv, &frame);
  return frame;
}

Status MapOptions::Set(const OptionMap& texts) {
  std::vector<std::string> known = OwnTable().Names();
  known.insert(known.end(), {"angle_sums", "cut", "cut_paths"});  // members, but no texts
  for (const auto& table : {MeshOptionTable().Names(), ParameterizeOptionTable().Names(),
                            DomainOptionTable().Names()}) {
    known.insert(known.end(), table.begin(), table.end());
  }
  for (const auto& [name, text] : texts) {
    Status set;
    if (const auto* own = OwnTable().Find(name)) {
      set = own->Set(text, this);
    } else if (const auto* of_mesh = MeshOptionTable().Find(name)) {
      set = of_mesh->Set(text, &mesh);
    } else if (const auto* solve = ParameterizeOptionTable().Find(name)) {
      set = solve->Set(text, &options);
    } else if (const auto* of_shape = DomainOptionTable().Find(name)) {
      set = of_shape->Set(text, &shape);
    } else {
      set = Status::InvalidInput(UnknownName("option", name, known));
    }
    if (!set.ok()) return set;
  }
  const StatusOr<Domain> found = Domains().Find(domain);
  for (const auto& entry : texts) {
    if (Status s = CheckIsRead(*found, domain, entry.first); !s.ok()) return s;
  }
  return Status();
}

Status CheckOptions(const MapOptions& options) {
  if (Status s = CheckOptions(options.options); !s.ok()) return s;
  if (Status s = MeshOptionTable().Validate(options.mesh); !s.ok()) return s;
  const StatusOr<Domain> domain = Domains().Find(options.domain);
  if (!domain.ok()) return domain.status();
  if (options.options.own_cones) return CheckIsRead(*domain, options.domain, "cones");
  return Status();
}

std::vector<OptionInfo> MapOptionInfos() {
  std::vector<OptionInfo> infos = OwnTable().Infos();
  for (const auto& table : {MeshOptionTable().Infos(), DomainOptionTable().Infos(),
                            ParameterizeOptionTable().Infos()}) {
    infos.insert(infos.end(), table.begin(), table.end());
  }
  return infos;
}

}  // namespace cirque
