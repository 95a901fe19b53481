#include <algorithm>
#include <chrono>

#include <gtest/gtest.h>

#include "tests/database/temporary_store.h"

namespace database_test {
namespace {

using database::StoredTrial;
using database::TrialFilter;

class TrialLists : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::unique_ptr<database::Store> store_ = open_store(folder_.url());
  std::string anna_ = add_trainee(*store_, "anna").id;
  std::string bob_ = add_trainee(*store_, "bob").id;

  std::string add(const std::string& person, const std::string& exercise, double time,
                  const std::string& started_utc = "") {
    database::NewTrial trial = new_trial_of(person);
    trial.exercise_id = exercise;
    trial.started_utc = started_utc;
    EXPECT_TRUE(begin_trial(*store_, trial));
    database::FinishedTrial finished = passed_in(time);
    finished.metrics.push_back({"force_max_n", 1, 0.5});
    EXPECT_TRUE(finish_trial(*store_, trial.id, finished, {}, {}));
    return trial.id;
  }
};

TEST_F(TrialLists, ComeByPersonExerciseAndOrdinalEachWithItsOwnMetrics) {
  add(bob_, "linear", 1.0);
  add(anna_, "rotational", 2.0);
  add(anna_, "linear", 3.0);
  add(anna_, "linear", 4.0);
  const auto all = trials(*store_, {});
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), 4u);
  const auto key = [](const StoredTrial& trial) {
    return std::tuple(trial.head.person_id, trial.head.exercise_id, trial.ordinal);
  };
  EXPECT_TRUE(std::is_sorted(all->begin(), all->end(), [&](const auto& left, const auto& right) {
    return key(left) < key(right);
  }));
  for (const StoredTrial& trial : *all) {
    ASSERT_EQ(trial.metrics.size(), 2u);
    EXPECT_EQ(trial.metrics[0].id, "time_s");
    EXPECT_EQ(trial.metrics[0].value, trial.end_time_s);
    EXPECT_EQ(trial.outcome, assessment::Outcome::passed);
    EXPECT_EQ(trial.person_name, trial.head.person_id == anna_ ? "anna" : "bob");
  }
}

TEST_F(TrialLists, AreFiltered) {
  add(anna_, "linear", 1.0);
  add(anna_, "rotational", 2.0);
  add(bob_, "linear", 3.0);
  database::NewTrial published = new_trial_of(bob_);
  published.source = assessment::Source::published_data;
  published.dataset = "paper";
  const std::vector<assessment::MetricValue> time = {{"time_s", 1, 9.0}};
  ASSERT_TRUE(import_trial(*store_, published, time));
  const database::NewTrial running = new_trial_of(anna_);
  ASSERT_TRUE(begin_trial(*store_, running));

  const auto count = [&](TrialFilter filter) { return trials(*store_, filter)->size(); };
  TrialFilter filter;
  EXPECT_EQ(count(filter), 4u);
  filter.finished_only = false;
  EXPECT_EQ(count(filter), 5u);
  filter.person_id = anna_;
  EXPECT_EQ(count(filter), 3u);
  filter.exercise_id = "linear";
  EXPECT_EQ(count(filter), 2u);
  filter = {};
  filter.dataset = "paper";
  EXPECT_EQ(count(filter), 1u);
  filter = {};
  filter.source = assessment::Source::live;
  EXPECT_EQ(count(filter), 3u);
  filter = {};
  filter.person_id = "' OR '1'='1";
  EXPECT_EQ(count(filter), 0u);

  filter = {};
  filter.only_metric = "force_max_n";
  const auto forces = trials(*store_, filter);
  for (const StoredTrial& trial : *forces) {
    EXPECT_EQ(trial.metrics.size(), trial.head.dataset.empty() ? 1u : 0u);
  }
  filter = {};
  filter.with_metrics = false;
  const auto bare = trials(*store_, filter);
  for (const StoredTrial& trial : *bare) EXPECT_TRUE(trial.metrics.empty());
}

TEST_F(TrialLists, ShowTheLevelOfTheTimeOfTheTrial) {
  using database::Level;
  ASSERT_TRUE(
      declare_experience(*store_, anna_, Level::novice, 0, "system", "2025-01-01T00:00:00Z"));
  ASSERT_TRUE(
      declare_experience(*store_, anna_, Level::expert, 200, "system", "2026-01-01T00:00:00Z"));
  add(anna_, "linear", 1.0, "2024-05-05T00:00:00Z");
  add(anna_, "linear", 1.0, "2025-05-05T00:00:00Z");
  add(anna_, "linear", 1.0, "2026-05-05T00:00:00Z");
  const auto all = trials(*store_, {});
  ASSERT_EQ(all->size(), 3u);
  EXPECT_EQ((*all)[0].level, std::nullopt);
  EXPECT_EQ((*all)[1].level, Level::novice);
  EXPECT_EQ((*all)[2].level, Level::expert);
}

TEST_F(TrialLists, CountWhatEachPersonHasDone) {
  add(anna_, "linear", 1.0, "2026-05-05T00:00:00Z");
  ASSERT_TRUE(void_trial(*store_, add(anna_, "linear", 2.0, "2026-05-06T00:00:00Z"), "cat", "x"));
  const database::NewTrial running = new_trial_of(bob_);
  ASSERT_TRUE(begin_trial(*store_, running));
  const auto counts = trial_counts(*store_);
  ASSERT_TRUE(counts);
  ASSERT_EQ(counts->size(), 2u);
  for (const database::TrialCount& count : *counts) {
    EXPECT_EQ(count.exercise_id, "linear");
    if (count.person_id == anna_) {
      EXPECT_EQ(count.started, 2);
      EXPECT_EQ(count.passed, 1);
      EXPECT_EQ(count.last_started_utc, "2026-05-06T00:00:00.000Z");
    } else {
      EXPECT_EQ(count.person_id, bob_);
      EXPECT_EQ(count.started, 1);
      EXPECT_EQ(count.passed, 0);
    }
  }
}

// 500 people with 400 trials each, made by SQLite itself: that takes a second, not minutes.
void fill_large(const std::string& path) {
  RawFile file(path);
  file.run(
      "BEGIN;"
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 500) "
      "INSERT INTO person SELECT printf('person-%03d', i), 'live', '2025-01-01T00:00:00.000Z' "
      "FROM n;"
      "INSERT INTO identity SELECT id, 'name of ' || id, id, NULL, '', 'trainee', 0, '' "
      "FROM person WHERE id LIKE 'person-%';"
      "INSERT INTO person_group VALUES ('group-1', 'course', '2025-01-01T00:00:00.000Z');"
      "INSERT INTO membership SELECT 'm' || id, id, 'group-1', created_utc, NULL FROM person "
      "WHERE id LIKE 'person-%';"
      "INSERT INTO experience SELECT id, 1, 'novice', 0, created_utc, 'system' FROM person "
      "WHERE id LIKE 'person-%';"
      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < 400) "
      "INSERT INTO trial SELECT printf('%s-%04d', p.id, i), p.id, NULL, "
      "CASE i % 2 WHEN 0 THEN 'linear' ELSE 'rotational' END, NULL, i, 'live', '', 'cathedra', "
      "'keyboard', '1', 'b', 'x', '', '', '', '', '2026-01-01T00:00:00.000Z', "
      "'2026-01-01T00:01:00.000Z', 'completed', 60.0, 0.0, 0.0, 0, 'passed', NULL, NULL, NULL "
      "FROM person p JOIN n WHERE p.id LIKE 'person-%';"
      "INSERT INTO metric_value SELECT id, 0, 'time_s', 1, 60.0 FROM trial;"
      "INSERT INTO metric_value SELECT id, 1, 'force_max_n', 1, 0.5 FROM trial;"
      "COMMIT; ANALYZE;");
}

template <typename Work>
double shortest_of_five_ms(Work work) {
  double shortest = 1e9;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    shortest = std::min(shortest, took.count());
  }
  return shortest;
}

// A page is answered within 200 ms (overview, "Numbers that matter"). The shortest of five says
// what the store needs, whatever else the machine does.
TEST_F(TrialLists, OfALargeSiteAreThereWithin200Milliseconds) {
  fill_large(folder_.file("store.db"));
  const double list_ms = shortest_of_five_ms([&] {
    EXPECT_EQ(people(*store_)->size(), 502u);
    EXPECT_EQ(trial_counts(*store_)->size(), 1000u);
  });
  TrialFilter filter;
  filter.person_id = "person-250";
  const double person_ms =
      shortest_of_five_ms([&] { EXPECT_EQ(trials(*store_, filter)->size(), 400u); });
  RecordProperty("people_and_counts_ms", std::to_string(list_ms));
  RecordProperty("trials_of_person_ms", std::to_string(person_ms));
  EXPECT_LT(list_ms, 200.0);
  EXPECT_LT(person_ms, 200.0);
}

}  // namespace
}  // namespace database_test
