#include "curricula/read_exercise.h"

#include <algorithm>
#include <limits>
#include <set>

#include "assessment/metrics.h"
#include "curricula/nearest.h"
#include "curricula/read_benchmarks.h"
#include "curricula/read_rule.h"
#include "curricula/read_steps.h"

namespace curricula {
namespace {

constexpr double kLargest = 1e9;           // of a bound, in whatever unit
constexpr double kLongestTrial = 86400.0;  // s
constexpr std::int64_t kMostTrials = 10000;

// Metrics that grow during a trial and are computed while it runs.
const std::vector<std::string> kLiveMetrics = {"force_max_n",     "handle_force_max_n",
                                               "torque_max_n_mm", "wall_hits",
                                               "time_s",          "contact_impulse_n_s"};
const std::vector<std::string> kConsequences = {"mark", "fail", "critical_error", "stop"};
const std::vector<std::string> kFeedbackDuring = {"force", "torque", "progress", "time", "steps"};
const std::vector<std::string> kFeedbackAfter = {"time",  "contact", "target_line",
                                                 "steps", "metrics", "events"};

template <typename Entry>
const Entry* find_entry(const std::vector<Entry>& entries, const std::string& id) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const Entry& entry) { return entry.id == id; });
  return found == entries.end() ? nullptr : &*found;
}

template <typename Entry>
void report_unknown(const char* what, const std::string& id, const YamlNode& at,
                    const std::vector<Entry>& entries, Problems& problems) {
  std::vector<std::string> known;
  for (const Entry& entry : entries) known.push_back(entry.id);
  const std::string guess = problems.full() ? "" : nearest(id, known);
  problems.error(at, std::string("there is no ") + what + " '" + id.substr(0, 64) + "': " +
                         (!guess.empty()  ? "did you mean '" + guess + "'?"
                          : known.empty() ? "the catalogue is empty"
                                          : "choose " + alternatives(known)));
}

Attempt read_attempt(const YamlNode& node, Attempt attempt, Problems& problems) {
  Fields fields(node, "'attempt'", problems);
  attempt.time_limit =
      fields.number("time_limit_s", {0.0, kLongestTrial, true}).value_or(attempt.time_limit);
  const std::vector<std::string> words = {"fail", "invalid"};
  if (const auto choice = fields.choice("on_timeout", words)) attempt.timeout_fails = *choice == 0;
  if (const auto choice = fields.choice("on_abort", words)) attempt.abort_fails = *choice == 0;
  fields.finish();
  return attempt;
}

std::vector<std::string> read_shown(Fields& fields, const char* key,
                                    const std::vector<std::string>& known, Problems& problems) {
  std::vector<std::string> shown;
  for (const Fields::Word& word : fields.words(key)) {
    if (std::find(known.begin(), known.end(), word.text) == known.end()) {
      problems.error(*word.node, "there is no feedback '" + word.text.substr(0, 64) +
                                     "' here: write " + alternatives(known));
    }
    shown.push_back(word.text);
  }
  return shown;
}

void read_feedback(const YamlNode& node, std::vector<std::string>& during,
                   std::vector<std::string>& after, Problems& problems) {
  Fields fields(node, "'feedback'", problems);
  const bool has_during = node.find("during") != nullptr, has_after = node.find("after") != nullptr;
  auto shown_during = read_shown(fields, "during", kFeedbackDuring, problems);
  auto shown_after = read_shown(fields, "after", kFeedbackAfter, problems);
  if (has_during) during = std::move(shown_during);
  if (has_after) after = std::move(shown_after);
  fields.finish();
}

// Reads the scene, and how far the handle can go in it.
Scene read_scene(const YamlNode& node, const Catalogue& catalogue, Reach& reach,
                 Problems& problems) {
  const std::size_t problems_before = problems.count();
  Fields fields(node, "'scene'", problems);
  Scene scene;
  scene.anatomy = fields.need_word("anatomy");
  if (!scene.anatomy.empty()) {
    const auto* anatomy = find_entry(catalogue.anatomies, scene.anatomy);
    if (anatomy) reach = {true, 0.0, anatomy->length, "anatomy '" + anatomy->id + "'"};
    if (!anatomy)
      report_unknown("anatomy", scene.anatomy, *fields.find("anatomy"), catalogue.anatomies,
                     problems);
  }
  fields.need_list("instruments");
  for (const Fields::Word& word : fields.words("instruments")) {
    const auto* instrument = find_entry(catalogue.instruments, word.text);
    if (!instrument)
      report_unknown("instrument", word.text, *word.node, catalogue.instruments, problems);
    if (instrument && (!reach.known || instrument->length < reach.length)) {
      reach = {true, 0.0, instrument->length, "instrument '" + instrument->id + "'"};
    }
    if (scene.instruments.size() == 1) {
      problems.error(*word.node,
                     "this version of the program steers one instrument at a time: take the "
                     "others out");
    }
    scene.instruments.push_back(word.text);
  }
  scene.start = fields.number("start_mm", {0.0, 5000.0}).value_or(0.0);
  if (reach.known && scene.start > reach.length) {
    problems.error(*fields.find("start_mm"), "'start_mm' lies beyond the end of " + reach.shorter +
                                                 ": write a smaller number");
  }
  reach.start = scene.start;
  constexpr std::int64_t kLargestSeed = std::int64_t{1} << 53;  // exact in every reader of the file
  scene.seed = static_cast<std::uint64_t>(fields.integer("seed", 0, kLargestSeed).value_or(0));
  fields.unavailable("access", "every anatomy of this version has one access: take 'access' out");
  fields.finish();
  // a wrong start would make every target look wrong
  reach.known = reach.known && problems.count() == problems_before;
  return scene;
}

Limit read_limit(const YamlNode& node, Problems& problems) {
  Fields fields(node, "a limit", problems);
  Limit limit;
  limit.metric = fields.need_word("metric");
  if (!limit.metric.empty()) {
    const YamlNode& at = *fields.find("metric");
    const bool live =
        std::find(kLiveMetrics.begin(), kLiveMetrics.end(), limit.metric) != kLiveMetrics.end();
    if (!live && check_metric(limit.metric, at, problems)) {
      problems.error(at, "'" + limit.metric + "' cannot be watched while a trial runs: use " +
                             alternatives(kLiveMetrics));
    }
  }
  const std::vector<std::string> signs = {"<", "<="};
  if (const auto sign = fields.need_choice("op", signs))
    assessment::parse(signs[*sign], limit.comparison);
  limit.bound = fields.need_number("value", {0.0, kLargest});
  if (const auto choice = fields.need_choice("on_breach", kConsequences)) {
    limit.on_breach = static_cast<Consequence>(*choice);
  }
  fields.finish();
  return limit;
}

std::vector<std::string> read_record(Fields& fields, Problems& problems) {
  std::vector<std::string> record;
  std::set<std::string> seen;
  fields.need_list("record");
  for (const Fields::Word& word : fields.words("record")) {
    check_metric(word.text, *word.node, problems);
    if (!seen.insert(word.text).second) {
      problems.error(*word.node,
                     "'" + word.text.substr(0, 64) + "' is recorded already: take it out here");
    }
    record.push_back(word.text);
  }
  return record;
}

assessment::ProficiencyRule read_proficiency(const YamlNode& node, Problems& problems) {
  Fields fields(node, "'proficiency'", problems);
  assessment::ProficiencyRule rule;
  rule.consecutive = static_cast<int>(fields.need_integer("consecutive", 1, kMostTrials));
  rule.additional = static_cast<int>(fields.integer("additional", 0, kMostTrials).value_or(0));
  rule.min_trials = static_cast<int>(fields.integer("min_trials", 0, kMostTrials).value_or(0));
  rule.max_trials = static_cast<int>(fields.integer("max_trials", 0, kMostTrials).value_or(0));
  fields.unavailable("window",
                     "'window' is part of the format, but not available in this version: "
                     "use 'consecutive' and 'additional'");
  fields.finish();
  const int fewest = std::max(rule.min_trials, rule.consecutive + rule.additional);
  if (rule.max_trials > 0 && rule.max_trials < fewest) {
    problems.error(*node.find("max_trials"),
                   "nobody can become proficient in " + std::to_string(rule.max_trials) +
                       " trials: write at least " + std::to_string(fewest));
  }
  return rule;
}

void read_requirements(const YamlNode& node, ExerciseDraft& draft, Problems& problems) {
  Fields fields(node, "'requires'", problems);
  for (const YamlNode* item : fields.need_list("all")) {
    Fields requirement(*item, "a requirement", problems);
    const std::string exercise = requirement.need_word("exercise");
    requirement.need_choice("state", {"proficient"});
    requirement.finish();
    if (exercise.empty()) continue;
    draft.requirements.push_back({exercise, requirement.find("exercise")});
    draft.exercise.requires_proficient.push_back(exercise);
  }
  fields.unavailable("any",
                     "'any' is part of the format, but not available in this version: use 'all'");
  fields.finish();
}

void read_ratings(Fields& fields, Problems& problems) {
  const std::vector<const YamlNode*> ratings = fields.list("ratings");
  for (const YamlNode* node : ratings) {
    Fields rating(*node, "a rating", problems);
    rating.need_word("form");
    rating.need_choice("by", {"instructor", "self"});
    rating.integer("every", 1, kMostTrials);
    rating.finish();
  }
  if (!ratings.empty()) {
    problems.warning(*ratings.front(),
                     "this version of the program does not ask for ratings yet: they "
                     "are kept in the file only");
  }
}

}  // namespace

ExerciseDefaults read_defaults(const YamlNode& node, Problems& problems) {
  ExerciseDefaults defaults;
  Fields fields(node, "'defaults'", problems);
  if (const YamlNode* attempt = fields.find("attempt")) {
    defaults.attempt = read_attempt(*attempt, defaults.attempt, problems);
  }
  if (const YamlNode* feedback = fields.find("feedback")) {
    read_feedback(*feedback, defaults.feedback_during, defaults.feedback_after, problems);
  }
  fields.finish();
  return defaults;
}

ExerciseDraft read_exercise(const YamlNode& node, const ExerciseContext& context,
                            Problems& problems) {
  ExerciseDraft draft;
  Exercise& exercise = draft.exercise;
  Fields fields(node, "an exercise", problems);
  draft.node = &node;
  exercise.line = node.line;
  exercise.id = fields.need_id("id");
  draft.id_node = exercise.id.empty() ? nullptr : fields.find("id");
  exercise.version =
      static_cast<int>(fields.need_integer("version", 1, std::numeric_limits<int>::max()));
  exercise.title = fields.need_text("title", 200);
  exercise.goal = fields.text("goal").value_or(Text{});
  if (const YamlNode* requirements = fields.find("requires")) {
    read_requirements(*requirements, draft, problems);
  }

  Reach reach;
  if (const YamlNode* scene = fields.need("scene")) {
    exercise.scene = read_scene(*scene, context.catalogue, reach, problems);
  }
  exercise.steps = read_steps(fields.need_list("steps"), reach, problems);
  for (const YamlNode* limit : fields.list("limits")) {
    exercise.limits.push_back(read_limit(*limit, problems));
  }

  exercise.attempt = context.defaults.attempt;
  exercise.feedback_during = context.defaults.feedback_during;
  exercise.feedback_after = context.defaults.feedback_after;
  if (const YamlNode* attempt = fields.find("attempt")) {
    exercise.attempt = read_attempt(*attempt, exercise.attempt, problems);
  }
  if (const YamlNode* feedback = fields.find("feedback")) {
    read_feedback(*feedback, exercise.feedback_during, exercise.feedback_after, problems);
  }

  draft.has_record = fields.find("record") != nullptr;
  if (draft.has_record) exercise.record = read_record(fields, problems);
  if (const YamlNode* pass = fields.find("pass")) {
    draft.has_pass = true;
    exercise.pass =
        read_rule(*pass, {context.benchmarks, exercise.record, context.truncated}, problems);
  }
  if (const YamlNode* proficiency = fields.find("proficiency")) {
    draft.has_proficiency = true;
    exercise.proficiency = read_proficiency(*proficiency, problems);
    if (!draft.has_pass && node.complete) {
      problems.error(*proficiency,
                     "proficiency counts passes, but this exercise cannot be passed: add "
                     "'pass'");
    }
  }
  read_ratings(fields, problems);
  fields.finish();
  return draft;
}

}  // namespace curricula
