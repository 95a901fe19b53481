// cathedra trial list | show | verify | replay: what is stored, and whether it is genuine.
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

#include "app/cli/command.h"
#include "app/session/replay.h"
#include "app/session/trial_file.h"
#include "assessment/metrics.h"
#include "database/trials.h"

namespace app::cli {
namespace {

using nlohmann::ordered_json;

struct Options {
  std::string database = "sqlite:cathedra.db";
  std::string trial;
  std::string exercise;
  std::string csv;
};

ordered_json head_json(const database::StoredTrial& trial) {
  ordered_json metrics = ordered_json::object();
  for (const assessment::MetricValue& metric : trial.metrics) metrics[metric.id] = metric.value;
  return {{"trial_id", trial.head.id},
          {"person", trial.person_name},
          {"exercise", trial.head.exercise_id},
          {"ordinal", trial.ordinal},
          {"source", assessment::word(trial.head.source)},
          {"apparatus", trial.head.apparatus},
          {"device", trial.head.device},
          {"started_utc", trial.head.started_utc},
          {"end_reason",
           trial.end_reason ? ordered_json(assessment::word(*trial.end_reason)) : nullptr},
          {"outcome", trial.outcome ? ordered_json(assessment::word(*trial.outcome)) : nullptr},
          {"voided", !trial.voided_utc.empty()},
          {"interrupted", trial.interrupted},
          {"build", trial.head.build},
          {"state_hash", trial.state_hash},
          {"metrics", metrics}};
}

base::Result<std::unique_ptr<database::Store>> open_existing(const std::string& url) {
  const base::Status there = require_database(url);
  if (!there) return there.error();
  return database::Store::open(url);
}

void list(const Options& options, Output& output) {
  auto store = open_existing(options.database);
  if (!store) return output.fail(store.error());
  database::TrialFilter filter;
  filter.exercise_id = options.exercise;
  filter.finished_only = false;
  const auto trials = database::trials(**store, filter);
  if (!trials) return output.fail(trials.error());
  ordered_json rows = ordered_json::array();
  for (const database::StoredTrial& trial : *trials) rows.push_back(head_json(trial));
  if (output.json) return output.print(rows);
  for (const auto& row : rows) {
    std::cout << row["trial_id"].get<std::string>() << "  " << std::left << std::setw(12)
              << row["exercise"].get<std::string>() << std::setw(24)
              << row["person"].get<std::string>() << std::right << std::setw(4) << row["ordinal"]
              << "  " << std::left << std::setw(20) << row["source"].get<std::string>();
    if (row["metrics"].contains("time_s")) {
      std::cout << std::fixed << std::setprecision(1) << row["metrics"]["time_s"].get<double>()
                << " s";
    }
    std::cout << '\n';
  }
}

void show(const Options& options, Output& output) {
  auto store = open_existing(options.database);
  if (!store) return output.fail(store.error());
  const auto trial = database::trial(**store, options.trial);
  if (!trial) return output.fail(trial.error());
  const auto verdict = database::trial_verdict(**store, options.trial);
  ordered_json document = head_json(*trial);
  document["verdict"] = verdict ? ordered_json(verdict->sentence) : nullptr;
  if (output.json) return output.print(document);
  for (const auto& [key, value] : document.items()) {
    if (key != "metrics") std::cout << std::left << std::setw(14) << key << value << '\n';
  }
  for (const assessment::MetricValue& metric : trial->metrics) {
    const assessment::MetricDefinition* definition = assessment::find_metric(metric.id);
    std::cout << "  " << std::left << std::setw(26)
              << (definition ? std::string(definition->title) : metric.id) << metric.value << ' '
              << (definition ? definition->unit : "") << '\n';
  }
}

void verify(const Options& options, Output& output) {
  auto store = open_existing(options.database);
  if (!store) return output.fail(store.error());
  auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  SceneStore scenes(*std::move(library));
  base::Result<Verification> result = [&] {
    ProgressBar bar("replaying");
    return verify_trial(**store, options.trial, scenes, [&](double f) { bar.set(f); });
  }();
  if (!result) return output.fail(result.error());
  output.exit_code = result->confirmed ? kWorked : kFailed;
  if (!output.json) {
    std::cout << result->sentence << '\n';
    return;
  }
  output.print(
      {{"trial_id", options.trial},
       {"confirmed", result->confirmed},
       {"same_build", result->same_build},
       {"sentence", result->sentence},
       {"chunk", result->chunk.empty() ? ordered_json() : ordered_json(result->chunk)},
       {"differs", result->differs.empty() ? ordered_json() : ordered_json(result->differs)},
       {"first_second_that_differs",
        result->first_second ? ordered_json(*result->first_second) : ordered_json()},
       {"largest_deviation_mm", result->largest_deviation_mm},
       {"seconds_compared", result->seconds}});
}

void write_trace(std::ostream& out, const assessment::RecordedTrial& trial) {
  out << "t_s,tip_x_mm,tip_y_mm,tip_z_mm,handle_axial_mm,handle_rotation_rad,inserted_mm,"
         "handle_force_n,handle_torque_n_mm,contact_force_n,contact_force_peak_n,"
         "contact_load_n,contacts\n"
      << std::setprecision(9);
  for (const assessment::Sample& s : trial.samples) {
    out << s.time << ',' << s.tip[0] << ',' << s.tip[1] << ',' << s.tip[2] << ',' << s.handle_axial
        << ',' << s.handle_rotation << ',' << s.inserted_length << ',' << s.handle_force << ','
        << s.handle_torque << ',' << s.contact_force << ',' << s.contact_force_peak << ','
        << s.contact_load << ',' << s.contact_count << '\n';
  }
}

void replay(const Options& options, Output& output) {
  auto store = open_existing(options.database);
  if (!store) return output.fail(store.error());
  auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  SceneStore scenes(*std::move(library));
  base::Result<assessment::RecordedTrial> trial = [&] {
    ProgressBar bar("replaying");
    return replay_trial(**store, options.trial, scenes, [&](double f) { bar.set(f); });
  }();
  if (!trial) return output.fail(trial.error());
  if (!options.csv.empty()) {
    std::ostringstream text;
    write_trace(text, *trial);
    const base::Status written = write_whole_file(options.csv, text.str());
    if (!written) return output.fail(written.error());
  }
  ordered_json events = ordered_json::array();
  for (const assessment::Event& event : trial->events) {
    events.push_back({{"time_s", event.time},
                      {"code", event.code},
                      {"severity", assessment::word(event.severity)},
                      {"detail", event.detail},
                      {"value", event.value}});
  }
  if (output.json) {
    return output.print({{"trial_id", options.trial},
                         {"end_reason", assessment::word(trial->end_reason)},
                         {"simulated_s", trial->end_time},
                         {"samples", trial->samples.size()},
                         {"events", events}});
  }
  for (const assessment::Event& event : trial->events) {
    std::cout << std::fixed << std::setprecision(3) << std::setw(9) << event.time << " s  "
              << event.code << ' ' << event.detail << '\n';
  }
}

}  // namespace

void add_trial(CLI::App& app, Output& output) {
  CLI::App* trial = app.add_subcommand("trial", "Stored trials: list, show, verify, replay");
  trial->require_subcommand(1);
  trial->footer("Example: cathedra trial verify 0197... --database sqlite:t.db");
  auto options = std::make_shared<Options>();  // shared: kept alive by the callbacks

  const auto add = [&](const char* name, const char* what, const char* example, bool one,
                       void (*action)(const Options&, Output&)) {
    CLI::App* command = trial->add_subcommand(name, what);
    command->footer(std::string("Example: ") + example);
    if (one) command->add_option("trial", options->trial, "Id of the trial")->required();
    command->add_option("--database", options->database, "sqlite:PATH")->capture_default_str();
    add_json_flag(*command, output);
    command->callback([options, action, &output] { action(*options, output); });
    return command;
  };
  add("list", "All trials", "cathedra trial list --exercise linear", false, list)
      ->add_option("--exercise", options->exercise, "Only of this exercise");
  add("show", "One trial: result, metrics, verdict", "cathedra trial show 0197...", true, show);
  add("verify",
      "Replay the recorded inputs and compare every recorded state; exit code 1 when it differs",
      "cathedra trial verify 0197... --database sqlite:t.db", true, verify);
  add("replay", "Replay the recorded inputs and print what happened",
      "cathedra trial replay 0197... --csv trace.csv", true, replay)
      ->add_option("--csv", options->csv, "Write the replayed trace here");
}

}  // namespace app::cli
