// cathedra exercise list | run: what there is to do, and a simulated operator doing it.
#include <iostream>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/session/simulated_trial.h"
#include "assessment/metrics.h"

namespace app::cli {
namespace {

using nlohmann::ordered_json;

struct RunOptions {
  std::string exercise;
  std::string skill = "expert";
  std::uint64_t seed = 1;
  int practice = 1;
  int trials = 1;
  std::string database = "sqlite:cathedra.db";
};

// An exercise id, and the curriculum it stands in.
struct Found {
  const curricula::Curriculum* curriculum = nullptr;
  const curricula::Exercise* exercise = nullptr;
};

Found find_exercise(const curricula::Library& library, const std::string& id) {
  for (const curricula::Curriculum& curriculum : library.curricula) {
    if (const curricula::Exercise* exercise = curriculum.find(id)) return {&curriculum, exercise};
  }
  return {};
}

std::string known_exercises(const curricula::Library& library) {
  std::string names;
  for (const curricula::Curriculum& curriculum : library.curricula) {
    for (const curricula::Exercise& exercise : curriculum.exercises) {
      names += (names.empty() ? "" : ", ") + exercise.id;
    }
  }
  return names;
}

ordered_json verdict_json(const assessment::Verdict& verdict) {
  ordered_json criteria = ordered_json::array();
  for (const assessment::Criterion& criterion : verdict.criteria) {
    criteria.push_back({{"subject", criterion.subject},
                        {"op", assessment::sign(criterion.comparison)},
                        {"needed", criterion.bound},
                        {"value", criterion.value ? ordered_json(*criterion.value) : nullptr},
                        {"met", criterion.met},
                        {"provisional", criterion.provisional}});
  }
  return {{"outcome", assessment::word(verdict.outcome)},
          {"sentence", verdict.sentence},
          {"criteria", criteria}};
}

ordered_json result_json(const RunOptions& options, const Found& found,
                         const SimulatedResult& result, int practice, std::uint64_t seed) {
  ordered_json steps = ordered_json::array();
  for (const assessment::StepTime& step : result.judgement.step_times) {
    steps.push_back({{"id", step.step_id}, {"time_s", step.seconds}});
  }
  ordered_json metrics = ordered_json::object();
  double time_s = result.simulated_s;
  for (const assessment::MetricValue& metric : result.judgement.metrics) {
    metrics[metric.id] = metric.value;
    if (metric.id == "time_s") time_s = metric.value;
  }
  return {{"trial_id", result.begun.trial_id},
          {"exercise", found.exercise->id},
          {"exercise_version", found.exercise->version},
          {"ordinal", result.begun.ordinal},
          {"source", assessment::word(assessment::Source::simulated_operator)},
          {"operator", options.skill},
          {"seed", seed},
          {"practice", practice},
          {"end_reason", assessment::word(result.end_reason)},
          {"time_s", time_s},
          {"simulated_s", result.simulated_s},
          {"wall_s", result.wall_s},
          {"steps", steps},
          {"metrics", metrics},
          {"verdict", verdict_json(result.judgement.verdict)},
          {"state_hash", result.state_hash}};
}

void print_human(const ordered_json& result) {
  std::cout << result["exercise"].get<std::string>() << ", simulated operator ("
            << result["operator"].get<std::string>() << "), seed " << result["seed"] << '\n'
            << "  " << result["verdict"]["sentence"].get<std::string>() << '\n'
            << "  " << result["simulated_s"] << " s simulated in " << result["wall_s"] << " s\n";
  for (const auto& [id, value] : result["metrics"].items()) {
    const assessment::MetricDefinition* metric = assessment::find_metric(id);
    std::cout << "  " << (metric ? metric->title : id) << ": " << value << ' '
              << (metric ? metric->unit : "") << '\n';
  }
  std::cout << "  trial " << result["trial_id"].get<std::string>() << "\n  state "
            << result["state_hash"].get<std::string>() << '\n';
}

void run(const RunOptions& options, Output& output) {
  auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  SceneStore scenes(*std::move(library));
  const Found found = find_exercise(scenes.library(), options.exercise);
  if (!found.exercise) {
    return output.fail("there is no exercise \"" + options.exercise + "\"; known are " +
                           known_exercises(scenes.library()),
                       kWrongCall);
  }
  auto store = open_prepared(options.database, scenes.library());
  if (!store) return output.fail(store.error());
  const auto scene = scenes.scene(found.exercise->scene);
  if (!scene) return output.fail(scene.error());
  const auto person = simulated_person(**store, "simulated:" + options.skill,
                                       "Simulated " + options.skill, options.skill);
  if (!person) return output.fail(person.error());

  ordered_json results = ordered_json::array();
  for (int k = 0; k < options.trials; ++k) {
    const std::uint64_t seed = options.seed + static_cast<std::uint64_t>(k);
    const int practice = options.practice + k;
    ProgressBar bar(options.exercise + " by " + options.skill + ", seed " + std::to_string(seed));
    const auto result = run_simulated(
        **store, {found.curriculum, found.exercise, options.skill, seed, practice, *person}, *scene,
        [&](double fraction) {
          bar.set(fraction);
          return true;
        });
    if (!result) return output.fail(result.error());
    results.push_back(result_json(options, found, *result, practice, seed));
    if (!output.json) print_human(results.back());
    if (result->end_reason == assessment::EndReason::diverged) output.exit_code = kFailed;
  }
  if (output.json) output.print(options.trials == 1 ? results.front() : results);
}

void list(Output& output) {
  const auto library = load_installed_library();
  if (!library) return output.fail(library.error());
  ordered_json rows = ordered_json::array();
  for (const curricula::Curriculum& curriculum : library->curricula) {
    for (const curricula::Exercise& exercise : curriculum.exercises) {
      rows.push_back({{"exercise", exercise.id},
                      {"version", exercise.version},
                      {"title", exercise.title.at("en")},
                      {"curriculum", curriculum.id},
                      {"curriculum_version", curriculum.version},
                      {"anatomy", exercise.scene.anatomy},
                      {"instruments", exercise.scene.instruments}});
    }
  }
  if (output.json) return output.print(rows);
  for (const auto& row : rows) {
    std::cout << row["exercise"].get<std::string>() << "  " << row["title"].get<std::string>()
              << "  (" << row["curriculum"].get<std::string>() << ' '
              << row["curriculum_version"].get<std::string>() << ", "
              << row["anatomy"].get<std::string>() << ")\n";
  }
}

}  // namespace

void add_exercise(CLI::App& app, Output& output) {
  CLI::App* exercise =
      app.add_subcommand("exercise", "List exercises, or let a simulated operator do one");
  exercise->require_subcommand(1);
  exercise->footer(
      "Example: cathedra exercise run linear --operator expert --seed 7 --database sqlite:t.db");

  CLI::App* list_command =
      exercise->add_subcommand("list", "All exercises of the built-in curricula");
  list_command->footer("Example: cathedra exercise list --json");
  add_json_flag(*list_command, output);
  list_command->callback([&output] { list(output); });

  auto options = std::make_shared<RunOptions>();  // shared: kept alive by the callback
  CLI::App* run_command = exercise->add_subcommand(
      "run",
      "A simulated operator does one exercise; the trial is filed and labelled as simulated");
  run_command->footer(
      "Example: cathedra exercise run linear --operator novice --seed 3 --trials 10");
  run_command->add_option("exercise", options->exercise, "Id of the exercise (see: exercise list)")
      ->required();
  run_command->add_option("--operator", options->skill, "Skill")
      ->check(CLI::IsMember({"expert", "intermediate", "novice"}))
      ->capture_default_str();
  run_command->add_option("--seed", options->seed, "Seed of the operator's random numbers")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  run_command
      ->add_option("--practice", options->practice,
                   "Number of the operator's trial: later ones are better")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  run_command->add_option("--trials", options->trials, "How many, with rising seed and practice")
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  run_command->add_option("--database", options->database, "sqlite:PATH; made when absent")
      ->capture_default_str();
  add_json_flag(*run_command, output);
  run_command->callback([options, &output] { run(*options, output); });
}

}  // namespace app::cli
