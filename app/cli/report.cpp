// cathedra report compare: novices against experts as a page or a table.
#include <iostream>
#include <string>

#include "app/cli/command.h"
#include "app/session/comparison_data.h"
#include "app/session/published_data.h"
#include "assessment/comparison.h"
#include "reports/comparison_report.h"

namespace app::cli {
namespace {

using nlohmann::ordered_json;

struct Options {
  std::string exercise;
  std::string dataset = "live";
  std::string database = "sqlite:cathedra.db";
  std::string format = "html";
  std::string out;
};

ordered_json group_json(const assessment::GroupResult& group) {
  const auto optional = [](const std::optional<double>& value) {
    return value ? ordered_json(*value) : ordered_json();
  };
  return {{"group", group.group},
          {"participants", group.participants},
          {"trials", group.trials},
          {"mean_s", group.over_participants.mean},
          {"sd_over_participants_s", optional(group.over_participants.standard_deviation)},
          {"sd_over_trials_s", optional(group.over_trials.standard_deviation)},
          {"improvement_percent", optional(group.improvement_percent)}};
}

ordered_json comparison_json(const assessment::GroupComparison& comparison,
                             const reports::ComparisonSubject& subject) {
  ordered_json document = {{"exercise", subject.exercise_id},
                           {"dataset", subject.dataset},
                           {"apparatus", subject.apparatus},
                           {"data_sha256", subject.data_sha256},
                           {"expert", group_json(comparison.first)},
                           {"novice", group_json(comparison.second)},
                           {"mann_whitney_u", comparison.ranks.u_first},
                           {"p", comparison.ranks.p_two_sided},
                           {"p_floor", comparison.ranks.p_floor}};
  if (comparison.effect) {
    document["hedges_g"] = comparison.effect->g;
    if (const auto& interval = comparison.effect->interval) {
      document["hedges_g_low"] = interval->low;
      document["hedges_g_high"] = interval->high;
    }
  }
  document["nesting"] = comparison.nesting;
  document["warnings"] = comparison.warnings;
  return document;
}

void compare(const Options& options, Output& output) {
  const auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  const curricula::Exercise* exercise = nullptr;
  for (const curricula::Curriculum& curriculum : library->curricula) {
    if (!exercise) exercise = curriculum.find(options.exercise);
  }
  if (!exercise) {
    return output.fail(
        "there is no exercise \"" + options.exercise + "\"; see: cathedra exercise list",
        kWrongCall);
  }
  if (options.dataset != kPaperDataset) {  // which brings its data along
    const base::Status there = require_database(options.database);
    if (!there) return output.fail(there.error());
  }
  auto store = open_prepared(options.database, *library);
  if (!store) return output.fail(store.error());
  if (options.dataset == kPaperDataset) {
    const auto added = load_published_data(
        **store,
        (library_folder().parent_path() / "app" / "demo" / "published_trials.csv").string());
    if (!added) return output.fail(added.error());
    if (*added > 0)
      std::cerr << "Loaded the published data into this database: " << *added << " rows.\n";
  }
  const auto data = comparison_data(**store, *exercise, options.dataset);
  if (!data) return output.fail(data.error());
  const auto comparison = assessment::compare_groups(data->rows);
  if (!comparison) return output.fail(comparison.error().message);

  const std::string text = options.format == "csv"
                               ? reports::comparison_csv(*comparison, data->subject)
                               : reports::comparison_html(*comparison, data->subject);
  if (!options.out.empty()) {
    const base::Status written = write_whole_file(options.out, text);
    if (!written) return output.fail(written.error());
  }
  if (output.json) return output.print(comparison_json(*comparison, data->subject));
  if (options.out.empty()) {
    std::cout << text;
  } else {
    std::cout << reports::comparison_headline(*comparison) << "\nWritten to " << options.out
              << ".\n";
  }
}

}  // namespace

void add_report(CLI::App& app, Output& output) {
  CLI::App* report = app.add_subcommand("report", "Reports as HTML and CSV");
  report->require_subcommand(1);
  report->footer(
      "Example: cathedra report compare --exercise linear --dataset paper -o linear.html");
  auto options = std::make_shared<Options>();  // shared: kept alive by the callback
  CLI::App* command = report->add_subcommand("compare", "Novices against experts at one exercise");
  command->footer(
      "Example: cathedra report compare --exercise linear --dataset paper --format csv -o "
      "linear.csv");
  command->add_option("--exercise", options->exercise, "Id of the exercise")->required();
  command->add_option("--dataset", options->dataset, "paper, live or simulated: never pooled")
      ->check(CLI::IsMember({"paper", "live", "simulated"}))
      ->capture_default_str();
  command->add_option("--database", options->database, "sqlite:PATH")->capture_default_str();
  command->add_option("--format", options->format, "What to write")
      ->check(CLI::IsMember({"html", "csv"}))
      ->capture_default_str();
  command->add_option("-o,--output", options->out,
                      "File to write; without it the report is printed");
  add_json_flag(*command, output);
  command->callback([options, &output] { compare(*options, output); });
}

}  // namespace app::cli
