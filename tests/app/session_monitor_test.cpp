// The exercise monitor on observations made by hand: when a step is done, when a limit is broken,
// when a trial ends.
#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "app/session/exercise_monitor.h"

namespace app {
namespace {

using assessment::EndReason;
using assessment::Severity;
using curricula::Consequence;
using curricula::Step;

// Times are multiples of a millisecond that went through doubles.
constexpr double kRounding = 1e-9;  // s

Step translate(const std::string& id, double to, double hold) {
  Step step;
  step.id = id;
  step.kind = Step::Kind::translate;
  step.target = to;
  step.tolerance = 2.0;
  step.hold = hold;
  return step;
}

Step rotate(const std::string& id, double to, double tolerance, double hold = 0.0) {
  Step step;
  step.id = id;
  step.kind = Step::Kind::rotate;
  step.target = to;
  step.tolerance = tolerance;
  step.hold = hold;
  return step;
}

Step hold_still(double seconds, double tolerance) {
  Step step;
  step.id = "still";
  step.kind = Step::Kind::hold;
  step.seconds = seconds;
  step.tolerance = tolerance;
  return step;
}

curricula::Exercise exercise_of(std::vector<Step> steps) {
  curricula::Exercise exercise;
  exercise.id = "by-hand";
  exercise.steps = std::move(steps);
  exercise.attempt.time_limit = 900.0;
  return exercise;
}

// A monitor that is shown one millisecond after the other.
class Watched {
 public:
  explicit Watched(const curricula::Exercise& exercise) : monitor(exercise) {}

  // One step of the world with the handle where `now` says.
  void see() {
    ++now.step;
    monitor.observe(now, input);
  }
  void see(int steps) {
    for (int k = 0; k < steps; ++k) see();
  }
  // The hand moves at `speed` mm/s for so many steps.
  void feed(double speed, int steps) {
    input.feed = speed;
    for (int k = 0; k < steps; ++k) {
      now.handle_axial += speed * sim::kStepLength;
      see();
    }
    input.feed = 0.0;
  }
  void press(double force) {
    now.contact_force = force;
    see();
  }

  const assessment::Event* event(const std::string& code) const {
    const auto& all = monitor.events();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& e) { return e.code == code; });
    return found == all.end() ? nullptr : &*found;
  }
  long count(const std::string& code) const {
    const auto& all = monitor.events();
    return std::count_if(all.begin(), all.end(), [&](const auto& e) { return e.code == code; });
  }

  ExerciseMonitor monitor;
  sim::Observation now;
  sim::HandleInput input;
};

TEST(ExerciseMonitor, AStepIsDoneAfterExactlyTheHoldTimeWithinTheTolerance) {
  Watched trial(exercise_of({translate("in", 10.0, 1.0)}));
  trial.feed(10.0, 799);  // 7.99 mm: not yet within 2 mm of 10
  EXPECT_EQ(trial.monitor.task().held, 0.0);
  trial.feed(20.0, 1);  // 8.01 mm at 0.800 s
  trial.see(999);
  EXPECT_FALSE(trial.monitor.steps()[0].done());
  trial.see();  // 1.800 s: held for 1 s
  ASSERT_TRUE(trial.monitor.steps()[0].done());
  EXPECT_NEAR(trial.monitor.steps()[0].ended, 1.8, kRounding);
  EXPECT_NEAR(trial.monitor.steps()[0].residual, -1.99, 1e-9);  // mm, sums of 0.01
  EXPECT_TRUE(trial.monitor.task().ended);
  EXPECT_EQ(trial.monitor.task().end_reason, EndReason::completed);
}

TEST(ExerciseMonitor, TheToleranceBelongsToTheTarget) {
  Watched trial(exercise_of({translate("in", 10.0, 0.0)}));
  trial.now.handle_axial = 7.999;
  trial.see();
  EXPECT_FALSE(trial.monitor.steps()[0].done());
  trial.now.handle_axial = 12.001;
  trial.see();
  EXPECT_FALSE(trial.monitor.steps()[0].done());
  trial.now.handle_axial = 12.0;
  trial.see();
  EXPECT_TRUE(trial.monitor.steps()[0].done());
}

TEST(ExerciseMonitor, LeavingTheToleranceStartsTheHoldAgain) {
  Watched trial(exercise_of({translate("in", 10.0, 1.0)}));
  trial.now.handle_axial = 10.0;
  trial.see(900);
  EXPECT_NEAR(trial.monitor.task().held, 0.899, kRounding);
  trial.now.handle_axial = 12.5;  // one step outside is enough
  trial.see();
  EXPECT_EQ(trial.monitor.task().held, 0.0);
  trial.now.handle_axial = 10.0;
  trial.see(1000);
  EXPECT_FALSE(trial.monitor.steps()[0].done());
  trial.see();
  EXPECT_TRUE(trial.monitor.steps()[0].done());
}

TEST(ExerciseMonitor, RotationIsMeasuredAtTheHandleInRadians) {
  constexpr double kTurn = 2.0 * std::numbers::pi, kFive = 5.0 * std::numbers::pi / 180.0;
  Watched trial(exercise_of({rotate("cw", kTurn, kFive)}));
  trial.now.handle_axial = kTurn;  // feeding so far must not count
  trial.see();
  EXPECT_FALSE(trial.monitor.steps()[0].done());
  trial.now.handle_rotation = kTurn - 1.01 * kFive;
  trial.see();
  EXPECT_FALSE(trial.monitor.steps()[0].done());
  EXPECT_NEAR(trial.monitor.task().step_value, kTurn - 1.01 * kFive, 1e-12);
  trial.now.handle_rotation = kTurn + 0.99 * kFive;
  trial.see();
  EXPECT_TRUE(trial.monitor.steps()[0].done());
  EXPECT_NEAR(trial.monitor.steps()[0].residual, 0.99 * kFive, 1e-12);
}

TEST(ExerciseMonitor, AHoldStepWantsTheHandleStillWhereverItIs) {
  Watched trial(exercise_of({hold_still(2.0, 1.0)}));
  trial.now.handle_axial = 57.0;
  trial.see(1500);
  trial.now.handle_axial = 57.9;  // within 1 mm of where it was
  trial.see(300);
  EXPECT_GT(trial.monitor.task().held, 1.7);
  trial.now.handle_axial = 58.5;  // moved: from here anew
  trial.see();
  EXPECT_EQ(trial.monitor.task().held, 0.0);
  trial.see(2000);
  EXPECT_FALSE(trial.monitor.steps()[0].done());
  trial.see();
  EXPECT_TRUE(trial.monitor.steps()[0].done());
}

TEST(ExerciseMonitor, InAHoldStepADegreeCountsLikeAMillimetre) {
  Watched trial(exercise_of({hold_still(2.0, 1.0)}));
  trial.see(500);
  trial.now.handle_rotation = 0.99 * std::numbers::pi / 180.0;
  trial.see();
  EXPECT_GT(trial.monitor.task().held, 0.4);
  trial.now.handle_rotation = 1.01 * std::numbers::pi / 180.0;
  trial.see();
  EXPECT_EQ(trial.monitor.task().held, 0.0);
}

TEST(ExerciseMonitor, RepeatsAreDoneOneAfterTheOther) {
  Step repeat;
  repeat.kind = Step::Kind::repeat;
  repeat.times = 2;
  repeat.steps = {rotate("cw", 1.0, 0.1), rotate("ccw", 0.0, 0.1)};
  Watched trial(exercise_of({repeat}));
  ASSERT_EQ(trial.monitor.steps().size(), 4u);
  const char* ids[] = {"cw.1", "ccw.1", "cw.2", "ccw.2"};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(trial.monitor.steps()[k].id, ids[k]);
    EXPECT_EQ(trial.monitor.task().step_index, static_cast<int>(k));
    trial.now.handle_rotation = k % 2 == 0 ? 1.0 : 0.0;
    trial.see();
  }
  EXPECT_TRUE(trial.monitor.task().ended);
  EXPECT_EQ(trial.count("step_done"), 4);
  EXPECT_EQ(trial.count("step_started"), 4);
}

TEST(ExerciseMonitor, TheClockRunsFromTheFirstMotion) {
  Watched trial(exercise_of({translate("in", 100.0, 0.0)}));
  trial.feed(0.9, 500);  // below 1 mm/s is no motion
  EXPECT_FALSE(trial.monitor.task().started);
  EXPECT_EQ(trial.monitor.task().elapsed, 0.0);
  trial.feed(1.1, 1);
  ASSERT_TRUE(trial.monitor.task().started);
  ASSERT_NE(trial.event("first_motion"), nullptr);
  EXPECT_NEAR(trial.event("first_motion")->time, 0.500, kRounding);  // when that step began
  trial.see(249);
  EXPECT_NEAR(trial.monitor.task().elapsed, 0.250, kRounding);
}

TEST(ExerciseMonitor, TurningIsMotionToo) {
  Watched trial(exercise_of({rotate("cw", 1.0, 0.1)}));
  trial.input.turn = 4.9 * std::numbers::pi / 180.0;
  trial.see();
  EXPECT_FALSE(trial.monitor.task().started);
  trial.input.turn = -5.1 * std::numbers::pi / 180.0;
  trial.see();
  EXPECT_TRUE(trial.monitor.task().started);
}

TEST(ExerciseMonitor, TheTimeLimitCountsFromTheFirstMotion) {
  curricula::Exercise exercise = exercise_of({translate("in", 100.0, 0.0)});
  exercise.attempt.time_limit = 2.0;
  Watched trial(exercise);
  trial.see(5000);  // looking at the screen costs nothing
  EXPECT_FALSE(trial.monitor.task().ended);
  trial.feed(10.0, 1);
  trial.see(1998);
  EXPECT_FALSE(trial.monitor.task().ended);
  trial.see(2);  // one step of slack: the limit is compared with a difference of two times
  ASSERT_TRUE(trial.monitor.task().ended);
  EXPECT_EQ(trial.monitor.task().end_reason, EndReason::timeout);
  ASSERT_NE(trial.event("timeout"), nullptr);
  EXPECT_EQ(trial.event("timeout")->severity, Severity::fail);
}

curricula::Exercise with_limit(const std::string& metric, double bound, Consequence consequence) {
  curricula::Exercise exercise = exercise_of({translate("in", 100.0, 0.0)});
  exercise.limits = {{metric, assessment::Comparison::less_equal, bound, consequence}};
  return exercise;
}

TEST(ExerciseMonitor, ABrokenLimitIsNotedOnceWithItsConsequence) {
  const std::pair<Consequence, Severity> pairs[] = {
      {Consequence::mark, Severity::mark},
      {Consequence::fail, Severity::fail},
      {Consequence::critical_error, Severity::critical}};
  for (const auto& [consequence, severity] : pairs) {
    Watched trial(with_limit("force_max_n", 1.0, consequence));
    trial.press(1.0);  // at the bound is within it
    EXPECT_EQ(trial.count("limit_breached"), 0);
    trial.press(1.5);
    trial.press(3.0);
    ASSERT_EQ(trial.count("limit_breached"), 1);
    const assessment::Event& event = *trial.event("limit_breached");
    EXPECT_EQ(event.severity, severity);
    EXPECT_EQ(event.detail, "force_max_n");
    EXPECT_EQ(event.value, 1.5);
    EXPECT_NEAR(event.time, 0.002, kRounding);
    EXPECT_TRUE(trial.monitor.limits()[0].breached);
    EXPECT_EQ(trial.monitor.limits()[0].value, 3.0);
    EXPECT_FALSE(trial.monitor.task().ended);
  }
}

TEST(ExerciseMonitor, ALimitThatStopsEndsTheTrial) {
  Watched trial(with_limit("force_max_n", 1.0, Consequence::stop));
  trial.press(1.1);
  ASSERT_TRUE(trial.monitor.task().ended);
  EXPECT_EQ(trial.monitor.task().end_reason, EndReason::limit);
  EXPECT_EQ(trial.event("limit_breached")->severity, Severity::fail);
}

TEST(ExerciseMonitor, EachLimitWatchesItsOwnQuantity) {
  const auto breaks = [](const char* metric, double bound, auto&& act) {
    Watched trial(with_limit(metric, bound, Consequence::mark));
    act(trial);
    return trial.monitor.limits()[0].breached;
  };
  const auto pull = [](Watched& t) {
    t.now.handle_force = -3.0;
    t.see();
  };
  EXPECT_TRUE(breaks("handle_force_max_n", 2.9, pull));  // the size counts, not the sign
  EXPECT_FALSE(breaks("handle_force_max_n", 3.1, pull));
  const auto twist = [](Watched& t) {
    t.now.handle_torque = -8.0;
    t.see();
  };
  EXPECT_TRUE(breaks("torque_max_n_mm", 7.9, twist));
  EXPECT_FALSE(breaks("force_max_n", 1.0, twist));
  const auto lean = [](Watched& t) {
    t.now.contact_force = 0.5;
    t.see(1000);
  };  // 0.5 N s
  EXPECT_TRUE(breaks("contact_impulse_n_s", 0.49, lean));
  EXPECT_FALSE(breaks("contact_impulse_n_s", 0.51, lean));
  const auto dawdle = [](Watched& t) { t.feed(2.0, 3000); };
  EXPECT_TRUE(breaks("time_s", 2.9, dawdle));
  EXPECT_FALSE(breaks("time_s", 3.1, dawdle));
}

TEST(ExerciseMonitor, AWallHitNeedsAReleaseAndAPauseBeforeTheNext) {
  Watched trial(with_limit("wall_hits", 2, Consequence::mark));
  trial.press(0.2);
  trial.see(500);  // still the same hit
  EXPECT_EQ(trial.count("wall_hit"), 1);
  trial.press(0.07);  // not let go of yet
  trial.press(0.2);
  EXPECT_EQ(trial.count("wall_hit"), 1);
  trial.press(0.04);
  trial.press(0.2);
  EXPECT_EQ(trial.count("wall_hit"), 2);
  trial.press(0.04);
  trial.press(0.2);  // bouncing within 0.2 s is no other hit
  EXPECT_EQ(trial.count("wall_hit"), 2);
  trial.press(0.04);
  trial.see(200);
  trial.press(0.2);
  EXPECT_EQ(trial.count("wall_hit"), 3);
  EXPECT_TRUE(trial.monitor.limits()[0].breached);
}

TEST(ExerciseMonitor, NothingHappensAfterTheEnd) {
  Watched trial(with_limit("force_max_n", 1.0, Consequence::stop));
  trial.see(10);
  trial.monitor.end(EndReason::aborted, 0.010);
  const std::size_t events = trial.monitor.events().size();
  EXPECT_EQ(trial.monitor.events().back().code, "ended");
  EXPECT_EQ(trial.monitor.events().back().detail, "aborted");
  trial.monitor.end(EndReason::diverged, 0.020);
  trial.feed(100.0, 1);
  trial.press(5.0);
  trial.now.handle_axial = 100.0;
  trial.see();
  trial.monitor.note(0.030, "resumed");
  EXPECT_EQ(trial.monitor.events().size(), events);
  EXPECT_EQ(trial.monitor.task().end_reason, EndReason::aborted);
  EXPECT_FALSE(trial.monitor.steps()[0].done());
}

TEST(ExerciseMonitor, WhatIsNotedFromOutsideStandsBetweenTheEvents) {
  Watched trial(exercise_of({translate("in", 100.0, 0.0)}));
  trial.see();
  trial.monitor.note(0.001, "paused");
  ASSERT_NE(trial.event("paused"), nullptr);
  EXPECT_EQ(trial.event("paused")->severity, Severity::info);
}

}  // namespace
}  // namespace app
