#include "assessment/metrics.h"

#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/assessment/synthetic_trial.h"

namespace assessment {
namespace {

std::optional<double> metric(const RecordedTrial& trial, const std::string& id) {
  for (const MetricValue& value : compute_metrics(trial)) {
    if (value.id == id) return value.value;
  }
  return std::nullopt;
}

TEST(MetricDefinitions, AreCompleteAndUnique) {
  std::set<std::string_view> ids;
  for (const MetricDefinition& definition : metric_definitions()) {
    EXPECT_TRUE(ids.insert(definition.id).second) << definition.id;
    EXPECT_FALSE(definition.title.empty()) << definition.id;
    EXPECT_EQ(definition.definition.back(), '.') << definition.id;
    EXPECT_GE(definition.version, 1);
    EXPECT_EQ(find_metric(definition.id), &definition);
  }
  for (const char* id : {"time_s",
                         "path_length_mm",
                         "path_economy",
                         "rotation_total_deg",
                         "rotation_economy",
                         "reversals",
                         "overshoot_mm",
                         "overshoot_deg",
                         "settle_s",
                         "speed_mean_mm_s",
                         "speed_max_mm_s",
                         "idle_s",
                         "submovements",
                         "sparc_stroke",
                         "ldlj_stroke",
                         "force_max_n",
                         "force_p95_n",
                         "force_mean_contact_n",
                         "force_rms_n",
                         "contact_impulse_n_s",
                         "force_rate_max_n_s",
                         "handle_force_max_n",
                         "torque_max_n_mm",
                         "wall_hits"}) {
    EXPECT_TRUE(ids.count(id)) << id;
  }
  EXPECT_EQ(find_metric("no_such_metric"), nullptr);
}

TEST(Metrics, ComeInTheOrderOfTheirDefinitions) {
  const auto values = compute_metrics(linear_trial());
  std::size_t position = 0;
  const auto definitions = metric_definitions();
  for (const MetricValue& value : values) {
    while (position < definitions.size() && definitions[position].id != value.id) ++position;
    ASSERT_LT(position, definitions.size()) << value.id << " is out of order";
    EXPECT_EQ(value.version, definitions[position].version);
  }
}

TEST(Metrics, TimeRunsFromTheFirstMotionToTheEndOfTheLastStep) {
  // 7 + 1, 4 + 1 and 4 + 1 seconds after one second of waiting
  EXPECT_NEAR(*metric(linear_trial(), "time_s"), 18.0, 1e-9);
}

TEST(Metrics, MotionBelowTheThresholdsDoesNotStartTheClock) {
  const auto trial = [](double creep_mm_s) {
    return TrialBuilder()
        .begin_step("feed", StepKind::translate, 50.0, 2.0)
        .feed(2.0 * creep_mm_s, creep_mm_s)
        .feed(50.0 - 2.0 * creep_mm_s, 10.0)
        .end_step()
        .done();
  };
  EXPECT_NEAR(*metric(trial(0.9), "time_s"), 4.82, 1e-9);
  EXPECT_NEAR(*metric(trial(1.1), "time_s"), 2.0 + 4.78, 1e-9);

  const auto turning = [](double speed_deg) {
    return TrialBuilder()
        .begin_step("turn", StepKind::rotate, std::numbers::pi, 0.1)
        .turn_deg(2.0 * speed_deg, speed_deg)
        .turn_deg(180.0 - 2.0 * speed_deg, 100.0)
        .end_step()
        .done();
  };
  EXPECT_LT(*metric(turning(4.9), "time_s"), 2.0);
  EXPECT_GT(*metric(turning(5.1), "time_s"), 3.0);
}

TEST(Metrics, StepTimesAddUpToTheCompletionTime) {
  const auto times = step_times(linear_trial());
  ASSERT_EQ(times.size(), 3u);
  EXPECT_EQ(times[0].step_id, "feed-1");
  EXPECT_NEAR(times[0].seconds, 8.0, 1e-9);
  EXPECT_NEAR(times[1].seconds, 5.0, 1e-9);
  EXPECT_NEAR(times[2].seconds, 5.0, 1e-9);
  RecordedTrial unfinished = linear_trial();
  unfinished.steps.back().ended = -1.0;
  EXPECT_EQ(step_times(unfinished).size(), 2u);
}

TEST(Metrics, APerfectLinearTaskHasFullEconomyAlthoughItEndsWhereItWas) {
  const RecordedTrial trial = linear_trial();
  EXPECT_NEAR(*metric(trial, "path_economy"), 1.0, 1e-12);
  // every turn of direction is rounded off by the 8 Hz low-pass: under 1 mm each at 50 mm/s
  EXPECT_NEAR(*metric(trial, "path_length_mm"), 750.0, 2.0);
  EXPECT_NEAR(*metric(trial, "speed_max_mm_s"), 50.0, 5.0);
  EXPECT_NEAR(*metric(trial, "speed_mean_mm_s"), 750.0 / 18.0, 0.2);
  EXPECT_FALSE(metric(trial, "rotation_economy"));
  EXPECT_FALSE(metric(trial, "overshoot_deg"));
  EXPECT_EQ(*metric(trial, "rotation_total_deg"), 0.0);
}

TEST(Metrics, OvershootAndSettlingAreMeasuredPastTheTarget) {
  const RecordedTrial trial = TrialBuilder()
                                  .begin_step("feed", StepKind::translate, 100.0, 2.0)
                                  .feed(106.0, 20.0)
                                  .feed(-6.0, 20.0)
                                  .wait(1.0)
                                  .end_step()
                                  .done();
  EXPECT_NEAR(*metric(trial, "overshoot_mm"), 6.0, 1e-9);
  // from 98 mm out to 106 and back to 102 mm: 12 mm at 20 mm/s, on a grid of 0.01 s
  EXPECT_NEAR(*metric(trial, "settle_s"), 0.6, 0.0201);
  EXPECT_NEAR(*metric(trial, "path_economy"), 100.0 / 112.0, 1e-9);
  // stopping within the tolerance before the target is no overshoot, and no better than perfect
  const RecordedTrial shy = TrialBuilder()
                                .begin_step("feed", StepKind::translate, 100.0, 2.0)
                                .feed(98.5, 20.0)
                                .wait(1.0)
                                .end_step()
                                .done();
  EXPECT_EQ(*metric(shy, "overshoot_mm"), 0.0);
  EXPECT_EQ(*metric(shy, "settle_s"), 0.0);
  EXPECT_EQ(*metric(shy, "path_economy"), 1.0);
}

TEST(Metrics, AStartingDepthIsNotTravel) {
  RecordedTrial trial = TrialBuilder()
                            .begin_step("feed", StepKind::translate, 300.0, 2.0)
                            .feed(100.0, 20.0)
                            .end_step()
                            .done();
  for (Sample& sample : trial.samples) sample.handle_axial += 200.0;
  EXPECT_NEAR(*metric(trial, "path_economy"), 1.0, 1e-12);
  EXPECT_EQ(*metric(trial, "overshoot_mm"), 0.0);
}

TEST(Metrics, RotationIsCountedInDegreesWithItsDetours) {
  const double turn = 2.0 * std::numbers::pi;
  const RecordedTrial trial = TrialBuilder()
                                  .begin_step("cw", StepKind::rotate, turn, 0.1)
                                  .turn_deg(370.0, 90.0)
                                  .turn_deg(-10.0, 90.0)
                                  .end_step()
                                  .begin_step("ccw", StepKind::rotate, 0.0, 0.1)
                                  .turn_deg(-360.0, 90.0)
                                  .end_step()
                                  .done();
  EXPECT_NEAR(*metric(trial, "rotation_total_deg"), 740.0, 1e-6);
  EXPECT_NEAR(*metric(trial, "rotation_economy"), 720.0 / 740.0, 1e-9);
  EXPECT_NEAR(*metric(trial, "overshoot_deg"), 10.0, 0.91);  // a sample is 0.9 degrees
  EXPECT_EQ(*metric(trial, "reversals"), 1.0);
  EXPECT_FALSE(metric(trial, "path_economy"));
  EXPECT_FALSE(metric(trial, "sparc_stroke"));
}

TEST(Metrics, IdleTimeCountsStandstillOfHalfASecondOrMore) {
  const auto trial = [](double pause) {
    return TrialBuilder()
        .begin_step("feed", StepKind::translate, 100.0, 2.0)
        .wait(3.0)  // before the first motion nobody is idle
        .feed(50.0, 20.0)
        .wait(pause)
        .feed(50.0, 20.0)
        .end_step()
        .done();
  };
  // the low-pass lets the tip come to rest some 0.05 s late, and start as much early
  EXPECT_NEAR(*metric(trial(2.0), "idle_s"), 2.0, 0.25);
  EXPECT_EQ(*metric(trial(0.4), "idle_s"), 0.0);
}

TEST(Metrics, SmoothnessIsTheMedianOverTheStrokes) {
  const RecordedTrial trial = linear_trial();
  const double sparc = *metric(trial, "sparc_stroke");
  EXPECT_LT(sparc, -1.0);
  EXPECT_GT(sparc, -3.0);
  // a stroke interrupted again and again is rougher
  TrialBuilder builder;
  builder.begin_step("feed", StepKind::translate, 350.0, 2.0).wait(0.5);
  for (int i = 0; i < 10; ++i) builder.feed(35.0, 50.0).wait(0.4);
  const RecordedTrial halting = builder.end_step().done();
  EXPECT_LT(*metric(halting, "sparc_stroke"), sparc);
  EXPECT_LT(*metric(halting, "ldlj_stroke"), *metric(trial, "ldlj_stroke"));
  EXPECT_GE(*metric(halting, "submovements"), 10.0);
}

RecordedTrial with_force(double (*force)(double time), double seconds = 10.0) {
  RecordedTrial trial = TrialBuilder()
                            .begin_step("feed", StepKind::translate, 20.0 * seconds, 2.0)
                            .feed(20.0 * seconds, 20.0)
                            .end_step()
                            .done();
  for (Sample& sample : trial.samples) sample.contact_force = force(sample.time);
  return trial;
}

TEST(Metrics, ForceMetricsMatchAClosedForm) {
  // a triangle from 0 at 2 s over 1 N at 4 s to 0 at 6 s, of 10 s
  const RecordedTrial trial =
      with_force([](double t) { return std::max(0.0, 1.0 - std::abs(t - 4.0) / 2.0); });
  EXPECT_NEAR(*metric(trial, "force_max_n"), 1.0, 1e-9);
  EXPECT_NEAR(*metric(trial, "contact_impulse_n_s"), 2.0, 1e-9);  // trapezoids of a triangle
  EXPECT_NEAR(*metric(trial, "force_rate_max_n_s"), 0.5, 1e-9);
  // above f for 4 s (1 - f): 0.5 s of 10 at 0.875 N; a sample moves it by 0.005
  EXPECT_NEAR(*metric(trial, "force_p95_n"), 0.875, 0.005);
  EXPECT_NEAR(*metric(trial, "force_mean_contact_n"), 0.5, 0.002);
  EXPECT_NEAR(*metric(trial, "force_rms_n"), std::sqrt(4.0 / 3.0 / 10.0), 1e-3);
  EXPECT_EQ(*metric(trial, "wall_hits"), 1.0);
}

TEST(Metrics, WithoutContactThereIsNoMeanInContact) {
  const RecordedTrial trial = linear_trial();
  EXPECT_FALSE(metric(trial, "force_mean_contact_n"));
  EXPECT_EQ(*metric(trial, "force_max_n"), 0.0);
  EXPECT_EQ(*metric(trial, "wall_hits"), 0.0);
}

TEST(Metrics, WallHitsNeedHysteresisAndADistance) {
  // down to 0.06 N only: the same hit
  EXPECT_EQ(*metric(with_force([](double t) { return std::fmod(t, 1.0) < 0.5 ? 0.2 : 0.06; }),
                    "wall_hits"),
            1.0);
  EXPECT_EQ(
      *metric(with_force([](double t) { return std::fmod(t + 0.001, 1.0) < 0.5 ? 0.2 : 0.05; }),
              "wall_hits"),
      10.0 + 1.0);  // the eleventh begins with the last sample at 10 s
  // ten times a second: at least 0.2 s apart leaves every second one
  const double quick = *metric(
      with_force([](double t) { return std::fmod(t + 0.001, 0.1) < 0.05 ? 0.2 : 0.0; }, 9.99),
      "wall_hits");
  EXPECT_EQ(quick, 50.0);
  EXPECT_EQ(*metric(with_force([](double) { return 0.099; }), "wall_hits"), 0.0);
}

TEST(Metrics, APeakBetweenTwoSamplesIsKnownFromTheBreachOfTheLimit) {
  RecordedTrial trial = with_force([](double) { return 1.9; });
  trial.events.push_back({3.1234, "limit_breached", Severity::critical, "force_max_n", 2.01});
  EXPECT_EQ(*metric(trial, "force_max_n"), 2.01);
  EXPECT_NEAR(*metric(trial, "force_p95_n"), 1.9, 1e-12);
}

TEST(Metrics, HandlePeaksCountPushAndPull) {
  RecordedTrial trial = linear_trial();
  trial.samples[100].handle_force = -0.8;
  trial.samples[200].handle_force = 0.5;
  trial.samples[300].handle_torque = -3.5;
  EXPECT_EQ(*metric(trial, "handle_force_max_n"), 0.8);
  EXPECT_EQ(*metric(trial, "torque_max_n_mm"), 3.5);
}

TEST(Metrics, AnUnfinishedTrialHasNoCompletionTime) {
  RecordedTrial trial = linear_trial();
  trial.end_reason = EndReason::timeout;
  trial.steps[2].ended = -1.0;
  EXPECT_FALSE(metric(trial, "time_s"));
  EXPECT_TRUE(metric(trial, "path_length_mm"));
  EXPECT_NEAR(*metric(trial, "path_economy"), 1.0, 1e-12);  // of the steps that were done
}

TEST(Metrics, ARecordingThatCannotBeReadHasNone) {
  EXPECT_TRUE(compute_metrics({}).empty());
  RecordedTrial one;
  one.samples.resize(1);
  EXPECT_TRUE(compute_metrics(one).empty());
  RecordedTrial broken = linear_trial();
  broken.samples[50].contact_force = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(compute_metrics(broken).empty());
  RecordedTrial backwards = linear_trial();
  backwards.samples[50].time = 0.1;
  EXPECT_TRUE(compute_metrics(backwards).empty());
}

TEST(Metrics, NothingIsEverInfinite) {
  RecordedTrial still = TrialBuilder().wait(2.0).done();
  still.steps.push_back({.id = "hold", .kind = StepKind::hold, .target = 2.0, .ended = 2.0});
  RecordedTrial absurd = linear_trial();
  absurd.samples[700].tip[0] = 1e308;
  absurd.samples[800].contact_force = 1e300;
  for (const RecordedTrial* trial : {&still, &absurd}) {
    for (const MetricValue& value : compute_metrics(*trial)) {
      EXPECT_TRUE(std::isfinite(value.value)) << value.id;
    }
  }
  EXPECT_FALSE(metric(still, "time_s"));
}

TEST(Metrics, AreTheSameForTheSameRecording) {
  const RecordedTrial trial = linear_trial();
  const auto first = compute_metrics(trial), second = compute_metrics(trial);
  ASSERT_EQ(first.size(), second.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first[i].value, second[i].value);
}

// 90,000 samples in one stroke, the longest transform there can be. The budget is half a second in
// a release build; a debug build with sanitizers gets twenty times that.
TEST(Metrics, AQuarterOfAnHourTakesWellUnderHalfASecond) {
  RecordedTrial trial = TrialBuilder()
                            .begin_step("feed", StepKind::translate, 1800.0, 2.0)
                            .feed(1800.0, 2.0)
                            .end_step()
                            .done();
  ASSERT_EQ(trial.samples.size(), 90001u);
  for (Sample& sample : trial.samples) sample.tip[1] = std::sin(20.0 * sample.time);
  const std::clock_t begin = std::clock();  // processor time: other work must not fail the test
  const auto values = compute_metrics(trial);
  const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  EXPECT_FALSE(values.empty());
  RecordProperty("seconds", std::to_string(taken));
  EXPECT_LT(taken, 10.0);
}

}  // namespace
}  // namespace assessment
