#include "app/session/simulated_trial.h"

#include <chrono>
#include <utility>
#include <vector>

#include "app/devices/simulated_operator.h"
#include "database/people.h"

namespace app {

base::Result<SimulatedResult> run_simulated(database::Store& store, const SimulatedTrial& trial,
                                            std::shared_ptr<const Scene> scene,
                                            const std::function<bool(double)>& progress) {
  const auto skill = find_skill(trial.skill);
  if (!skill) {
    return base::Error{
        base::ErrorCode::invalid_input,
        "there is no operator \"" + trial.skill + "\"; use expert, intermediate or novice"};
  }
  TrialHead head;
  head.person_id = trial.person_id;
  head.curriculum_id = trial.curriculum->id;
  head.exercise_id = trial.exercise->id;
  head.source = assessment::Source::simulated_operator;
  head.device = "simulated:" + trial.skill;
  head.seed = trial.seed;
  const auto begun = begin(store, head, *scene);
  if (!begun) return begun.error();

  const auto start = std::chrono::steady_clock::now();
  SimulatedOperator hand(*skill, trial.seed, trial.practice);
  TrialRun run(std::move(scene), *trial.exercise);
  const auto step_count = static_cast<double>(run.monitor().steps().size());
  while (!run.ended()) {
    run.step(hand.next(run.world().observation(), run.monitor()));
    if (run.world().observation().step % 1000 != 0) continue;
    if (progress && !progress(run.monitor().task().step_index / step_count)) run.abort();
    const std::vector<RecordedSecond> seconds = run.take_recorded();
    const base::Status written = append(store, begun->trial_id, seconds);
    if (!written) return written.error();
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;

  SimulatedResult result;
  result.begun = *begun;
  auto judgement = finish(store, begun->trial_id, run, *trial.exercise, {});
  if (!judgement) return judgement.error();
  result.judgement = *std::move(judgement);
  result.end_reason = run.monitor().task().end_reason;
  result.simulated_s = static_cast<double>(run.world().observation().step) * sim::kStepLength;
  result.wall_s = wall.count();
  result.state_hash = run.state_hash();
  return result;
}

base::Result<std::string> simulated_person(database::Store& store, const std::string& name,
                                           const std::string& display_name,
                                           const std::string& skill) {
  const auto known = database::person_by_name(store, name);
  if (known) return known->id;
  database::NewPerson person;
  person.name = name;
  person.display_name = display_name;
  person.kind = database::PersonKind::simulated;
  database::Level level;
  if (database::parse(skill, level)) person.level = level;
  const auto added = database::add_person(store, person, "system");
  if (!added) return added.error();
  return added->id;
}

}  // namespace app
