// What a curriculum may name, and the instruments in full.
#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/server/json_body.h"
#include "app/server/routes/handlers.h"
#include "app/server/site.h"
#include "app/server/views/json_views.h"
#include "app/server/views/words.h"
#include "database/curriculum_drafts.h"
#include "reports/instrument_charts.h"

namespace app {
namespace {

using nlohmann::json;

json info_json(const curricula::InstrumentSpec& spec) {
  return {{"id", spec.id},
          {"title", spec.title},
          {"kind", spec.kind},
          {"outer_diameter_mm", spec.outer_diameter},
          {"length_mm", spec.length()}};
}

json sections_json(const curricula::InstrumentSpec& spec) {
  json sections = json::array();
  double from_tip = 0.0;
  for (const curricula::InstrumentSectionSpec& section : spec.sections) {
    sections.push_back({{"from_tip_mm", from_tip},
                        {"length_mm", section.length},
                        {"bending_stiffness_n_mm2", section.bending_stiffness},
                        {"twist_stiffness_n_mm2", section.twist_stiffness}});
    from_tip += section.length;
  }
  return sections;
}

json charts_json(const curricula::InstrumentSpec& spec) {
  std::vector<reports::StiffnessSection> sections;
  for (const auto& each : spec.sections) {
    sections.push_back({each.length, each.bending_stiffness, each.twist_stiffness});
  }
  std::vector<reports::TipBend> bends;
  for (const auto& each : spec.tip_bends) bends.push_back({each.from_tip, each.length, each.angle});
  return to_json(std::vector<reports::Chart>{
      reports::stiffness_chart(spec.id + "-stiffness", spec.title, sections),
      reports::tip_chart(spec.id + "-tip", spec.title, bends, spec.outer_diameter)});
}

// Exercises of published curricula that use the instrument, by title.
base::Result<json> used_by(Call& call, const std::string& instrument) {
  const auto versions = database::version_summaries(call.store);
  if (!versions) return versions.error();
  json titles = json::array();
  std::string last;
  for (const database::VersionSummary& version : *versions) {
    if (version.status != "published" || version.curriculum_id == last) continue;
    last = version.curriculum_id;  // of each its newest
    const auto curriculum = call.site.curricula.by_id(
        call.store, call.site.scenes.library().catalogue(), version.curriculum_id);
    if (!curriculum) return curriculum.error();
    for (const curricula::Exercise& exercise : (*curriculum)->exercises) {
      const auto& named = exercise.scene.instruments;
      if (std::find(named.begin(), named.end(), instrument) == named.end()) continue;
      titles.push_back(english(exercise.title));
    }
  }
  return titles;
}

}  // namespace

base::Result<Response> get_catalogue(Call& call) {
  const curricula::Library& library = call.site.scenes.library();
  json anatomies = json::array(), instruments = json::array();
  for (const curricula::AnatomySpec& spec : library.anatomies) {
    anatomies.push_back({{"id", spec.id}, {"title", spec.title}, {"length_mm", spec.length()}});
  }
  for (const curricula::InstrumentSpec& spec : library.instruments) {
    instruments.push_back(info_json(spec));
  }
  return json_response(
      {{"anatomies", anatomies}, {"instruments", instruments}, {"metrics", metrics_json()}});
}

base::Result<Response> get_instruments(Call& call) {
  json instruments = json::array();
  for (const curricula::InstrumentSpec& spec : call.site.scenes.library().instruments) {
    auto titles = used_by(call, spec.id);
    if (!titles) return titles.error();
    instruments.push_back({{"info", info_json(spec)},
                           {"inner_diameter_mm", spec.inner_diameter},
                           {"tip_shape", spec.tip_shape},
                           {"friction", spec.friction},
                           {"source", spec.source},
                           {"sha256", spec.sha256},
                           {"used_by", *std::move(titles)},
                           {"sections", sections_json(spec)},
                           {"charts", charts_json(spec)}});
  }
  return json_response({{"instruments", instruments}});
}

}  // namespace app
