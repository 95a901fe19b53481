#include "assessment/trial.h"

#include "assessment/words.h"

namespace assessment {
namespace {

constexpr Word<EndReason> kEndReasons[] = {{EndReason::completed, "completed"},
                                           {EndReason::timeout, "timeout"},
                                           {EndReason::limit, "limit"},
                                           {EndReason::aborted, "aborted"},
                                           {EndReason::diverged, "diverged"}};
constexpr Word<Source> kSources[] = {{Source::live, "live"},
                                     {Source::imported, "imported"},
                                     {Source::simulated_operator, "simulated-operator"},
                                     {Source::published_data, "published-data"}};
constexpr Word<Severity> kSeverities[] = {{Severity::info, "info"},
                                          {Severity::mark, "mark"},
                                          {Severity::fail, "fail"},
                                          {Severity::critical, "critical"}};
constexpr Word<StepKind> kStepKinds[] = {
    {StepKind::translate, "translate"}, {StepKind::rotate, "rotate"}, {StepKind::hold, "hold"}};

}  // namespace

const char* word(EndReason reason) { return word_of<EndReason>(kEndReasons, reason); }
const char* word(Source source) { return word_of<Source>(kSources, source); }
const char* word(Severity severity) { return word_of<Severity>(kSeverities, severity); }
const char* word(StepKind kind) { return word_of<StepKind>(kStepKinds, kind); }

bool parse(const std::string& text, EndReason& reason) {
  return value_of<EndReason>(kEndReasons, text, reason);
}
bool parse(const std::string& text, Source& source) {
  return value_of<Source>(kSources, text, source);
}
bool parse(const std::string& text, Severity& severity) {
  return value_of<Severity>(kSeverities, text, severity);
}
bool parse(const std::string& text, StepKind& kind) {
  return value_of<StepKind>(kStepKinds, text, kind);
}

}  // namespace assessment
