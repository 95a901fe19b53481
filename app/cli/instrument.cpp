// cathedra instrument list | show: the catalogue of guidewires and catheters.
#include <iomanip>
#include <iostream>
#include <numbers>
#include <string>

#include "app/cli/command.h"

namespace app::cli {
namespace {

using nlohmann::ordered_json;

ordered_json summary_json(const curricula::InstrumentSpec& spec) {
  return {{"instrument", spec.id},
          {"title", spec.title},
          {"kind", spec.kind},
          {"outer_diameter_mm", spec.outer_diameter},
          {"inner_diameter_mm", spec.inner_diameter},
          {"length_mm", spec.length()},
          {"tip_shape", spec.tip_shape},
          {"friction", spec.friction}};
}

ordered_json full_json(const curricula::InstrumentSpec& spec) {
  ordered_json document = summary_json(spec);
  document["sections"] = ordered_json::array();
  double from_tip = 0.0;
  for (const curricula::InstrumentSectionSpec& section : spec.sections) {
    document["sections"].push_back({{"from_tip_mm", from_tip},
                                    {"length_mm", section.length},
                                    {"ei_n_mm2", section.bending_stiffness},
                                    {"gj_n_mm2", section.twist_stiffness}});
    from_tip += section.length;
  }
  document["tip_bends"] = ordered_json::array();
  for (const curricula::TipBendSpec& bend : spec.tip_bends) {
    document["tip_bends"].push_back({{"from_tip_mm", bend.from_tip},
                                     {"length_mm", bend.length},
                                     {"angle_deg", bend.angle * 180.0 / std::numbers::pi}});
  }
  document["source"] = spec.source;
  document["sha256"] = spec.sha256;
  return document;
}

void list(Output& output) {
  const auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  ordered_json rows = ordered_json::array();
  for (const auto& spec : library->instruments) rows.push_back(summary_json(spec));
  if (output.json) return output.print(rows);
  for (const auto& spec : library->instruments) {
    std::cout << std::left << std::setw(26) << spec.id << std::setw(34) << spec.title << std::fixed
              << std::setprecision(2) << spec.outer_diameter << " mm  " << std::setprecision(0)
              << spec.length() << " mm\n";
  }
}

void show(const std::string& id, Output& output) {
  const auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  const curricula::InstrumentSpec* spec = library->instrument(id);
  if (!spec)
    return output.fail("there is no instrument \"" + id + "\"; see: cathedra instrument list",
                       kWrongCall);
  const ordered_json document = full_json(*spec);
  if (output.json) return output.print(document);
  std::cout << spec->title << " (" << spec->kind << "), " << spec->outer_diameter << " mm, "
            << spec->length() << " mm, tip " << spec->tip_shape << ", friction " << spec->friction
            << "\n\n  from tip mm   length mm   EI N mm2   GJ N mm2\n";
  for (const auto& section : document["sections"]) {
    std::cout << std::right << std::setw(13) << section["from_tip_mm"] << std::setw(12)
              << section["length_mm"] << std::setw(11) << section["ei_n_mm2"] << std::setw(11)
              << section["gj_n_mm2"] << '\n';
  }
  std::cout << "\nSource: " << spec->source << '\n';
}

}  // namespace

void add_instrument(CLI::App& app, Output& output) {
  CLI::App* instrument = app.add_subcommand("instrument", "Guidewires and catheters: list, show");
  instrument->require_subcommand(1);
  instrument->footer("Example: cathedra instrument show guidewire-035-straight");
  CLI::App* list_command = instrument->add_subcommand("list", "The catalogue");
  list_command->footer("Example: cathedra instrument list --json");
  add_json_flag(*list_command, output);
  list_command->callback([&output] { list(output); });
  auto id = std::make_shared<std::string>();  // shared: kept alive by the callback
  CLI::App* show_command =
      instrument->add_subcommand("show", "One instrument with its stiffness and its source");
  show_command->footer("Example: cathedra instrument show catheter-5f-angled");
  show_command->add_option("instrument", *id, "Id of the instrument")->required();
  add_json_flag(*show_command, output);
  show_command->callback([id, &output] { show(*id, output); });
}

}  // namespace app::cli
