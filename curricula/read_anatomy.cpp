#include <cmath>
#include <numbers>

#include "curricula/fields.h"
#include "curricula/number_text.h"
#include "curricula/read_catalogue.h"
#include "curricula/read_sources.h"
#include "curricula/sha256.h"

namespace curricula {
namespace {

constexpr const char* kSchema = "cathedra-anatomy/1";
constexpr double kRadPerDegree = std::numbers::pi / 180.0;

std::array<double, 3> read_triple(Fields& fields, const char* key, Problems& problems) {
  std::array<double, 3> triple{};
  const YamlNode* list = fields.need(key);
  if (!list || list->kind == YamlNode::Kind::unusable) return triple;
  if (list->kind != YamlNode::Kind::list || list->items.size() != triple.size()) {
    problems.error(*list, "'" + std::string(key) + "' must be three numbers: write [x, y, z]");
    return triple;
  }
  for (std::size_t i = 0; i < triple.size(); ++i) {
    // one number of the list, read as if it were a field of its own
    YamlNode holder = *list;
    holder.kind = YamlNode::Kind::map;
    YamlNode name = list->items[i];
    name.kind = YamlNode::Kind::scalar;
    name.text = key;
    holder.items.clear();
    holder.entries = {{name, list->items[i]}};
    triple[i] = Fields(holder, key, problems).need_number(key, {-2000.0, 2000.0});
  }
  return triple;
}

void read_access(const YamlNode& node, AnatomySpec& spec, Problems& problems) {
  Fields fields(node, "'access'", problems);
  spec.access = read_triple(fields, "position_mm", problems);
  spec.direction = read_triple(fields, "direction", problems);
  spec.start_radius = fields.need_number("radius_mm", {0.2, 30.0});
  fields.finish();
  const double length = std::hypot(spec.direction[0], spec.direction[1], spec.direction[2]);
  if (length > 1e-9) {
    for (double& component : spec.direction) component /= length;
  } else if (const YamlNode* direction = node.find("direction");
             direction && direction->kind == YamlNode::Kind::list && direction->items.size() == 3) {
    problems.error(*direction,
                   "'direction' has no length: write a vector into the vessel, as in [0, 0, 1]");
  }
}

TubeLegSpec read_leg(const YamlNode& node, Problems& problems) {
  Fields fields(node, "a leg", problems);
  TubeLegSpec leg;
  leg.length = fields.need_number("length_mm", {1.0, 2000.0});
  leg.bend = fields.number("bend_deg", {-270.0, 270.0}).value_or(0.0) * kRadPerDegree;
  leg.plane = fields.number("plane_deg", {-360.0, 360.0}).value_or(0.0) * kRadPerDegree;
  leg.radius = fields.need_number("radius_mm", {0.2, 30.0});
  fields.finish();
  if (leg.bend != 0.0 && leg.length / std::abs(leg.bend) <= leg.radius) {
    problems.error(
        node, "this bend is tighter than the lumen is wide: make the leg longer or bend it less");
  }
  return leg;
}

}  // namespace

CatalogueEntry<AnatomySpec> read_anatomy(const std::string& text) {
  Problems problems;
  AnatomySpec spec;
  const YamlTree tree = parse_yaml(text, problems);
  if (tree.root.kind != YamlNode::Kind::unusable) {
    Fields fields(tree.root, "an anatomy", problems);
    fields.need_choice("schema", {kSchema});
    spec.id = fields.need_id("id");
    spec.title = fields.need_word("title");
    if (const YamlNode* surface = fields.need("surface")) {
      Fields inner(*surface, "'surface'", problems);
      spec.voxel = inner.need_number("voxel_mm", {0.1, 5.0});
      inner.finish();
    }
    if (const YamlNode* access = fields.need("access")) read_access(*access, spec, problems);
    for (const YamlNode* leg : fields.need_list("legs"))
      spec.legs.push_back(read_leg(*leg, problems));
    if (const YamlNode* sources = fields.need("sources")) {
      spec.source = read_sources(*sources, {"radius", "shape"}, problems);
    }
    fields.finish();
  }
  CatalogueEntry<AnatomySpec> entry;
  if (!problems.any_error()) {
    spec.sha256 = sha256_hex(text);
    entry.spec = std::move(spec);
  }
  entry.problems = std::move(problems).sorted();
  return entry;
}

}  // namespace curricula
