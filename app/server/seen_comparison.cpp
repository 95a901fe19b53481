#include "app/server/seen_comparison.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "app/server/access.h"
#include "app/server/views/briefing_view.h"
#include "app/session/published_data.h"

namespace app {
namespace {

constexpr std::array<const char*, 3> kDatasets{kPaperDataset, "live", "simulated"};
constexpr const char* kLive = "live";
constexpr int kFewestShown = 5;  // people in a live group, for others than their instructor

// Whom the viewer may count among the people who train here.
base::Result<PersonFilter> filter_for(database::Store& store, const database::Person& viewer) {
  // administrators keep the site, researchers read without names
  if (viewer.role != database::Role::instructor) return PersonFilter{};
  const auto people = database::people_of_instructor(store, viewer.id);
  if (!people) return people.error();
  std::set<std::string> ids{viewer.id};
  for (const database::Person& person : *people) ids.insert(person.id);
  return PersonFilter{[ids](const std::string& person_id) { return ids.contains(person_id); }};
}

void replace_names(std::vector<assessment::TrialValue>& rows) {
  std::map<std::string, std::string> pseudonyms;
  for (assessment::TrialValue& row : rows) {
    const std::string next = "P" + std::to_string(pseudonyms.size() + 1);
    row.participant = pseudonyms.emplace(row.participant, next).first->second;
  }
}

int count_people(const std::vector<assessment::TrialValue>& rows) {
  std::set<std::string> names;
  for (const assessment::TrialValue& row : rows) names.insert(row.participant);
  return static_cast<int>(names.size());
}

bool is_hidden(const assessment::GroupComparison& comparison, const ComparisonData& data,
               const database::Person& viewer) {
  if (data.subject.dataset != kLive || viewer.role == database::Role::instructor) return false;
  return std::min(comparison.first.participants, comparison.second.participants) < kFewestShown;
}

}  // namespace

base::Result<std::vector<ComparisonChoice>> comparison_choices(
    database::Store& store, const curricula::Curriculum& curriculum,
    const database::Person& viewer) {
  std::vector<ComparisonChoice> choices;
  for (const curricula::Exercise& exercise : curriculum.exercises) {
    for (const char* dataset : kDatasets) {
      const auto data = seen_data(store, exercise, dataset, viewer);
      if (!data) return data.error();
      if (data->rows.empty()) continue;
      choices.push_back({exercise.id, data->subject.exercise_title, dataset,
                         data->subject.dataset_title, count_people(data->rows),
                         static_cast<int>(data->rows.size())});
    }
  }
  return choices;
}

base::Result<ComparisonData> seen_data(database::Store& store, const curricula::Exercise& exercise,
                                       const std::string& dataset, const database::Person& viewer) {
  PersonFilter filter;
  if (dataset == kLive) {
    auto for_viewer = filter_for(store, viewer);
    if (!for_viewer) return for_viewer.error();
    filter = *std::move(for_viewer);
  }
  auto data = comparison_data(store, exercise, dataset, filter);
  if (!data) return data.error();
  ComparisonData seen = *std::move(data);
  if (dataset == kLive && viewer.role == database::Role::researcher) replace_names(seen.rows);
  return seen;
}

base::Result<assessment::GroupComparison> seen_comparison(const ComparisonData& data,
                                                          const curricula::Exercise& exercise,
                                                          const database::Person& viewer) {
  assessment::ComparisonQuestion question;
  // a pass mark from another apparatus means nothing here, nor ours there
  const assessment::Rule* target = target_of(exercise, "time_s");
  if (target != nullptr && data.subject.dataset != kPaperDataset)
    question.pass_mark = target->bound;
  auto comparison = assessment::compare_groups(data.rows, question);
  if (!comparison) return comparison.error();
  if (is_hidden(*comparison, data, viewer)) {
    return base::Error{base::ErrorCode::not_enough_data,
                       "Groups of fewer than five people are shown to their instructor only."};
  }
  return comparison;
}

}  // namespace app
