#include "app/server/views/curriculum_view.h"

#include <algorithm>
#include <utility>

#include "app/server/views/briefing_view.h"
#include "app/server/views/words.h"
#include "curricula/sha256.h"

namespace app {
namespace {

using curricula::Problem;
using nlohmann::json;

int count(const std::vector<Problem>& problems, Problem::Severity severity) {
  return static_cast<int>(
      std::count_if(problems.begin(), problems.end(),
                    [&](const Problem& problem) { return problem.severity == severity; }));
}

json problem_json(const Problem& problem) {
  return {{"severity", problem.severity == Problem::Severity::error ? "error" : "warning"},
          {"line", problem.line},
          {"column", problem.column},
          {"message", problem.message},
          {"repair", nullptr}};
}

// As somebody would see it who may begin it.
json outline_json(const curricula::Curriculum& curriculum, const curricula::Library& library) {
  json outline = json::array();
  for (const curricula::Exercise& exercise : curriculum.exercises) {
    curricula::ExerciseState state;
    state.exercise_id = exercise.id;
    state.progress.status = assessment::ExerciseStatus::available;
    state.may_start = true;
    outline.push_back({{"exercise_id", exercise.id},
                       {"version", exercise.version},
                       {"title", english(exercise.title)},
                       {"line", exercise.line},
                       {"briefing", briefing_json(curriculum, exercise, state, library)}});
  }
  return outline;
}

const char* word(curricula::DiffLine::Kind kind) {
  switch (kind) {
    case curricula::DiffLine::Kind::same:
      return "same";
    case curricula::DiffLine::Kind::removed:
      return "removed";
    case curricula::DiffLine::Kind::added:
      return "added";
  }
  return "";
}

}  // namespace

int CheckedText::errors() const { return count(problems, Problem::Severity::error); }
int CheckedText::warnings() const { return count(problems, Problem::Severity::warning); }

CheckedText check_text(const std::string& yaml, const std::string* published,
                       const curricula::Catalogue& catalogue) {
  curricula::CheckResult result = curricula::check(yaml, catalogue);
  CheckedText checked{std::move(result.curriculum), std::move(result.problems)};
  if (published == nullptr || !checked.curriculum) return checked;
  const curricula::CheckResult before = curricula::check(*published, catalogue);
  if (!before.ok() || before.curriculum->id != checked.curriculum->id) return checked;
  const std::vector<Problem> more =
      curricula::compare_versions(*before.curriculum, *checked.curriculum);
  checked.problems.insert(checked.problems.end(), more.begin(), more.end());
  std::stable_sort(checked.problems.begin(), checked.problems.end(),
                   [](const Problem& a, const Problem& b) {
                     return std::pair(a.line, a.column) < std::pair(b.line, b.column);
                   });
  return checked;
}

json check_json(const CheckedText& checked, const std::string& yaml,
                const curricula::Library& library) {
  json problems = json::array();
  for (const Problem& problem : checked.problems) problems.push_back(problem_json(problem));
  return {
      {"ok", checked.errors() == 0},
      {"errors", checked.errors()},
      {"warnings", checked.warnings()},
      {"problems", problems},
      {"sha256", curricula::sha256_hex(yaml)},
      {"outline", checked.curriculum ? outline_json(*checked.curriculum, library) : json::array()}};
}

json changes_json(const std::vector<curricula::Change>& changes) {
  json list = json::array();
  for (const curricula::Change& change : changes) {
    list.push_back({{"weight", curricula::word(change.weight)},
                    {"exercise_id", change.exercise_id},
                    {"sentence", change.sentence}});
  }
  return list;
}

json diff_lines_json(const std::vector<curricula::DiffLine>& lines) {
  constexpr std::size_t kAround = 3;  // unchanged lines shown before and after a change
  using Kind = curricula::DiffLine::Kind;
  std::vector<bool> shown(lines.size(), false);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].kind == Kind::same) continue;
    const std::size_t first = i < kAround ? 0 : i - kAround;
    const std::size_t last = std::min(i + kAround + 1, lines.size());
    for (std::size_t k = first; k < last; ++k) shown[k] = true;
  }
  json list = json::array();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!shown[i]) {
      const bool begins = i == 0 || shown[i - 1];
      if (begins) list.push_back({{"kind", "gap"}, {"before", 0}, {"after", 0}, {"text", ""}});
      continue;
    }
    list.push_back({{"kind", word(lines[i].kind)},
                    {"before", lines[i].before_line},
                    {"after", lines[i].after_line},
                    {"text", lines[i].text}});
  }
  return list;
}

}  // namespace app
