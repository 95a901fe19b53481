#include "app/server/views/briefing_view.h"

#include <string>
#include <utility>
#include <vector>

#include "app/server/views/words.h"
#include "assessment/metrics.h"
#include "sim/base/units.h"

namespace app {
namespace {

using namespace base::units;
using nlohmann::json;
using Kind = curricula::Step::Kind;

const char* word(Kind kind) {
  switch (kind) {
    case Kind::translate:
      return "translate";
    case Kind::rotate:
      return "rotate";
    case Kind::hold:
      return "hold";
    case Kind::repeat:
      return "repeat";
  }
  return "";
}

const char* word(curricula::Consequence consequence) {
  switch (consequence) {
    case curricula::Consequence::mark:
      return "mark";
    case curricula::Consequence::fail:
      return "fail";
    case curricula::Consequence::critical_error:
      return "critical_error";
    case curricula::Consequence::stop:
      return "stop";
  }
  return "";
}

struct Round {
  int number = 0, of = 0;  // 0 outside a repeat
};

// The round each step of unroll() belongs to, in the same order.
void add_rounds(const std::vector<curricula::Step>& steps, Round round, std::vector<Round>& out) {
  for (const curricula::Step& step : steps) {
    if (step.kind != Kind::repeat) {
      out.push_back(round);
      continue;
    }
    for (int i = 1; i <= step.times; ++i) add_rounds(step.steps, {i, step.times}, out);
  }
}

json step_json(const curricula::Step& step, const std::string& title, Round round) {
  const bool turns = step.kind == Kind::rotate;
  const double unit = turns ? 1.0_deg : 1.0;
  return {{"id", step.id},
          {"kind", word(step.kind)},
          {"title", title},
          {"target", step.kind == Kind::hold ? step.seconds : step.target / unit},
          {"tolerance", step.tolerance / unit},
          {"hold_s", step.hold},
          {"unit", step.kind == Kind::hold ? "s"
                   : turns                 ? "deg"
                                           : "mm"},
          {"round", round.number},
          {"rounds", round.of}};
}

json steps_json(const curricula::Exercise& exercise) {
  std::vector<Round> rounds;
  add_rounds(exercise.steps, {}, rounds);
  const std::vector<curricula::Step> steps = curricula::unroll(exercise.steps);
  const std::vector<std::string> titles = curricula::describe_all(steps);
  json list = json::array();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    list.push_back(step_json(steps[i], titles[i], i < rounds.size() ? rounds[i] : Round{}));
  }
  return list;
}

json limits_json(const curricula::Exercise& exercise) {
  json list = json::array();
  for (const curricula::Limit& limit : exercise.limits) {
    list.push_back({{"metric", limit.metric},
                    {"title", subject_title(limit.metric)},
                    {"op", assessment::sign(limit.comparison)},
                    {"value", limit.bound},
                    {"unit", subject_unit(limit.metric)},
                    {"on_breach", word(limit.on_breach)}});
  }
  return list;
}

void collect_metric_leaves(const assessment::Rule& rule,
                           std::vector<const assessment::Rule*>& out) {
  if (rule.kind == assessment::Rule::Kind::metric) out.push_back(&rule);
  if (rule.kind == assessment::Rule::Kind::negate) return;  // what must not be is no target
  for (const assessment::Rule& child : rule.children) collect_metric_leaves(child, out);
}

std::vector<const assessment::Rule*> metric_leaves(const curricula::Exercise& exercise) {
  std::vector<const assessment::Rule*> leaves;
  if (exercise.pass) collect_metric_leaves(*exercise.pass, leaves);
  return leaves;
}

std::string reason_of(const curricula::Curriculum& curriculum, const std::string& benchmark_id) {
  for (const curricula::Benchmark& benchmark : curriculum.benchmarks) {
    if (benchmark.id == benchmark_id) return english(benchmark.reason);
  }
  return {};
}

json targets_json(const curricula::Curriculum& curriculum, const curricula::Exercise& exercise) {
  json list = json::array();
  for (const assessment::Rule* leaf : metric_leaves(exercise)) {
    list.push_back({{"metric", leaf->subject},
                    {"op", assessment::sign(leaf->comparison)},
                    {"value", leaf->bound},
                    {"unit", subject_unit(leaf->subject)},
                    {"provisional", leaf->provisional},
                    {"reason", reason_of(curriculum, leaf->benchmark)}});
  }
  return list;
}

json instrument_json(const curricula::Exercise& exercise, const curricula::Library& library) {
  const std::string id =
      exercise.scene.instruments.empty() ? std::string{} : exercise.scene.instruments.front();
  const curricula::InstrumentSpec* spec = library.instrument(id);
  if (spec == nullptr) {
    return {{"id", id},
            {"title", id},
            {"kind", "guidewire"},
            {"outer_diameter_mm", 0.0},
            {"length_mm", 0.0}};
  }
  return {{"id", spec->id},
          {"title", spec->title},
          {"kind", spec->kind},
          {"outer_diameter_mm", spec->outer_diameter},
          {"length_mm", spec->length()}};
}

}  // namespace

json briefing_json(const curricula::Curriculum& curriculum, const curricula::Exercise& exercise,
                   const curricula::ExerciseState& state, const curricula::Library& library) {
  const curricula::AnatomySpec* anatomy = library.anatomy(exercise.scene.anatomy);
  return {{"exercise_id", exercise.id},
          {"version", exercise.version},
          {"title", english(exercise.title)},
          {"goal", english(exercise.goal)},
          {"status", assessment::word(state.progress.status)},
          {"status_sentence", state.may_start ? state.progress.sentence : state.why_not},
          {"can_start", state.may_start},
          {"steps", steps_json(exercise)},
          {"limits", limits_json(exercise)},
          {"instrument", instrument_json(exercise, library)},
          {"anatomy_id", exercise.scene.anatomy},
          {"anatomy_title", anatomy == nullptr ? exercise.scene.anatomy : anatomy->title},
          {"time_limit_s", exercise.attempt.time_limit},
          {"targets", targets_json(curriculum, exercise)},
          {"pass_sentence",
           exercise.pass ? rule_sentence(*exercise.pass) : "Practice: recorded, but not judged."},
          {"record", exercise.record}};
}

const assessment::Rule* target_of(const curricula::Exercise& exercise, const std::string& metric) {
  using assessment::Comparison;
  for (const assessment::Rule* leaf : metric_leaves(exercise)) {
    const bool upper =
        leaf->comparison == Comparison::less || leaf->comparison == Comparison::less_equal;
    if (leaf->subject == metric && upper) return leaf;
  }
  return nullptr;
}

const assessment::Rule* bound_of(const curricula::Exercise& exercise, const std::string& metric) {
  using assessment::Comparison;
  for (const assessment::Rule* leaf : metric_leaves(exercise)) {
    const bool a_side =
        leaf->comparison != Comparison::equal && leaf->comparison != Comparison::not_equal;
    if (leaf->subject == metric && a_side) return leaf;
  }
  return nullptr;
}

}  // namespace app
