#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/motion/low_pass.h"
#include "assessment/motion/path.h"
#include "assessment/motion/peaks.h"
#include "assessment/motion/rotation.h"
#include "assessment/motion/smoothness.h"
#include "tests/assessment/oracle.h"

namespace assessment {
namespace {

struct SpeedProfile {
  std::string name;
  std::vector<double> speed;
  double rate;
};

std::vector<double> minimum_jerk(double distance, double duration, double rate) {
  std::vector<double> speed;
  const int count = static_cast<int>(std::lround(duration * rate)) + 1;
  for (int i = 0; i < count; ++i) {
    const double u = i / (duration * rate);
    speed.push_back(distance / duration *
                    (30.0 * std::pow(u, 2) - 60.0 * std::pow(u, 3) + 30.0 * std::pow(u, 4)));
  }
  return speed;
}

// The inputs of the reference values, as described beside them.
std::vector<SpeedProfile> reference_profiles() {
  std::vector<double> gauss;
  for (int i = 0; i < 200; ++i) {
    const double t = -1.0 + 0.01 * i;
    gauss.push_back(std::exp(-5.0 * t * t));
  }
  return {{"gauss", gauss, 100.0},
          {"short16", {0, 1, 3, 6, 8, 9, 8, 6, 3, 1, 0, 0, 0, 0, 0, 0}, 20.0},
          {"minjerk350", minimum_jerk(350.0, 5.0, 100.0), 100.0}};
}

TEST(Smoothness, AgreesWithThePublishedImplementation) {
  const nlohmann::json reference = oracle::load("motion.json");
  const auto at = [&](const std::string& key) {
    return reference.at(key).at("value").get<double>();
  };
  for (const SpeedProfile& profile : reference_profiles()) {
    const auto arc = spectral_arc(profile.speed, profile.rate);
    ASSERT_TRUE(arc) << profile.name;
    // the transforms round differently, by some 1e-16 of the largest magnitude in each bin
    oracle::expect_close(arc->length, at(profile.name + ".sparc"), 1e-12, profile.name);
    EXPECT_EQ(arc->transform_size, at(profile.name + ".sparc.nfft"));
    EXPECT_EQ(arc->selected_bins, at(profile.name + ".sparc.n_selected"));
    EXPECT_EQ(arc->cut_frequency, at(profile.name + ".sparc.f_cut_hz"));
    // second differences of the Gaussian cancel four digits, of the other two fewer
    oracle::expect_close(*dimensionless_jerk(profile.speed, profile.rate), at(profile.name + ".dj"),
                         1e-10, profile.name);
    oracle::expect_close(*log_dimensionless_jerk(profile.speed, profile.rate),
                         at(profile.name + ".ldlj"), 1e-10, profile.name);
  }
}

TEST(Smoothness, SparcKnowsNeitherAmplitudeNorDuration) {
  const double plain = *sparc(minimum_jerk(350.0, 5.0, 100.0), 100.0);
  EXPECT_NEAR(*sparc(minimum_jerk(3500.0, 5.0, 100.0), 100.0), plain, 1e-12);
  // the bins fall elsewhere on the spectrum, which moves the arc in the third decimal
  EXPECT_NEAR(*sparc(minimum_jerk(350.0, 10.0, 100.0), 100.0), plain, 5e-3);
  EXPECT_NEAR(*sparc(minimum_jerk(350.0, 20.0, 100.0), 100.0), plain, 5e-3);
}

TEST(Smoothness, TrailingStandstillIsTakenForRoughnessUnlessTrimmed) {
  const std::vector<double> speed = minimum_jerk(350.0, 5.0, 100.0);
  std::vector<double> padded = speed;
  padded.insert(padded.end(), 200, 0.0);
  const double moved_by =
      *log_dimensionless_jerk(padded, 100.0) - *log_dimensionless_jerk(speed, 100.0);
  // T^3 grows by (701 / 501)^3, and nothing else changes: the profile ends without a kink
  EXPECT_NEAR(moved_by, -3.0 * std::log(701.0 / 501.0), 0.02);
  EXPECT_EQ(trimmed(padded, 1.0).size(), trimmed(speed, 1.0).size());
  EXPECT_EQ(*sparc(trimmed(padded, 1.0), 100.0), *sparc(trimmed(speed, 1.0), 100.0));
}

TEST(Smoothness, ATwoPartMovementIsLessSmooth) {
  std::vector<double> twice = minimum_jerk(175.0, 2.5, 100.0);
  const std::vector<double> half = twice;
  twice.insert(twice.end(), half.begin(), half.end());
  const std::vector<double> once = minimum_jerk(350.0, 5.0, 100.0);
  EXPECT_LT(*sparc(twice, 100.0), *sparc(once, 100.0));
  EXPECT_LT(*log_dimensionless_jerk(twice, 100.0), *log_dimensionless_jerk(once, 100.0));
}

TEST(Smoothness, IsAbsentWhereItHasNoMeaning) {
  const std::vector<double> still(100, 0.0), constant(100, 3.0), none, one{1.0};
  const std::vector<double> broken{1.0, std::nan(""), 2.0, 1.0};
  EXPECT_FALSE(sparc(still, 100.0));
  EXPECT_FALSE(sparc(none, 100.0));
  EXPECT_FALSE(sparc(one, 100.0));
  EXPECT_FALSE(sparc(broken, 100.0));
  EXPECT_FALSE(sparc(constant, 0.0));
  EXPECT_TRUE(sparc(constant, 100.0));
  EXPECT_FALSE(log_dimensionless_jerk(still, 100.0));
  EXPECT_FALSE(log_dimensionless_jerk(constant, 100.0));  // no jerk: its logarithm has no end
  EXPECT_FALSE(log_dimensionless_jerk(broken, 100.0));
  EXPECT_TRUE(trimmed(still, 1.0).empty());
}

TEST(Path, AgreesWithTheReferencePath) {
  const nlohmann::json reference = oracle::load("motion.json");
  const auto& input = reference.at("path7.segments").at("input");
  const auto points = input.at("p").get<std::vector<Point>>();
  const auto times = input.at("t").get<std::vector<double>>();
  EXPECT_EQ(segment_lengths(points),
            reference.at("path7.segments").at("value").get<std::vector<double>>());
  EXPECT_EQ(path_length(points), reference.at("path7.path_length").at("value").get<double>());
  EXPECT_DOUBLE_EQ(path_length(points) / (times.back() - times.front()),
                   reference.at("path7.mean_speed").at("value").get<double>());

  std::vector<bool> idle;
  for (const double speed : speeds(points, times)) idle.push_back(speed < 0.5);
  EXPECT_DOUBLE_EQ(time_in_runs(idle, times, 0.0),
                   reference.at("path7.idle_time_thr0.5").at("value").get<double>());
  EXPECT_EQ(time_in_runs(idle, times, 1.6), 0.0);
}

TEST(Path, LengthOfASampledMovementIsItsIntegral) {
  const nlohmann::json reference = oracle::load("motion.json");
  const std::vector<double> speed = minimum_jerk(350.0, 5.0, 100.0);
  std::vector<Point> points{{0.0, 0.0, 0.0}};
  for (std::size_t i = 1; i < speed.size(); ++i) {
    points.push_back({points.back()[0] + 0.005 * (speed[i] + speed[i - 1]), 0.0, 0.0});
  }
  oracle::expect_close(path_length(points),
                       reference.at("minjerk350.path_length_trapz").at("value"), 1e-12, "trapz");
}

TEST(Path, AnEmptyOrSinglePointPathHasNoLength) {
  const std::vector<Point> one{{1.0, 2.0, 3.0}};
  EXPECT_EQ(path_length({}), 0.0);
  EXPECT_EQ(path_length(one), 0.0);
  EXPECT_TRUE(speeds(one, std::vector<double>{0.0}).empty());
}

std::vector<double> sine(double frequency, int count, double rate = 100.0) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    values.push_back(std::sin(2.0 * std::numbers::pi * frequency * i / rate));
  }
  return values;
}

TEST(LowPass, HasTheGainOfATwiceAppliedButterworthFilterAndNoDelay) {
  for (const double frequency : {1.0, 4.0, 8.0, 12.0, 20.0}) {
    const std::vector<double> input = sine(frequency, 2000);
    const std::vector<double> output = low_pass(input, 100.0, 8.0);
    const double ratio =
        std::tan(std::numbers::pi * frequency / 100.0) / std::tan(std::numbers::pi * 8.0 / 100.0);
    const double gain = 1.0 / (1.0 + std::pow(ratio, 4));
    // a second from the ends, where the start-up has died out by exp(-2 pi 8 / sqrt 2) ~ 1e-15
    for (std::size_t i = 100; i < 1900; ++i) {
      ASSERT_NEAR(output[i], gain * input[i], 1e-12) << frequency << " Hz, sample " << i;
    }
  }
}

TEST(LowPass, LeavesConstantsAndStraightLinesAlone) {
  std::vector<double> line;
  for (int i = 0; i < 300; ++i) line.push_back(5.0 + 0.25 * i);
  const std::vector<double> constant(50, -3.0);
  for (const double value : low_pass(constant, 100.0)) EXPECT_NEAR(value, -3.0, 1e-12);
  const std::vector<double> smooth = low_pass(line, 100.0);
  // the line starts up from rest nine reflected samples before its first: a small lag is left there
  for (std::size_t i = 60; i < 240; ++i) EXPECT_NEAR(smooth[i], line[i], 1e-9);
}

// y = scipy.signal.filtfilt(*scipy.signal.butter(2, 8, fs=100), x), SciPy 1.10.1
TEST(LowPass, AgreesWithScipyIncludingTheEnds) {
  const std::vector<double> input{0, 1, 4, 2, -3, 0, 5, 9, 9, 8, 2, 1, 0, 0, 1};
  const std::vector<double> expected{0.1063575030127886, 0.6437721008987239, 1.1757477716781275,
                                     1.7426330285604086, 2.4449616100801,    3.3314900364632414,
                                     4.270995927466582,  4.981985259952416,  5.206729549653884,
                                     4.870011508852578,  4.113767437092916,  3.1986533052488575,
                                     2.3526580837157423, 1.675118627802242,  1.1269456454192797};
  const std::vector<double> output = low_pass(input, 100.0, 8.0);
  ASSERT_EQ(output.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(output[i], expected[i], 1e-12);
}

TEST(LowPass, TakesSeriesTooShortToReflect) {
  EXPECT_TRUE(low_pass({}, 100.0).empty());
  EXPECT_EQ(low_pass(std::vector<double>{2.0}, 100.0), std::vector<double>{2.0});
  for (const double value : low_pass(std::vector<double>{2.0, 2.0}, 100.0)) {
    EXPECT_NEAR(value, 2.0, 1e-12);
  }
}

// scipy.signal.find_peaks(x, height=.1*max, prominence=.05*max, distance=d)[0], SciPy 1.10.1
TEST(Peaks, AgreeWithScipy) {
  struct Case {
    std::vector<double> values;
    PeakLimits limits;
    std::vector<std::size_t> peaks;
  };
  const std::vector<Case> cases{
      {{0, 1, 0, 2, 2, 0, 3, 0}, {0.3, 0.15, 1}, {1, 3, 6}},
      {{0, 5, 4.9, 5, 0, 5, 5, 5, 0}, {0.5, 0.25, 3}, {3, 6}},
      {{3, 1, 2, 1, 3, 0, 4}, {0.4, 0.2, 1}, {2, 4}},
      {{9.1, -0.1, 5.8, 3.9, 4.1, 4.6, 1,    4.5, 3.3, 11.6, 5.5, 4.3, 4.4, 3.7, 2.9,
        4.2, 6,    4.5, 6.9, 4.6, 5,   8.1,  6.1, 4,   4.6,  6.1, 8.9, 4.5, 4.5, 7,
        3.2, 4.4,  6.8, 6.2, 5.2, 6.3, -0.7, 7,   3.1, 1.7,  5.6, 6.4, 4.1, 2.8, 5.1,
        4.9, 7.8,  6.5, 5.4, 7.2, 4.6, 3.1,  6.2, 6.2, 4.6,  3.4, 5.5, 0,   6.4, 6},
       {2, 1, 4},
       {2, 9, 16, 21, 26, 32, 37, 41, 46, 52}},
      {{2,     5.001,  3.002, 7.003, 1.004, 3.005, 6.006, 7.007, 1.008, 4.009, 6.01,  4.011,
        8.012, 3.013,  6.014, 3.015, 8.016, 5.017, 4.018, 2.019, 8.02,  7.021, 7.022, 7.023,
        6.024, 4.025,  3.026, 3.027, 8.028, 2.029, 4.03,  4.031, 5.032, 6.033, 3.034, 2.035,
        5.036, 7.037,  7.038, 5.039, 4.04,  6.041, 5.042, 7.043, 3.044, 5.045, 5.046, 6.047,
        5.048, 10.049, 8.05,  8.051, 1.052, 4.053, 4.054, 6.055, 0.056, 7.057, 7.058, 2.059},
       {2, 2, 5},
       {7, 12, 20, 28, 33, 38, 43, 49, 58}}};
  for (const Case& example : cases) {
    EXPECT_EQ(find_peaks(example.values, example.limits), example.peaks);
  }
}

TEST(Peaks, SubmovementsAreCountedOncePerPush) {
  std::vector<double> speed;
  for (int push = 0; push < 3; ++push) {
    const std::vector<double> one = minimum_jerk(100.0, 1.0, 100.0);
    speed.insert(speed.end(), one.begin(), one.end());
  }
  EXPECT_EQ(count_submovements(speed, 100.0), 3);
  for (double& v : speed) v += 0.001 * std::sin(v);  // ripple far below the prominence
  EXPECT_EQ(count_submovements(speed, 100.0), 3);
  EXPECT_EQ(count_submovements(std::vector<double>(50, 0.0), 100.0), 0);
  EXPECT_EQ(count_submovements({}, 100.0), 0);
}

TEST(Rotation, ReversalsIgnoreWhatStaysWithinTheDeadBand) {
  EXPECT_EQ(count_reversals(std::vector<double>{0, 90, 180, 270, 360}, 2.0), 0);
  EXPECT_EQ(count_reversals(std::vector<double>{0, 180, 360, 180, 0}, 2.0), 1);
  EXPECT_EQ(count_reversals(std::vector<double>{0, 360, 0, 360, 0, 360, 0}, 2.0), 5);
  EXPECT_EQ(count_reversals(std::vector<double>{0, 10, 8.5, 20, 18.1, 30}, 2.0), 0);
  EXPECT_EQ(count_reversals(std::vector<double>{0, 10, 7.9, 20}, 2.0), 2);
  // backwards first, and a slow drift that adds up beyond the band
  EXPECT_EQ(count_reversals(std::vector<double>{0, -5, 0}, 2.0), 1);
  EXPECT_EQ(count_reversals(std::vector<double>{0, 10, 9.5, 9, 8.5, 8, 7.5}, 2.0), 1);
  EXPECT_EQ(count_reversals({}, 2.0), 0);
}

TEST(Rotation, TotalIsTheSumOfAllTurns) {
  EXPECT_EQ(total_variation(std::vector<double>{0, 360, 0, -10}), 730.0);
  EXPECT_EQ(total_variation({}), 0.0);
}

}  // namespace
}  // namespace assessment
