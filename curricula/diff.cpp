#include "curricula/diff.h"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <utility>

#include "curricula/number_text.h"
#include "curricula/semantic_version.h"
#include "curricula/yaml_tree.h"

namespace curricula {
namespace {

using assessment::Rule;
using Weight = Change::Weight;

constexpr double kDegreesPerRad = 180.0 / std::numbers::pi;

std::string instead(double after, double before, const char* unit) {
  const std::string suffix = *unit ? std::string(" ") + unit : "";
  return number_text(after) + suffix + " instead of " + number_text(before) + suffix;
}

bool same_rule(const Rule& a, const Rule& b, bool with_bounds) {
  const bool same = a.kind == b.kind && a.subject == b.subject && a.comparison == b.comparison &&
                    a.children.size() == b.children.size();
  if (!same || (with_bounds && a.bound != b.bound)) return false;
  for (std::size_t i = 0; i < a.children.size(); ++i) {
    if (!same_rule(a.children[i], b.children[i], with_bounds)) return false;
  }
  return true;
}

// Collects the changes of one exercise.
class ExerciseDiff {
 public:
  ExerciseDiff(const Exercise& before, const Exercise& after, std::vector<Change>& changes)
      : before_(before), after_(after), changes_(changes) {}

  void run() {
    steps();
    limits();
    scene();
    attempt();
    pass();
    proficiency();
    record();
    if (before_.requires_proficient != after_.requires_proficient) {
      add(Weight::minor, "what must be proficient before it changed");
    }
    if (before_.title != after_.title) add(Weight::patch, "the title changed");
    if (before_.goal != after_.goal) add(Weight::patch, "the text of the goal changed");
    if (before_.feedback_during != after_.feedback_during ||
        before_.feedback_after != after_.feedback_after) {
      add(Weight::minor, "the feedback changed");
    }
  }

 private:
  void add(Weight weight, const std::string& what) {
    changes_.push_back({weight, after_.id, after_.id + ": " + what});
  }

  void steps() {
    if (before_.steps == after_.steps) return;
    const std::vector<Step> before = unroll(before_.steps), after = unroll(after_.steps);
    const auto same_step = [](const Step& a, const Step& b) {
      return a.id == b.id && a.kind == b.kind;
    };
    if (before.size() != after.size() ||
        !std::equal(before.begin(), before.end(), after.begin(), same_step)) {
      add(Weight::major, "there are other steps: " + std::to_string(after.size()) +
                             ", there were " + std::to_string(before.size()));
      return;
    }
    for (std::size_t i = 0; i < before.size(); ++i) step(before[i], after[i]);
  }

  void step(const Step& before, const Step& after) {
    const bool turns = after.kind == Step::Kind::rotate;
    const double scale = turns ? kDegreesPerRad : 1.0;
    const char* unit = turns ? "degrees" : "mm";
    const std::string name = "step '" + after.id + "' ";
    if (before.target != after.target) {
      add(Weight::major,
          name + "goes to " + instead(after.target * scale, before.target * scale, unit));
    }
    if (before.tolerance != after.tolerance) {
      add(Weight::major, name + "has a tolerance of " +
                             instead(after.tolerance * scale, before.tolerance * scale, unit));
    }
    if (before.hold != after.hold) {
      add(Weight::major, name + "is held for " + instead(after.hold, before.hold, "s"));
    }
    if (before.seconds != after.seconds) {
      add(Weight::major, name + "lasts " + instead(after.seconds, before.seconds, "s"));
    }
  }

  static const Limit* find_limit(const std::vector<Limit>& limits, const std::string& metric) {
    const auto found = std::find_if(limits.begin(), limits.end(),
                                    [&](const Limit& limit) { return limit.metric == metric; });
    return found == limits.end() ? nullptr : &*found;
  }

  void limits() {
    const std::size_t so_far = changes_.size();
    for (const Limit& after : after_.limits) {
      const Limit* before = find_limit(before_.limits, after.metric);
      if (!before) {
        add(Weight::major, "there is a new limit on " + after.metric);
      } else if (before->bound != after.bound) {
        add(Weight::major,
            "the limit on " + after.metric + " is " + instead(after.bound, before->bound, ""));
      } else if (*before != after) {
        add(Weight::major, "a breach of the limit on " + after.metric + " is judged differently");
      }
    }
    for (const Limit& before : before_.limits) {
      if (!find_limit(after_.limits, before.metric)) {
        add(Weight::major, "the limit on " + before.metric + " is gone");
      }
    }
    // several limits on one metric are told apart by nothing but their order
    if (before_.limits != after_.limits && changes_.size() == so_far) {
      add(Weight::major, "the limits changed");
    }
  }

  void scene() {
    const Scene& before = before_.scene;
    const Scene& after = after_.scene;
    if (before.anatomy != after.anatomy) add(Weight::major, "it is done in " + after.anatomy);
    if (before.instruments != after.instruments)
      add(Weight::major, "it is done with another instrument");
    if (before.start != after.start) {
      add(Weight::major,
          "it starts with " + instead(after.start, before.start, "mm") + " inserted");
    }
    if (before.seed != after.seed) add(Weight::major, "the seed changed");
  }

  void attempt() {
    if (before_.attempt.time_limit != after_.attempt.time_limit) {
      add(Weight::major, "the time limit is " +
                             instead(after_.attempt.time_limit, before_.attempt.time_limit, "s"));
    }
    if (before_.attempt.timeout_fails != after_.attempt.timeout_fails) {
      add(Weight::major, std::string("running out of time ") +
                             (after_.attempt.timeout_fails ? "fails now" : "no longer counts"));
    }
    if (before_.attempt.abort_fails != after_.attempt.abort_fails) {
      add(Weight::major, std::string("an aborted trial ") +
                             (after_.attempt.abort_fails ? "fails now" : "no longer counts"));
    }
  }

  void pass() {
    if (before_.pass.has_value() != after_.pass.has_value()) {
      add(Weight::major, after_.pass ? "it can be passed now" : "it can no longer be passed");
    } else if (after_.pass && !same_rule(*before_.pass, *after_.pass, false)) {
      add(Weight::major, "the pass rule asks for other things");
    } else if (after_.pass) {
      bounds(*before_.pass, *after_.pass);
    }
  }

  void bounds(const Rule& before, const Rule& after) {
    if (before.bound != after.bound) {
      add(Weight::major,
          "the pass mark of " + after.subject + " is " + instead(after.bound, before.bound, ""));
    } else if (before.benchmark != after.benchmark || before.provisional != after.provisional) {
      add(Weight::minor, "the pass mark of " + after.subject + " comes from elsewhere");
    }
    for (std::size_t i = 0; i < after.children.size(); ++i)
      bounds(before.children[i], after.children[i]);
  }

  void proficiency() {
    const auto numbers = [](const std::optional<assessment::ProficiencyRule>& rule) {
      return rule ? std::array{rule->consecutive, rule->additional, rule->min_trials,
                               rule->max_trials}
                  : std::array{0, 0, 0, 0};
    };
    if (before_.proficiency.has_value() != after_.proficiency.has_value() ||
        numbers(before_.proficiency) != numbers(after_.proficiency)) {
      add(Weight::major, "what makes a person proficient changed");
    }
  }

  void record() {
    const auto has = [](const std::vector<std::string>& list, const std::string& id) {
      return std::find(list.begin(), list.end(), id) != list.end();
    };
    for (const std::string& id : after_.record) {
      if (!has(before_.record, id)) add(Weight::minor, id + " is recorded as well");
    }
    for (const std::string& id : before_.record) {
      if (!has(after_.record, id)) add(Weight::minor, id + " is no longer recorded");
    }
  }

  const Exercise& before_;
  const Exercise& after_;
  std::vector<Change>& changes_;
};

const YamlNode* find_exercise_version(const YamlNode& root, const std::string& id) {
  const YamlNode* exercises = root.find("exercises");
  if (!exercises) return nullptr;
  for (const YamlNode& exercise : exercises->items) {
    const YamlNode* name = exercise.find("id");
    if (name && name->text == id) return exercise.find("version");
  }
  return nullptr;
}

Problem problem_at(const YamlNode* node, std::string message) {
  return {Problem::Severity::error, node ? node->line : 1, node ? node->column : 1,
          std::move(message)};
}

SemanticVersion raised(SemanticVersion version, Weight weight) {
  if (weight == Weight::major) return {version.major + 1, 0, 0};
  if (weight == Weight::minor) return {version.major, version.minor + 1, 0};
  return {version.major, version.minor, version.patch + 1};
}

// An exercise that is scored differently must not carry the number of the old one.
void check_exercise_versions(const Curriculum& before, const Curriculum& after,
                             const std::vector<Change>& changes, const YamlNode& root,
                             std::vector<Problem>& problems) {
  for (const Exercise& exercise : after.exercises) {
    const Exercise* old = before.find(exercise.id);
    if (!old) continue;
    const auto change = std::find_if(changes.begin(), changes.end(), [&](const Change& c) {
      return c.exercise_id == exercise.id && c.weight == Weight::major;
    });
    const YamlNode* at = find_exercise_version(root, exercise.id);
    if (change != changes.end() && exercise.version <= old->version) {
      problems.push_back(problem_at(at, "exercise '" + exercise.id + "' is scored differently (" +
                                            change->sentence + "), but is still version " +
                                            std::to_string(exercise.version) + ": write " +
                                            std::to_string(old->version + 1)));
    } else if (exercise.version < old->version) {
      problems.push_back(problem_at(at, "exercise '" + exercise.id + "' was version " +
                                            std::to_string(old->version) +
                                            " already: never go back"));
    }
  }
}

}  // namespace

const char* word(Change::Weight weight) {
  switch (weight) {
    case Weight::patch:
      return "patch";
    case Weight::minor:
      return "minor";
    case Weight::major:
      return "major";
  }
  return "";
}

std::vector<Change> diff(const Curriculum& before, const Curriculum& after) {
  std::vector<Change> changes;
  const auto add = [&](Weight weight, std::string sentence) {
    changes.push_back({weight, "", std::move(sentence)});
  };
  if (before.id != after.id) add(Weight::major, "it is another curriculum: " + after.id);
  if (before.title != after.title) add(Weight::patch, "the title changed");
  if (before.authors != after.authors) add(Weight::patch, "the authors changed");
  if (before.status != after.status) add(Weight::patch, "the status changed");
  if (before.benchmarks != after.benchmarks) add(Weight::patch, "the benchmarks changed");
  for (const Exercise& exercise : after.exercises) {
    if (const Exercise* old = before.find(exercise.id)) {
      std::vector<Change> own;
      ExerciseDiff(*old, exercise, own).run();
      changes.insert(changes.end(), own.begin(), own.end());
    } else {
      changes.push_back({Weight::minor, exercise.id, exercise.id + ": the exercise is new"});
    }
  }
  for (const Exercise& exercise : before.exercises) {
    if (!after.find(exercise.id)) {
      changes.push_back({Weight::major, exercise.id, exercise.id + ": the exercise is gone"});
    }
  }
  if (before.plan != after.plan) add(Weight::minor, "the plan changed");
  return changes;
}

std::vector<Problem> compare_versions(const Curriculum& before, const Curriculum& after) {
  std::vector<Problem> problems;
  if (before.status == Lifecycle::draft || before.sha256 == after.sha256) return problems;
  Problems ignored;
  const YamlTree tree = parse_yaml(after.yaml, ignored);
  if (before.id != after.id) {
    problems.push_back(
        problem_at(tree.root.find("id"), "'" + after.id + "' is not a version of '" + before.id +
                                             "': compare versions of one curriculum"));
    return problems;
  }
  const auto old_version = parse_version(before.version),
             new_version = parse_version(after.version);
  if (!old_version || !new_version) return problems;  // check() has said so

  const YamlNode* at = tree.root.find("version");
  const std::vector<Change> changes = diff(before, after);
  Weight weight = Weight::patch;
  for (const Change& change : changes) weight = std::max(weight, change.weight);
  const SemanticVersion needed = raised(*old_version, weight);
  if (*new_version == *old_version) {
    problems.push_back(problem_at(at, "version " + after.version +
                                          " is published and must not be edited: "
                                          "make this version " +
                                          version_text(needed)));
  } else if (*new_version < needed) {
    const auto reason = std::find_if(changes.begin(), changes.end(),
                                     [&](const Change& change) { return change.weight == weight; });
    problems.push_back(problem_at(
        at, "version " + after.version + " is too small a step from " + before.version + " (" +
                (reason == changes.end() ? "the text changed" : reason->sentence) + "): write " +
                version_text(needed)));
  }
  check_exercise_versions(before, after, changes, tree.root, problems);
  std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
  return problems;
}

}  // namespace curricula
