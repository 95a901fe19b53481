// cathedra anatomy list | show: the vessels one can train in.
#include <algorithm>
#include <array>
#include <cstdint>
#include <iomanip>
#include <iostream>
#include <map>
#include <string>
#include <utility>

#include "app/cli/command.h"

namespace app::cli {
namespace {

using nlohmann::ordered_json;

void list(Output& output) {
  const auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  ordered_json rows = ordered_json::array();
  for (const auto& spec : library->anatomies) {
    rows.push_back({{"anatomy", spec.id}, {"title", spec.title}, {"length_mm", spec.length()}});
  }
  if (output.json) return output.print(rows);
  for (const auto& spec : library->anatomies) {
    std::cout << std::left << std::setw(22) << spec.id << std::setw(40) << spec.title << std::fixed
              << std::setprecision(0) << spec.length() << " mm\n";
  }
}

// Edges with exactly two triangles that run along them in opposite directions: a closed surface
// has no others.
bool is_closed(const sim::TriangleMesh& mesh) {
  std::map<std::pair<std::int32_t, std::int32_t>, int> directed;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++directed[{t[k], t[(k + 1) % 3]}];
  }
  return std::all_of(directed.begin(), directed.end(), [&](const auto& edge) {
    const auto back = directed.find({edge.first.second, edge.first.first});
    return edge.second == 1 && back != directed.end() && back->second == 1;
  });
}

void show(const std::string& id, Output& output) {
  auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  SceneStore scenes(*std::move(library));
  const curricula::AnatomySpec* spec = scenes.library().anatomy(id);
  if (!spec)
    return output.fail("there is no anatomy \"" + id + "\"; see: cathedra anatomy list",
                       kWrongCall);
  const auto vessel = scenes.vessel(id);
  if (!vessel) return output.fail(vessel.error());

  const auto& centreline = (*vessel)->centreline;
  const auto by_radius = [](const auto& a, const auto& b) { return a.radius < b.radius; };
  const auto [narrow, wide] = std::minmax_element(centreline.begin(), centreline.end(), by_radius);
  const ordered_json document = {{"anatomy", id},
                                 {"title", spec->title},
                                 {"length_mm", centreline.back().arc_length},
                                 {"radius_min_mm", narrow->radius},
                                 {"radius_max_mm", wide->radius},
                                 {"triangles", (*vessel)->surface.triangles.size()},
                                 {"vertices", (*vessel)->surface.vertices.size()},
                                 {"closed", is_closed((*vessel)->surface)},
                                 {"source", spec->source},
                                 {"sha256", spec->sha256}};
  if (output.json) return output.print(document);
  for (const auto& [key, value] : document.items()) {
    std::cout << std::left << std::setw(16) << key << value << '\n';
  }
}

}  // namespace

void add_anatomy(CLI::App& app, Output& output) {
  CLI::App* anatomy = app.add_subcommand("anatomy", "Vessels to train in: list, show");
  anatomy->require_subcommand(1);
  anatomy->footer("Example: cathedra anatomy show s-bend-phantom");
  CLI::App* list_command = anatomy->add_subcommand("list", "All anatomies");
  list_command->footer("Example: cathedra anatomy list --json");
  add_json_flag(*list_command, output);
  list_command->callback([&output] { list(output); });
  auto id = std::make_shared<std::string>();  // shared: kept alive by the callback
  CLI::App* show_command =
      anatomy->add_subcommand("show", "Build one and describe its surface and centreline");
  show_command->footer("Example: cathedra anatomy show straight-phantom --json");
  show_command->add_option("anatomy", *id, "Id of the anatomy")->required();
  add_json_flag(*show_command, output);
  show_command->callback([id, &output] { show(*id, output); });
}

}  // namespace app::cli
