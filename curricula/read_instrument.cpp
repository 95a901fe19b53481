#include <numbers>

#include "curricula/fields.h"
#include "curricula/number_text.h"
#include "curricula/read_catalogue.h"
#include "curricula/read_sources.h"
#include "curricula/sha256.h"

namespace curricula {
namespace {

constexpr const char* kSchema = "cathedra-instrument/1";
constexpr double kShortest = 600.0;  // mm: shorter ones end inside the patient

InstrumentSectionSpec read_section(const YamlNode& node, Problems& problems) {
  Fields fields(node, "a section", problems);
  InstrumentSectionSpec section;
  section.length = fields.need_number("length_mm", {1.0, 5000.0});
  section.bending_stiffness = fields.need_number("bending_stiffness_n_mm2", {0.0, 20000.0, true});
  section.twist_stiffness = fields.need_number("twist_stiffness_n_mm2", {0.0, 20000.0, true});
  fields.finish();
  return section;
}

TipBendSpec read_bend(const YamlNode& node, Problems& problems) {
  Fields fields(node, "a bend of the tip", problems);
  TipBendSpec bend;
  bend.from_tip = fields.need_number("from_tip_mm", {0.0, 200.0});
  bend.length = fields.need_number("length_mm", {1.0, 200.0});
  bend.angle = fields.need_number("angle_deg", {-270.0, 270.0}) * std::numbers::pi / 180.0;
  fields.finish();
  return bend;
}

void read_tip(const YamlNode& node, InstrumentSpec& spec, Problems& problems) {
  Fields fields(node, "'tip'", problems);
  const std::vector<std::string> shapes = {"straight", "angled"};
  if (const auto shape = fields.need_choice("shape", shapes)) spec.tip_shape = shapes[*shape];
  const std::vector<const YamlNode*> bends = fields.list("bends");
  for (const YamlNode* bend : bends) spec.tip_bends.push_back(read_bend(*bend, problems));
  if (spec.tip_shape == "straight" && !bends.empty()) {
    problems.error(*bends.front(),
                   "a straight tip has no bends: take them out or write shape: angled");
  }
  if (spec.tip_shape == "angled" && bends.empty() && node.complete) {
    problems.error(node, "an angled tip needs its 'bends': add them or write shape: straight");
  }
  for (std::size_t i = 1; i < spec.tip_bends.size(); ++i) {
    const TipBendSpec& before = spec.tip_bends[i - 1];
    if (spec.tip_bends[i].from_tip < before.from_tip + before.length) {
      problems.error(*bends[i],
                     "this bend overlaps the one before: list bends from the tip back, apart");
    }
  }
  fields.finish();
}

void check_whole(const InstrumentSpec& spec, const YamlNode& node, Problems& problems) {
  const YamlNode* inner = node.find("inner_diameter_mm");
  if (inner && spec.inner_diameter >= spec.outer_diameter && spec.outer_diameter > 0.0) {
    problems.error(*inner,
                   "the inner diameter must be smaller than the outer one: correct one of the two");
  }
  const YamlNode* sections = node.find("sections");
  if (sections && !spec.sections.empty() && spec.length() < kShortest) {
    problems.error(*sections, "the sections are " + number_text(spec.length()) +
                                  " mm long in all: make it at least 600");
  }
}

}  // namespace

CatalogueEntry<InstrumentSpec> read_instrument(const std::string& text) {
  Problems problems;
  InstrumentSpec spec;
  const YamlTree tree = parse_yaml(text, problems);
  if (tree.root.kind != YamlNode::Kind::unusable) {
    Fields fields(tree.root, "an instrument", problems);
    fields.need_choice("schema", {kSchema});
    spec.id = fields.need_id("id");
    spec.title = fields.need_word("title");
    const std::vector<std::string> kinds = {"guidewire", "catheter"};
    if (const auto kind = fields.need_choice("kind", kinds)) spec.kind = kinds[*kind];
    spec.outer_diameter = fields.need_number("outer_diameter_mm", {0.1, 12.0});
    spec.inner_diameter = fields.need_number("inner_diameter_mm", {0.0, 12.0});
    for (const YamlNode* node : fields.need_list("sections")) {
      spec.sections.push_back(read_section(*node, problems));
    }
    if (const YamlNode* tip = fields.need("tip")) read_tip(*tip, spec, problems);
    spec.friction = fields.need_number("friction", {0.0, 1.0});
    if (const YamlNode* sources = fields.need("sources")) {
      spec.source = read_sources(*sources, {"stiffness", "friction", "shape"}, problems);
    }
    fields.finish();
    check_whole(spec, tree.root, problems);
  }
  CatalogueEntry<InstrumentSpec> entry;
  if (!problems.any_error()) {
    spec.sha256 = sha256_hex(text);
    entry.spec = std::move(spec);
  }
  entry.problems = std::move(problems).sorted();
  return entry;
}

}  // namespace curricula
