#include "assessment/trial.h"

#include <gtest/gtest.h>

#include "assessment/proficiency.h"
#include "assessment/rule.h"

namespace assessment {
namespace {

template <typename Value>
void expect_round_trip(std::initializer_list<Value> values) {
  for (const Value value : values) {
    Value read{};
    EXPECT_TRUE(parse(word(value), read)) << word(value);
    EXPECT_EQ(read, value);
  }
}

TEST(Words, ReadBackAsWhatTheyName) {
  expect_round_trip({EndReason::completed, EndReason::timeout, EndReason::limit, EndReason::aborted,
                     EndReason::diverged});
  expect_round_trip(
      {Source::live, Source::imported, Source::simulated_operator, Source::published_data});
  expect_round_trip({Severity::info, Severity::mark, Severity::fail, Severity::critical});
  expect_round_trip({StepKind::translate, StepKind::rotate, StepKind::hold});
  expect_round_trip({Outcome::passed, Outcome::not_passed, Outcome::invalid});
}

TEST(Words, AreTheOnesThatTheDatabaseKeeps) {
  EXPECT_STREQ(word(Source::simulated_operator), "simulated-operator");
  EXPECT_STREQ(word(Source::published_data), "published-data");
  EXPECT_STREQ(word(EndReason::timeout), "timeout");
  EXPECT_STREQ(word(Outcome::not_passed), "not_passed");
  EXPECT_STREQ(word(ExerciseStatus::practised), "practised");
}

TEST(Words, UnknownOnesAreRefusedAndChangeNothing) {
  Source source = Source::imported;
  for (const char* text : {"", "Live", "live ", "simulated_operator"}) {
    EXPECT_FALSE(parse(text, source)) << text;
    EXPECT_EQ(source, Source::imported);
  }
}

TEST(Comparison, SignsReadBackAndHoldAsTheySay) {
  const struct {
    const char* sign;
    bool below, equal, above;
  } cases[] = {{"<", true, false, false}, {"<=", true, true, false}, {"==", false, true, false},
               {"!=", true, false, true}, {">=", false, true, true}, {">", false, false, true}};
  for (const auto& example : cases) {
    Comparison comparison{};
    ASSERT_TRUE(parse(example.sign, comparison));
    EXPECT_STREQ(sign(comparison), example.sign);
    EXPECT_EQ(holds(1.0, comparison, 2.0), example.below);
    EXPECT_EQ(holds(2.0, comparison, 2.0), example.equal);
    EXPECT_EQ(holds(3.0, comparison, 2.0), example.above);
    EXPECT_FALSE(holds(std::numeric_limits<double>::quiet_NaN(), comparison, 2.0));
  }
  Comparison comparison{};
  EXPECT_FALSE(parse("=<", comparison));
}

}  // namespace
}  // namespace assessment
