#include "assessment/rule.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace assessment {
namespace {

using Kind = Rule::Kind;

Rule leaf(Kind kind, const std::string& subject, Comparison comparison, double bound) {
  Rule rule;
  rule.kind = kind;
  rule.subject = subject;
  rule.comparison = comparison;
  rule.bound = bound;
  return rule;
}
Rule metric(const std::string& id, Comparison comparison, double bound) {
  return leaf(Kind::metric, id, comparison, bound);
}
Rule errors(const std::string& severity, Comparison comparison, double bound) {
  return leaf(Kind::errors, severity, comparison, bound);
}
Rule node(Kind kind, std::vector<Rule> children) {
  Rule rule;
  rule.kind = kind;
  rule.children = std::move(children);
  return rule;
}

// The rule of the linear task.
Rule linear_rule() {
  return node(Kind::all, {metric("time_s", Comparison::less_equal, 90.0),
                          errors("critical", Comparison::equal, 0.0)});
}

RecordedTrial completed() {
  RecordedTrial trial;
  trial.end_reason = EndReason::completed;
  trial.end_time = 80.0;
  trial.steps = {{.id = "feed-1", .ended = 20.0},
                 {.id = "retract", .ended = 50.0},
                 {.id = "feed-2", .ended = 80.0}};
  return trial;
}

const std::vector<LimitBound> kLimits{{"force_max_n", Comparison::less_equal, 2.0}};

Event force_breach(double value, Severity severity = Severity::critical) {
  return {12.0, "limit_breached", severity, "force_max_n", value};
}

TEST(Judge, PassesATrialThatMeetsItsRule) {
  const Verdict verdict =
      judge(linear_rule(), completed(), std::vector<MetricValue>{{"time_s", 1, 71.2}}, kLimits);
  EXPECT_EQ(verdict.outcome, Outcome::passed);
  EXPECT_EQ(verdict.sentence, "Passed: 71.2 s, target 90 s, no critical error.");
  ASSERT_EQ(verdict.criteria.size(), 2u);
  EXPECT_EQ(verdict.criteria[0].subject, "time_s");
  EXPECT_EQ(*verdict.criteria[0].value, 71.2);
  EXPECT_EQ(verdict.criteria[1].subject, "errors.critical");
  EXPECT_TRUE(verdict.criteria[0].met && verdict.criteria[1].met);
}

TEST(Judge, NamesValueTargetAndByHowMuch) {
  const Verdict verdict =
      judge(linear_rule(), completed(), std::vector<MetricValue>{{"time_s", 1, 112.4}});
  EXPECT_EQ(verdict.outcome, Outcome::not_passed);
  EXPECT_EQ(verdict.sentence, "Not passed: 112.4 s is 22.4 s over the target of 90 s.");
  EXPECT_FALSE(verdict.criteria[0].met);
  EXPECT_TRUE(verdict.criteria[1].met);
}

TEST(Judge, NeverRoundsAFailureIntoAPass) {
  const Verdict verdict =
      judge(linear_rule(), completed(), std::vector<MetricValue>{{"time_s", 1, 90.0004}});
  EXPECT_EQ(verdict.outcome, Outcome::not_passed);
  EXPECT_EQ(verdict.sentence, "Not passed: 90.0004 s is 0.0004 s over the target of 90 s.");
}

TEST(Judge, NamesTheLimitBehindACriticalError) {
  RecordedTrial trial = completed();
  trial.events.push_back(force_breach(2.31));
  const std::vector<MetricValue> values{{"time_s", 1, 71.2}};
  EXPECT_EQ(judge(linear_rule(), trial, values, kLimits).sentence,
            "Not passed: peak contact force reached 2.31 N, above the limit of 2 N: a critical "
            "error.");
  EXPECT_EQ(judge(linear_rule(), trial, values).sentence,
            "Not passed: peak contact force reached 2.31 N, beyond the limit of the exercise: a "
            "critical error.");
  trial.events.back().value = 2.0001;
  EXPECT_NE(judge(linear_rule(), trial, values, kLimits).sentence.find("reached 2.0001 N, above"),
            std::string::npos);
}

TEST(Judge, SaysEachReasonOnceWithTheCriticalErrorFirst) {
  RecordedTrial trial = completed();
  trial.events = {force_breach(2.31), force_breach(2.5)};
  const Verdict verdict =
      judge(linear_rule(), trial, std::vector<MetricValue>{{"time_s", 1, 112.4}}, kLimits);
  EXPECT_EQ(verdict.sentence,
            "Not passed: peak contact force reached 2.31 N, above the limit of 2 N: a critical "
            "error, and 1 more; 112.4 s is 22.4 s over the target of 90 s.");
}

TEST(Judge, ACriticalErrorVetoesEvenARuleThatForgetsIt) {
  RecordedTrial trial = completed();
  trial.events.push_back(force_breach(2.31));
  const Rule rule = metric("time_s", Comparison::less_equal, 90.0);
  const std::vector<MetricValue> values{{"time_s", 1, 50.0}};
  EXPECT_EQ(judge(rule, trial, values, kLimits).outcome, Outcome::not_passed);
  trial.events = {force_breach(2.31, Severity::fail)};
  EXPECT_EQ(judge(rule, trial, values, kLimits).sentence,
            "Not passed: peak contact force reached 2.31 N, above the limit of 2 N, which fails "
            "the trial.");
  trial.events = {force_breach(2.31, Severity::mark)};
  EXPECT_EQ(judge(rule, trial, values, kLimits).outcome, Outcome::passed);
}

TEST(Judge, ATrialThatDidNotCompleteNeverPasses) {
  const std::vector<MetricValue> values{{"time_s", 1, 50.0}};
  RecordedTrial trial = completed();
  trial.steps[1].ended = trial.steps[2].ended = -1.0;
  trial.end_time = 900.0;

  trial.end_reason = EndReason::timeout;
  trial.events = {{900.0, "timeout", Severity::fail, "", 900.0}};
  EXPECT_EQ(judge(linear_rule(), trial, values).outcome, Outcome::not_passed);
  EXPECT_EQ(judge(linear_rule(), trial, values).sentence,
            "Not passed: the time limit of the exercise was reached at 900 s, in step 2 of 3 "
            "(retract).");

  trial.end_reason = EndReason::limit;
  trial.events = {force_breach(2.31, Severity::fail)};
  trial.end_time = 12.0;
  EXPECT_EQ(judge(linear_rule(), trial, values, kLimits).outcome, Outcome::not_passed);
  EXPECT_EQ(judge(linear_rule(), trial, values, kLimits).sentence,
            "Not passed: peak contact force reached 2.31 N, above the limit of 2 N, which ended "
            "the trial at 12 s, in step 2 of 3 (retract).");

  trial.end_reason = EndReason::aborted;
  trial.end_time = 45.2;
  EXPECT_EQ(judge(linear_rule(), trial, values).outcome, Outcome::invalid);
  EXPECT_EQ(judge(linear_rule(), trial, values).sentence,
            "Not counted: the trial was ended early, at 45.2 s, in step 2 of 3 (retract).");

  trial.end_reason = EndReason::diverged;
  EXPECT_EQ(judge(linear_rule(), trial, values).outcome, Outcome::invalid);
  EXPECT_NE(judge(linear_rule(), trial, values).sentence.find("not your fault"), std::string::npos);
}

TEST(Judge, AMetricTheTrialDoesNotHaveIsNotMetNeitherIsItsNegation) {
  const Rule economy = metric("path_economy", Comparison::greater_equal, 0.9);
  const Verdict plain = judge(economy, completed(), {});
  EXPECT_EQ(plain.outcome, Outcome::not_passed);
  EXPECT_FALSE(plain.criteria[0].value);
  EXPECT_EQ(plain.sentence, "Not passed: this trial has no value for path economy.");
  EXPECT_EQ(judge(node(Kind::negate, {economy}), completed(), {}).outcome, Outcome::not_passed);
}

TEST(Judge, AnyNeedsOneAndBlamesAll) {
  const Rule rule = node(Kind::any, {metric("time_s", Comparison::less_equal, 90.0),
                                     metric("path_economy", Comparison::greater_equal, 0.9)});
  const Verdict passed = judge(
      rule, completed(), std::vector<MetricValue>{{"time_s", 1, 120.0}, {"path_economy", 1, 0.95}});
  EXPECT_EQ(passed.outcome, Outcome::passed);
  EXPECT_EQ(passed.sentence, "Passed: path economy 0.95, target 0.9.");
  EXPECT_EQ(passed.criteria.size(), 2u);
  const Verdict failed = judge(
      rule, completed(), std::vector<MetricValue>{{"time_s", 1, 120.0}, {"path_economy", 1, 0.85}});
  EXPECT_EQ(failed.sentence,
            "Not passed: 120 s is 30 s over the target of 90 s; path economy of 0.85 is 0.05 under "
            "the target of 0.9.");
  EXPECT_EQ(judge(node(Kind::any, {}), completed(), {}).outcome, Outcome::not_passed);
  EXPECT_EQ(judge(node(Kind::all, {}), completed(), {}).outcome, Outcome::passed);
}

TEST(Judge, NegationTurnsTheComparisonRound) {
  const Rule rule =
      node(Kind::negate, {node(Kind::any, {metric("wall_hits", Comparison::greater, 5.0),
                                           metric("time_s", Comparison::greater, 90.0)})});
  const auto judged = [&](double hits, double time) {
    return judge(rule, completed(),
                 std::vector<MetricValue>{{"wall_hits", 1, hits}, {"time_s", 1, time}});
  };
  EXPECT_EQ(judged(5, 90).outcome, Outcome::passed);
  EXPECT_EQ(judged(7, 90).outcome, Outcome::not_passed);
  EXPECT_EQ(judged(5, 91).outcome, Outcome::not_passed);
  EXPECT_EQ(judged(7, 90).criteria[0].comparison, Comparison::less_equal);
  EXPECT_EQ(judged(7, 90).sentence, "Not passed: 7 wall hits are 2 over the target of 5.");
  EXPECT_EQ(judge(node(Kind::negate, {rule}), completed(),
                  std::vector<MetricValue>{{"wall_hits", 1, 9}, {"time_s", 1, 10}})
                .outcome,
            Outcome::passed);
}

TEST(Judge, CountsErrorsOfOneSeverityOnly) {
  RecordedTrial trial = completed();
  trial.events = {force_breach(2.2, Severity::mark),
                  force_breach(2.3, Severity::mark),
                  {1.0, "step_done", Severity::info, "feed-1", 0.0}};
  EXPECT_EQ(judge(errors("mark", Comparison::less_equal, 2.0), trial, {}).sentence,
            "Passed: 2 marked errors.");
  EXPECT_EQ(judge(errors("mark", Comparison::less_equal, 1.0), trial, {}).sentence,
            "Not passed: 2 marked errors where <= 1 is asked for.");
  EXPECT_EQ(judge(errors("critical", Comparison::equal, 0.0), trial, {}).outcome, Outcome::passed);
  EXPECT_EQ(judge(errors("nonsense", Comparison::equal, 0.0), trial, {}).outcome,
            Outcome::not_passed);
}

TEST(Judge, TheGoalIsReachedWhenEveryStepIsDone) {
  const Rule rule = leaf(Kind::goal, "reached", Comparison::equal, 1.0);
  EXPECT_EQ(judge(rule, completed(), {}).sentence, "Passed: goal reached.");
  RecordedTrial trial = completed();
  trial.steps[2].ended = -1.0;
  EXPECT_EQ(judge(rule, trial, {}).sentence, "Not passed: the goal was not reached.");
}

TEST(Judge, SaysThatATargetIsProvisional) {
  Rule rule = metric("time_s", Comparison::less_equal, 90.0);
  rule.provisional = true;
  rule.benchmark = "linear_time";
  EXPECT_EQ(judge(rule, completed(), std::vector<MetricValue>{{"time_s", 1, 80}}).sentence,
            "Passed: 80 s, target 90 s (provisional).");
  const Verdict failed = judge(rule, completed(), std::vector<MetricValue>{{"time_s", 1, 100}});
  EXPECT_EQ(failed.sentence, "Not passed: 100 s is 10 s over the provisional target of 90 s.");
  EXPECT_EQ(failed.criteria[0].benchmark, "linear_time");
  EXPECT_TRUE(failed.criteria[0].provisional);
}

TEST(Judge, AnExactTargetIsNotMetFromEitherSide) {
  const Rule strict = metric("time_s", Comparison::less, 90.0);
  EXPECT_EQ(judge(strict, completed(), std::vector<MetricValue>{{"time_s", 1, 90}}).sentence,
            "Not passed: 90 s is just the target of 90 s, which does not meet it.");
  const Rule exact = metric("wall_hits", Comparison::equal, 0.0);
  EXPECT_EQ(judge(exact, completed(), std::vector<MetricValue>{{"wall_hits", 1, 3}}).sentence,
            "Not passed: 3 wall hits are not the target of 0.");
}

}  // namespace
}  // namespace assessment
