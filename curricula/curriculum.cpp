#include "curricula/curriculum.h"

#include <numbers>

#include "curricula/number_text.h"

namespace curricula {
namespace {

void unroll_into(const std::vector<Step>& steps, const std::string& suffix,
                 std::vector<Step>& out) {
  for (const Step& step : steps) {
    if (step.kind == Step::Kind::repeat) {
      for (int round = 1; round <= step.times; ++round) {
        unroll_into(step.steps, suffix + "." + std::to_string(round), out);
      }
    } else {
      out.push_back(step);
      out.back().id += suffix;
    }
  }
}

std::string count_of(const std::vector<Step>& steps) {
  return std::to_string(steps.size()) + (steps.size() == 1 ? " step" : " steps");
}

}  // namespace

const Exercise* Curriculum::find(const std::string& exercise_id) const {
  for (const Exercise& exercise : exercises) {
    if (exercise.id == exercise_id) return &exercise;
  }
  return nullptr;
}

std::vector<Step> unroll(const std::vector<Step>& steps) {
  std::vector<Step> result;
  unroll_into(steps, "", result);
  return result;
}

std::string describe(const Step& step, double from) {
  switch (step.kind) {
    case Step::Kind::translate:
      return (step.target < from ? "Retract to " : "Feed to ") + number_text(step.target) + " mm";
    case Step::Kind::rotate:
      return "Turn to " + number_text(step.target * 180.0 / std::numbers::pi) + " degrees";
    case Step::Kind::hold:
      return "Hold still for " + number_text(step.seconds) + " s";
    case Step::Kind::repeat:
      return "Repeat " + count_of(step.steps) + " " + std::to_string(step.times) + " times";
  }
  return {};
}

std::vector<std::string> describe_all(const std::vector<Step>& unrolled) {
  std::vector<std::string> titles;
  double axial = 0.0;
  for (const Step& step : unrolled) {
    titles.push_back(describe(step, axial));
    if (step.kind == Step::Kind::translate) axial = step.target;
  }
  return titles;
}

}  // namespace curricula
