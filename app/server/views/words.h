// What is said in words to the person in front of the screen.
#pragma once

#include <string>
#include <vector>

#include "assessment/rule.h"
#include "assessment/trial.h"
#include "curricula/curriculum.h"

namespace app {

std::string english(const curricula::Text& text);
std::string capitalised(std::string word);  // foundation -> Foundation

// "Completion time", "Critical errors": of a metric id, "errors.critical" or "goal.reached".
std::string subject_title(const std::string& subject);
std::string subject_unit(const std::string& subject);  // "s", or empty

// "Passed with completion time at most 90 s (provisional) and no critical error."
std::string rule_sentence(const assessment::Rule& rule);

// "Retract to 150 mm" of the step `retract`; the id itself when there is no such step.
std::string step_title(const std::string& step_id, const std::vector<curricula::Step>& steps);

// "Highest contact force passed the limit (2.13 N)": an event of a trial.
std::string event_text(const assessment::Event& event, const std::vector<curricula::Step>& steps);

// A number as people write it: at most `decimals`, without a tail of zeros.
std::string number_text(double value, int decimals);

}  // namespace app
