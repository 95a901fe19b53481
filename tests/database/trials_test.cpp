#include "database/trials.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "database/audit.h"
#include "database/curricula.h"
#include "tests/database/temporary_store.h"

namespace database_test {
namespace {

using assessment::EndReason;
using assessment::Event;
using assessment::Outcome;
using assessment::Severity;
using assessment::Source;
using assessment::StepKind;
using assessment::TrialStep;
using base::ErrorCode;
using database::Chunk;
using database::FinishedTrial;
using database::NewTrial;
using database::StoredTrial;

class Trials : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::unique_ptr<database::Store> store_ = open_store(folder_.url());
  std::string anna_ = add_trainee(*store_, "anna").id;

  std::string begin() {
    const NewTrial trial = new_trial_of(anna_);
    const auto ordinal = begin_trial(*store_, trial);
    EXPECT_TRUE(ordinal) << (ordinal ? "" : ordinal.error().message);
    return trial.id;
  }
  std::string finished() {
    const std::string id = begin();
    EXPECT_TRUE(finish_trial(*store_, id, passed_in(10.0), {}, {}));
    return id;
  }
};

TEST_F(Trials, AreReadAsTheyWereBegun) {
  database::CurriculumVersion curriculum;
  curriculum.curriculum_id = "basics";
  curriculum.version = "1";
  curriculum.sha256 = "x";
  curriculum.status = "published";
  curriculum.exercises = {{"", "linear", 1, ""}};
  ASSERT_TRUE(publish_curriculum(*store_, curriculum, "system"));

  NewTrial trial = new_trial_of(anna_);
  trial.enrolment_id = *enrol(*store_, anna_, "basics");
  trial.exercise_version_id = current_exercise(*store_, "basics", "linear")->id;
  trial.source = Source::simulated_operator;
  trial.dataset = "d'ata";
  trial.apparatus = "appa\"ratus";
  trial.device = "simulated:expert";
  trial.seed = std::numeric_limits<std::uint64_t>::max();
  trial.build = "0.1.0+abc";
  trial.isa = "x86-64";
  trial.anatomy_sha256 = std::string(64, 'a');
  trial.instruments_sha256 = std::string(64, 'b');
  trial.started_utc = "2026-02-03T04:05:06.5Z";
  ASSERT_EQ(*begin_trial(*store_, trial), 1);

  const auto read = database::trial(*store_, trial.id);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->head.id, trial.id);
  EXPECT_EQ(read->head.person_id, anna_);
  EXPECT_EQ(read->head.enrolment_id, trial.enrolment_id);
  EXPECT_EQ(read->head.exercise_id, "linear");
  EXPECT_EQ(read->head.exercise_version_id, trial.exercise_version_id);
  EXPECT_EQ(read->head.source, Source::simulated_operator);
  EXPECT_EQ(read->head.dataset, "d'ata");
  EXPECT_EQ(read->head.apparatus, "appa\"ratus");
  EXPECT_EQ(read->head.device, "simulated:expert");
  EXPECT_EQ(read->head.seed, trial.seed);
  EXPECT_EQ(read->head.build, "0.1.0+abc");
  EXPECT_EQ(read->head.isa, "x86-64");
  EXPECT_EQ(read->head.anatomy_sha256, trial.anatomy_sha256);
  EXPECT_EQ(read->head.instruments_sha256, trial.instruments_sha256);
  EXPECT_EQ(read->head.started_utc, "2026-02-03T04:05:06.500Z");
  EXPECT_EQ(read->ordinal, 1);
  EXPECT_TRUE(read->ended_utc.empty());
  EXPECT_FALSE(read->end_reason);
  EXPECT_FALSE(read->outcome);
  EXPECT_TRUE(read->metrics.empty());
  EXPECT_EQ(read->person_name, "anna");
}

TEST_F(Trials, AreReadAsTheyWereFinished) {
  const std::string id = begin();
  FinishedTrial finished;
  finished.end_reason = EndReason::limit;
  finished.paused_s = 1.5;
  finished.slowed_s = 0.25;
  finished.end_time_s = 83.21;
  finished.interrupted = true;
  finished.input_sha256 = "aa";
  finished.state_hash = "bb";
  finished.steps = {{"feed", StepKind::translate, 350.0, 2.0, 0.0, 40.5, -1.25},
                    {"turn.1", StepKind::rotate, -3.14, 0.05, 40.5, -1.0, 0.0}};
  // values that a text would round
  finished.metrics = {{"time_s", 2, 83.21}, {"force_p95_n", 1, 0.1 + 0.2}, {"a_first", 1, 5e-324}};
  finished.verdict.outcome = Outcome::not_passed;
  finished.verdict.sentence = "Too slow, and \"too\" hard.";
  finished.verdict.criteria = {
      {"time_s", assessment::Comparison::less_equal, 60.0, 83.21, false, "linear_time", true},
      {"goal.reached", assessment::Comparison::equal, 1.0, std::nullopt, false, "", false}};
  finished.rule_version = "linear@1";
  ASSERT_TRUE(finish_trial(*store_, id, finished, {}, {}));

  const auto read = database::trial(*store_, id);
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->ended_utc.empty());
  EXPECT_EQ(read->end_reason, EndReason::limit);
  EXPECT_EQ(read->paused_s, 1.5);
  EXPECT_EQ(read->slowed_s, 0.25);
  EXPECT_EQ(read->end_time_s, 83.21);
  EXPECT_TRUE(read->interrupted);
  EXPECT_EQ(read->input_sha256, "aa");
  EXPECT_EQ(read->state_hash, "bb");
  EXPECT_EQ(read->outcome, Outcome::not_passed);
  ASSERT_EQ(read->metrics.size(), 3u);
  EXPECT_EQ(read->metrics[0].id, "time_s");
  EXPECT_EQ(read->metrics[0].version, 2);
  EXPECT_EQ(read->metrics[0].value, 83.21);
  EXPECT_EQ(read->metrics[1].value, 0.1 + 0.2);
  EXPECT_EQ(read->metrics[2].id, "a_first");
  EXPECT_EQ(read->metrics[2].value, 5e-324);

  const auto steps = trial_steps(*store_, id);
  ASSERT_TRUE(steps);
  ASSERT_EQ(steps->size(), 2u);
  EXPECT_EQ((*steps)[0].id, "feed");
  EXPECT_EQ((*steps)[0].kind, StepKind::translate);
  EXPECT_EQ((*steps)[0].target, 350.0);
  EXPECT_EQ((*steps)[0].tolerance, 2.0);
  EXPECT_EQ((*steps)[0].started, 0.0);
  EXPECT_EQ((*steps)[0].ended, 40.5);
  EXPECT_EQ((*steps)[0].residual, -1.25);
  EXPECT_EQ((*steps)[1].kind, StepKind::rotate);
  EXPECT_FALSE((*steps)[1].done());

  const auto verdict = trial_verdict(*store_, id);
  ASSERT_TRUE(verdict);
  EXPECT_EQ(verdict->outcome, Outcome::not_passed);
  EXPECT_EQ(verdict->sentence, "Too slow, and \"too\" hard.");
  ASSERT_EQ(verdict->criteria.size(), 2u);
  EXPECT_EQ(verdict->criteria[0].subject, "time_s");
  EXPECT_EQ(verdict->criteria[0].comparison, assessment::Comparison::less_equal);
  EXPECT_EQ(verdict->criteria[0].bound, 60.0);
  EXPECT_EQ(verdict->criteria[0].value, 83.21);
  EXPECT_FALSE(verdict->criteria[0].met);
  EXPECT_EQ(verdict->criteria[0].benchmark, "linear_time");
  EXPECT_TRUE(verdict->criteria[0].provisional);
  EXPECT_FALSE(verdict->criteria[1].value);
}

TEST_F(Trials, KeepTheirTraceAndEventsInOrder) {
  const std::string id = begin();
  std::vector<std::byte> all_bytes;
  for (int i = 0; i < 256; ++i) all_bytes.push_back(static_cast<std::byte>(i));
  const std::vector<Chunk> first = {{0, "inputs", "inputs@1", all_bytes},
                                    {0, "observed", "observed@1", bytes_of("zero")}};
  const std::vector<Event> early = {{0.0, "step_started", Severity::info, "feed", 0.0},
                                    {0.5, "limit_breached", Severity::critical, "force", 2.5}};
  ASSERT_TRUE(append_trace(*store_, id, first, early));
  const std::vector<Chunk> second = {{1, "inputs", "inputs@1", {}}};
  const std::vector<Event> later = {
      {0.5, "diverged", Severity::fail, "", std::numeric_limits<double>::quiet_NaN()}};
  ASSERT_TRUE(append_trace(*store_, id, second, later));
  const std::vector<Chunk> last = {{2, "inputs", "inputs@1", bytes_of("two")},
                                   {0, "hashes", "hashes@1", bytes_of("h")}};
  const std::vector<Event> end = {{2.5, "ended", Severity::mark, "", -0.0}};
  ASSERT_TRUE(finish_trial(*store_, id, passed_in(2.5), last, end));

  const auto inputs = trial_chunks(*store_, id, "inputs");
  ASSERT_TRUE(inputs);
  ASSERT_EQ(inputs->size(), 3u);
  EXPECT_EQ((*inputs)[0].bytes, all_bytes);
  EXPECT_EQ((*inputs)[0].codec, "inputs@1");
  EXPECT_EQ((*inputs)[0].kind, "inputs");
  EXPECT_TRUE((*inputs)[1].bytes.empty());
  EXPECT_EQ((*inputs)[2].seq, 2);
  EXPECT_EQ((*inputs)[2].bytes, bytes_of("two"));
  EXPECT_EQ(trial_chunks(*store_, id, "observed")->size(), 1u);
  EXPECT_EQ(trial_chunks(*store_, id, "hashes")->size(), 1u);

  const auto events = trial_events(*store_, id);
  ASSERT_TRUE(events);
  ASSERT_EQ(events->size(), 4u);
  EXPECT_EQ((*events)[0].code, "step_started");
  EXPECT_EQ((*events)[1].time, 0.5);
  EXPECT_EQ((*events)[1].severity, Severity::critical);
  EXPECT_EQ((*events)[1].detail, "force");
  EXPECT_EQ((*events)[1].value, 2.5);
  EXPECT_EQ((*events)[2].code, "diverged");
  EXPECT_TRUE(std::isnan((*events)[2].value));
  EXPECT_EQ((*events)[3].code, "ended");
}

TEST_F(Trials, AreCountedPerPersonAndExercise) {
  const std::string bob = add_trainee(*store_, "bob").id;
  EXPECT_EQ(*begin_trial(*store_, new_trial_of(anna_)), 1);
  EXPECT_EQ(*begin_trial(*store_, new_trial_of(anna_)), 2);
  EXPECT_EQ(*begin_trial(*store_, new_trial_of(bob)), 1);
  NewTrial rotational = new_trial_of(anna_);
  rotational.exercise_id = "rotational";
  EXPECT_EQ(*begin_trial(*store_, rotational), 1);
}

TEST_F(Trials, OfUnknownPeopleAndExercisesAreNotBegun) {
  EXPECT_EQ(begin_trial(*store_, new_trial_of("nobody")).error().code, ErrorCode::not_found);
  NewTrial trial = new_trial_of(anna_);
  trial.exercise_version_id = "none";
  EXPECT_EQ(begin_trial(*store_, trial).error().code, ErrorCode::not_found);
  trial = new_trial_of(anna_);
  trial.enrolment_id = "none";
  EXPECT_EQ(begin_trial(*store_, trial).error().code, ErrorCode::not_found);
  trial = new_trial_of(anna_);
  trial.started_utc = "noon";
  EXPECT_EQ(begin_trial(*store_, trial).error().code, ErrorCode::invalid_input);
  trial = new_trial_of(anna_);
  trial.device = std::string(1 << 20, 'x');
  EXPECT_EQ(begin_trial(*store_, trial).error().code, ErrorCode::invalid_input);
  trial.device = "keyboard";
  ASSERT_TRUE(begin_trial(*store_, trial));
  EXPECT_EQ(begin_trial(*store_, trial).error().code, ErrorCode::conflict);
}

TEST_F(Trials, WithAnEnrolmentOfSomebodyElseAreNotBegun) {
  database::CurriculumVersion curriculum;
  curriculum.curriculum_id = "basics";
  curriculum.version = "1";
  curriculum.sha256 = "x";
  curriculum.status = "published";
  ASSERT_TRUE(publish_curriculum(*store_, curriculum, "system"));
  NewTrial trial = new_trial_of(anna_);
  trial.enrolment_id = *enrol(*store_, add_trainee(*store_, "bob").id, "basics");
  EXPECT_EQ(begin_trial(*store_, trial).error().code, ErrorCode::not_found);
}

TEST_F(Trials, ThatAreUnknownAreNotFound) {
  EXPECT_EQ(database::trial(*store_, "none").error().code, ErrorCode::not_found);
  EXPECT_EQ(trial_chunks(*store_, "none", "inputs").error().code, ErrorCode::not_found);
  EXPECT_EQ(trial_events(*store_, "none").error().code, ErrorCode::not_found);
  EXPECT_EQ(trial_steps(*store_, "none").error().code, ErrorCode::not_found);
  EXPECT_EQ(trial_verdict(*store_, "none").error().code, ErrorCode::not_found);
  EXPECT_EQ(append_trace(*store_, "none", {}, {}).error().code, ErrorCode::not_found);
  EXPECT_EQ(finish_trial(*store_, "none", passed_in(1.0), {}, {}).error().code,
            ErrorCode::not_found);
  EXPECT_EQ(void_trial(*store_, "none", "why", "system").error().code, ErrorCode::not_found);
  EXPECT_EQ(trial_verdict(*store_, begin()).error().code, ErrorCode::not_found);
}

TEST_F(Trials, ThatHaveEndedTakeNothingMore) {
  const std::string id = finished();
  const std::vector<Chunk> late = {{0, "inputs", "c", bytes_of("late")}};
  EXPECT_EQ(append_trace(*store_, id, late, {}).error().code, ErrorCode::conflict);
  EXPECT_EQ(finish_trial(*store_, id, passed_in(1.0), {}, {}).error().code, ErrorCode::conflict);
  EXPECT_TRUE(trial_chunks(*store_, id, "inputs")->empty());
  EXPECT_EQ(database::trial(*store_, id)->end_time_s, 10.0);
}

TEST_F(Trials, TakeEachSecondWholeOrNotAtAll) {
  const std::string id = begin();
  const std::vector<Chunk> first = {{0, "inputs", "c", bytes_of("a")}};
  ASSERT_TRUE(append_trace(*store_, id, first, {}));
  const std::vector<Event> events = {{1.0, "step_done", Severity::info, "", 0.0}};

  const std::vector<Chunk> twice = {{1, "inputs", "c", bytes_of("b")},
                                    {0, "inputs", "c", bytes_of("again")}};
  EXPECT_EQ(append_trace(*store_, id, twice, events).error().code, ErrorCode::conflict);
  const std::vector<Chunk> unknown = {{1, "inputs", "c", bytes_of("b")},
                                      {1, "video", "c", bytes_of("b")}};
  EXPECT_EQ(append_trace(*store_, id, unknown, events).error().code, ErrorCode::invalid_input);
  FinishedTrial no_number = passed_in(1.0);
  no_number.metrics.push_back({"force_max_n", 1, std::nan("")});
  const std::vector<Chunk> next = {{1, "inputs", "c", bytes_of("b")}};
  EXPECT_EQ(finish_trial(*store_, id, no_number, next, events).error().code,
            ErrorCode::invalid_input);
  FinishedTrial repeated = passed_in(1.0);
  repeated.metrics.push_back(repeated.metrics.front());
  EXPECT_EQ(finish_trial(*store_, id, repeated, next, events).error().code, ErrorCode::conflict);

  EXPECT_EQ(trial_chunks(*store_, id, "inputs")->size(), 1u);
  EXPECT_TRUE(trial_events(*store_, id)->empty());
  EXPECT_TRUE(database::trial(*store_, id)->metrics.empty());
  EXPECT_FALSE(database::trial(*store_, id)->end_reason);
}

TEST_F(Trials, ThatWerePublishedHaveResultsAndNoTrace) {
  NewTrial trial = new_trial_of(anna_);
  trial.source = Source::published_data;
  trial.dataset = "paper";
  trial.started_utc = "2019-01-01T00:00:00Z";
  const std::vector<assessment::MetricValue> metrics = {{"time_s", 1, 237.33}};
  ASSERT_TRUE(import_trial(*store_, trial, metrics));
  const auto read = database::trial(*store_, trial.id);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->end_reason, EndReason::completed);
  EXPECT_EQ(read->end_time_s, 237.33);
  EXPECT_EQ(read->ended_utc, "2019-01-01T00:00:00.000Z");
  EXPECT_FALSE(read->outcome);
  ASSERT_EQ(read->metrics.size(), 1u);
  EXPECT_TRUE(trial_chunks(*store_, trial.id, "inputs")->empty());
}

TEST_F(Trials, LeftRunningAreClosedAtTheNextStart) {
  const std::string done = finished();
  const std::string with_trace = begin();
  const std::string without_trace = begin();
  const std::vector<Chunk> second = {{0, "inputs", "c", bytes_of("a")}};
  ASSERT_TRUE(append_trace(*store_, with_trace, second, {}));
  EXPECT_EQ(unfinished_trials(*store_)->size(), 2u);

  EXPECT_EQ(*abort_unfinished_trials(*store_), 2);
  EXPECT_EQ(*abort_unfinished_trials(*store_), 0);
  EXPECT_TRUE(unfinished_trials(*store_)->empty());
  for (const std::string& id : {with_trace, without_trace}) {
    const auto read = database::trial(*store_, id);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->end_reason, EndReason::aborted);
    EXPECT_EQ(read->outcome, Outcome::invalid);
    EXPECT_TRUE(read->interrupted);
    const auto verdict = trial_verdict(*store_, id);
    ASSERT_TRUE(verdict);
    EXPECT_EQ(verdict->outcome, Outcome::invalid);
    EXPECT_NE(verdict->sentence.find("stopped"), std::string::npos);
  }
  EXPECT_EQ(database::trial(*store_, without_trace)->ended_utc,
            database::trial(*store_, without_trace)->head.started_utc);
  EXPECT_GE(database::trial(*store_, with_trace)->ended_utc,
            database::trial(*store_, with_trace)->head.started_utc);
  EXPECT_EQ(trial_chunks(*store_, with_trace, "inputs")->size(), 1u);
  EXPECT_EQ(database::trial(*store_, done)->end_reason, EndReason::completed);
}

TEST_F(Trials, AreVoidedOnceWithAReasonAndKeepHowTheyEnded) {
  const std::string id = finished();
  EXPECT_EQ(void_trial(*store_, id, "", "system").error().code, ErrorCode::invalid_input);
  EXPECT_EQ(void_trial(*store_, begin(), "why", "system").error().code, ErrorCode::conflict);
  ASSERT_TRUE(void_trial(*store_, id, "The cat's paw", anna_));
  const auto read = database::trial(*store_, id);
  EXPECT_EQ(read->void_reason, "The cat's paw");
  EXPECT_EQ(read->voided_by, anna_);
  EXPECT_FALSE(read->voided_utc.empty());
  EXPECT_EQ(read->end_reason, EndReason::completed);
  EXPECT_EQ(read->outcome, Outcome::passed);
  EXPECT_EQ(void_trial(*store_, id, "again", "system").error().code, ErrorCode::conflict);
  EXPECT_EQ(database::trial(*store_, id)->void_reason, "The cat's paw");
  const auto log = audit_log(*store_, 1);
  EXPECT_EQ(log->front().action, "trial.void");
  EXPECT_EQ(log->front().object, "trial:" + id);
  EXPECT_EQ(log->front().actor, anna_);
}

}  // namespace
}  // namespace database_test
