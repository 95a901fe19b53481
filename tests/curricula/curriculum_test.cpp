#include "curricula/curriculum.h"

#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

using curricula::describe;
using curricula::Step;
using curricula::unroll;

Step step(Step::Kind kind, const char* id, double target = 0.0) {
  Step result;
  result.kind = kind;
  result.id = id;
  result.target = target;
  return result;
}

std::vector<std::string> ids(const std::vector<Step>& steps) {
  std::vector<std::string> result;
  for (const Step& s : steps) result.push_back(s.id);
  return result;
}

TEST(Unroll, NumbersTheRoundsOfARepeat) {
  Step repeat = step(Step::Kind::repeat, "");
  repeat.times = 2;
  repeat.steps = {step(Step::Kind::rotate, "cw", 6.0), step(Step::Kind::rotate, "ccw")};
  const auto steps =
      unroll({step(Step::Kind::translate, "in"), repeat, step(Step::Kind::hold, "still")});
  EXPECT_EQ(ids(steps),
            (std::vector<std::string>{"in", "cw.1", "ccw.1", "cw.2", "ccw.2", "still"}));
  EXPECT_EQ(steps[3].target, 6.0);
}

TEST(Unroll, LeavesPlainStepsAlone) {
  EXPECT_EQ(ids(unroll({step(Step::Kind::hold, "a")})), std::vector<std::string>{"a"});
  EXPECT_TRUE(unroll({}).empty());
}

TEST(Describe, SaysWhatTheHandIsToDo) {
  EXPECT_EQ(describe(step(Step::Kind::translate, "a", 350.0)), "Feed to 350 mm");
  EXPECT_EQ(describe(step(Step::Kind::translate, "a", 150.5), 350.0), "Retract to 150.5 mm");
  EXPECT_EQ(describe(step(Step::Kind::rotate, "a", 2.0 * std::numbers::pi)), "Turn to 360 degrees");
  EXPECT_EQ(describe(step(Step::Kind::rotate, "a", -std::numbers::pi / 2.0)),
            "Turn to -90 degrees");
  Step hold = step(Step::Kind::hold, "a");
  hold.seconds = 3.0;
  EXPECT_EQ(describe(hold), "Hold still for 3 s");
  Step repeat = step(Step::Kind::repeat, "");
  repeat.times = 6;
  repeat.steps.resize(2);
  EXPECT_EQ(describe(repeat), "Repeat 2 steps 6 times");
}

TEST(Curriculum, FindsAnExerciseByItsId) {
  curricula::Curriculum curriculum;
  curriculum.exercises.resize(2);
  curriculum.exercises[1].id = "linear";
  EXPECT_EQ(curriculum.find("linear"), &curriculum.exercises[1]);
  EXPECT_EQ(curriculum.find("other"), nullptr);
}

}  // namespace
