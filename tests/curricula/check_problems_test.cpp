#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "curricula/check.h"
#include "tests/curricula/valid_curriculum.h"

namespace {

using curricula::check;
using curricula::Problem;
using test::replaced;
using test::small_catalogue;
using test::valid_curriculum;

// One thing broken in the valid curriculum: exactly one problem, there, saying this.
struct Broken {
  const char* name;
  const char* from;
  const char* to;
  int line;
  const char* says;
};

void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.name; }

class OneProblem : public testing::TestWithParam<Broken> {};

TEST_P(OneProblem, IsFoundWhereItStands) {
  const Broken& broken = GetParam();
  const auto result =
      check(replaced(valid_curriculum(), broken.from, broken.to), small_catalogue());
  EXPECT_FALSE(result.ok());
  ASSERT_EQ(result.problems.size(), 1U) << [&] {
    std::string all;
    for (const auto& p : result.problems) all += std::to_string(p.line) + ": " + p.message + "\n";
    return all;
  }();
  EXPECT_EQ(result.problems[0].line, broken.line);
  EXPECT_NE(result.problems[0].message.find(broken.says), std::string::npos)
      << result.problems[0].message;
}

const Broken kFormat[] = {
    {"WrongSchema", "curriculum/1", "curriculum/2", 1,
     "this program reads 'cathedra-curriculum/1'"},
    {"DuplicateKey", "status: published", "status: published\nstatus: draft", 5,
     "stands here twice"},
    {"UnknownKey", "authors:", "autors:", 6, "did you mean 'authors'?"},
    {"UnknownKeyWithoutGuess", "authors:", "qqqqqqqqqqqq:", 6, "take it out"},
    {"MissingKey", "    title: {en: \"Turn\"}\n", "", 32, "needs 'title'"},
    {"Anchor", "metric: time_s\n", "metric: &a time_s\n", 12, "anchors"},
    {"Tag", "value: 90", "value: !!float 90", 14, "tags"},
    {"LoneTag", "id: small", "id: ! small", 2, "tags"},
    {"KeyIsNoWord", "authors: [", "{a: b}: [x]\nauthors: [", 6, "a key must be a plain word"},
    {"SecondDocument", "sign_off: instructor}\n", "sign_off: instructor}\n---\na: b\n", 51,
     "second document"},
    {"BadId", "id: small", "id: Small!", 2, "cannot be an id"},
    {"BadVersion", "version: 1.2.0", "version: 1.2", 3, "three numbers"},
    {"LeadingZeroVersion", "version: 1.2.0", "version: 1.02.0", 3, "three numbers"},
    {"UnknownStatus", "status: published", "status: public", 4, "draft, published or retired"},
    {"TitleWithoutLanguage", "title: {en: \"Feed\"}", "title: \"Feed\"", 19, "needs a language"},
    {"TitleWithoutEnglish", "title: {en: \"Feed\"}", "title: {fr: \"Feed\"}", 19,
     "no English text"},
    {"BadLanguage", "de: \"Klein\"", "german: \"Klein\"", 5, "is no language"},
};

const Broken kNumbers[] = {
    {"QuotedNumber", "to_mm: 300", "to_mm: \"300\"", 23, "take the quotes off"},
    {"NumberWithUnit", "to_mm: 300", "to_mm: 300mm", 23, "its unit is in the key"},
    {"WordForNumber", "to_mm: 300", "to_mm: far", 23, "not one"},
    {"ListForNumber", "to_mm: 300", "to_mm: [300]", 23, "here it is a list"},
    {"NothingForNumber", "value: 90", "value:", 14, "here it is nothing"},
    {"NotANumber", "to_mm: 300", "to_mm: .nan", 23, "finite"},
    {"Infinite", "value: 90", "value: -.inf", 14, "finite"},
    {"Overflow", "value: 90", "value: 1e999", 14, "too large or too small"},
    {"Hexadecimal", "value: 90", "value: 0x5A", 14, "not one"},
    {"DecimalComma", "value: 1.5", "value: \"1,5\"", 27, "dot for decimals"},
    {"ZeroTolerance", "tolerance_mm: 2", "tolerance_mm: 0", 23, "above 0"},
    {"NegativeTolerance", "to_deg: 180, tolerance_deg: 5", "to_deg: 180, tolerance_deg: -5", 42,
     "above 0"},
    {"OutOfRange", "hold_s: 0.5", "hold_s: 61", 43, "from 0 to 60"},
    {"NotWhole", "min_trials: 3", "min_trials: 2.5", 31, "whole number"},
    {"NoTimeLimit", "time_limit_s: 60", "time_limit_s: 0", 37, "above 0"},
    {"WrongBoolean", "provisional: true", "provisional: yes", 13, "true or false"},
    {"UnreachableMaximum", "max_trials: 40", "max_trials: 2", 31, "write at least 3"},
};

const Broken kSteps[] = {
    {"MissingUnit", "to_mm: 300", "to: 300", 23, "lacks its unit: write 'to_mm'"},
    {"MissingUnitOfTolerance", "tolerance_mm: 2", "tolerance: 2", 23,
     "lacks its unit: write 'tolerance_mm'"},
    {"MissingUnitOfStart", "start_mm: 50", "start: 50", 21, "lacks its unit: write 'start_mm'"},
    {"OtherUnit", "to_mm: 300", "to_cm: 30", 23, "did you mean 'to_mm'?"},
    {"UnknownStep", "do: hold", "do: hodl", 24, "did you mean 'hold'?"},
    {"StepWithoutKind", "{id: still, do: hold, seconds: 3}", "{id: still, seconds: 3}", 24,
     "needs 'do'"},
    {"Navigate", "do: hold, seconds: 3", "do: navigate, target: {branch: x}", 24,
     "'navigate' steps"},
    {"Angiogram", "do: hold, seconds: 3", "do: angiogram, contrast_max_ml: 8", 24,
     "not available in this version"},
    {"Exchange", "do: hold, seconds: 3", "do: exchange", 24, "'exchange' steps"},
    {"DuplicateStep", "id: back", "id: there", 25, "'there' is there already"},
    {"BeyondTheVessel", "to_mm: 300", "to_mm: 351", 23, "write at most 350"},
    {"OutsideTheSheath", "to_mm: -50", "to_mm: -51", 25, "write at least -50"},
    {"NoSteps",
     "steps:\n          - {id: cw, do: rotate, to_deg: 180, tolerance_deg: 5}\n          - {id: "
     "ccw, do: rotate, to_deg: 0, tolerance_deg: 5, hold_s: 0.5}",
     "steps: []", 41, "is empty"},
    {"NestedRepeat", "- {id: cw, do: rotate, to_deg: 180, tolerance_deg: 5}",
     "- {repeat: 2, steps: [{id: cw, do: rotate, to_deg: 180, tolerance_deg: 5}]}", 42,
     "inside a repeat"},
    {"TooManySteps", "repeat: 2", "repeat: 501", 40, "at most 1000"},
    {"ZeroRepeats", "repeat: 2", "repeat: 0", 40, "from 1 to 1000"},
};

const Broken kScene[] = {
    {"UnknownAnatomy", "anatomy: tube, instruments: [wire], start",
     "anatomy: tub, instruments: [wire], start", 21, "did you mean 'tube'?"},
    {"UnknownInstrument", "[wire], start", "[catheter], start", 21, "choose wire or short-wire"},
    {"NoInstrument", "[wire], start", "[], start", 21, "is empty"},
    {"TwoInstruments", "[wire], start", "[wire, wire], start", 21, "one instrument at a time"},
    {"StartBeyondTheEnd", "[wire]}", "[wire], start_mm: 401}", 36, "beyond the end"},
    {"Access", "[wire]}", "[wire], access: right-femoral}", 36, "take 'access' out"},
};

const Broken kMetrics[] = {
    {"UnknownRecordedMetric", "record: [time_s, reversals]", "record: [time_s, reversals, time]",
     44, "no metric 'time'"},
    {"LaterMetric", "record: [time_s, reversals]", "record: [time_s, reversals, fluoro_s]", 44,
     "not measured by this version"},
    {"RecordedTwice", "record: [time_s, reversals]", "record: [time_s, reversals, time_s]", 44,
     "recorded already"},
    {"UnknownLimitMetric", "{metric: time_s, op: \"<\"", "{metric: tim_s, op: \"<\"", 28,
     "did you mean 'time_s'?"},
    {"LimitNotLive", "{metric: time_s, op: \"<\"", "{metric: force_p95_n, op: \"<\"", 28,
     "cannot be watched while a trial runs"},
    {"LimitFromBelow", "op: \"<\", value: 200", "op: \">\", value: 200", 28, "write < or <="},
    {"UnknownConsequence", "on_breach: mark", "on_breach: shout", 28,
     "mark, fail, critical_error or stop"},
    {"PassNotRecorded", "record: [time_s, reversals]", "record: [time_s]", 45, "not recorded"},
    {"UnknownPassMetric", "{metric: reversals, op", "{metric: reversal, op", 45,
     "did you mean 'reversals'?"},
    {"UnknownOperator", "op: \">\", value: 4", "op: \"=>\", value: 4", 45,
     "write <, <=, ==, !=, >= or >"},
    {"UnknownSeverity", "errors: critical", "errors: grave", 30, "critical, fail or mark"},
    {"UnknownGoal", "goal: reached", "goal: won", 45, "write reached"},
    {"EmptyRule", "{goal: reached}", "{}", 45, "needs one of 'all'"},
    {"EmptyAll", "pass: {any: [{not: {metric: reversals, op: \">\", value: 4}}, {goal: reached}]}",
     "pass: {all: []}", 45, "is empty"},
    {"Rating", "{goal: reached}", "{rating: grs}", 45, "no pass rule of this version"},
    {"ProficiencyWithoutPass",
     "    pass: {any: [{not: {metric: reversals, op: \">\", value: 4}}, {goal: reached}]}\n", "",
     45, "add 'pass'"},
    {"Window", "{consecutive: 1}", "{consecutive: 1, window: 5}", 46,
     "not available in this version"},
    {"UnknownFeedback", "during: [force]", "during: [music]", 9, "no feedback 'music'"},
};

const Broken kBenchmarks[] = {
    {"UnknownBenchmark", "benchmark: quick", "benchmark: quik", 30, "did you mean 'quick'?"},
    {"BenchmarkAndValue", "benchmark: quick", "benchmark: quick, value: 3", 30,
     "take one of the two out"},
    {"NeitherBenchmarkNorValue", ", benchmark: quick", "", 30, "needs 'value'"},
    {"NoReason", "    reason: {en: \"a guess\"}\n", "", 11, "neither source nor reason"},
    {"OtherMetric", "metric: time_s\n", "metric: force_max_n\n", 30,
     "is for force_max_n, not for time_s"},
    {"UnknownRule", "kind: fixed, provisional: true", "kind: magic", 13, "fixed, mean_plus_k_sd"},
    {"WithoutData", "rule: {kind: fixed, provisional: true}\n    value: 90\n",
     "rule: {kind: mean_plus_k_sd, k: 2, over: participant_means, group: expert}\n    source: "
     "{cohort: local, apparatus: keyboard, min_participants: 5}\n",
     30, "no value until its cohort has recorded trials"},
    {"TooFewParticipants", "    value: 90\n",
     "    value: 90\n    source: {cohort: local, apparatus: keyboard, min_participants: 2}\n", 15,
     "from 5 to"},
};

const Broken kReferences[] = {
    {"DuplicateExercise", "exercises: [turn]", "exercises: [turn, turn]", 49,
     "in block 'second' already"},
    {"UnknownRequirement", "{exercise: feed, state", "{exercise: fed, state", 35,
     "did you mean 'feed'?"},
    {"UnknownState", "state: proficient", "state: practised", 35, "write proficient"},
    {"RequiresAny",
     "requires: {all:", "requires: {all: [{exercise: feed, state: proficient}], any:", 35,
     "not available in this version"},
    {"RequirementInACircle", "{exercise: feed, state", "{exercise: turn, state", 35,
     "'turn' requires 'turn'"},
    {"BlockInACircle", "exercises: [feed], max", "exercises: [feed], after: second, max", 48,
     "go in a circle"},
    {"RequiredWithoutRecord",
     "    requires: {all: [{exercise: feed, state: proficient}]}\n    scene: {anatomy: tube, "
     "instruments: [wire]}",
     "    requires: {all: [{exercise: open, state: proficient}]}\n    scene: {anatomy: tube, "
     "instruments: [wire]}",
     35, "there is no exercise 'open'"},
    {"UnknownBlock", "after: first", "after: frist", 49, "did you mean 'first'?"},
    {"UnknownExerciseInPlan", "exercises: [turn]", "exercises: [turn, spin]", 49,
     "no exercise 'spin'"},
    {"DuplicateBlock", "block: second", "block: first", 49, "block 'first' is there already"},
    {"EmptyBlock", "order: listed, after: first, unlock: proficiency}",
     "order: listed, after: first, unlock: proficiency}\n  - {block: third, exercises: []}", 50,
     "is empty"},
    {"UnknownOrder", "order: listed", "order: random", 49, "write any or listed"},
    {"UnknownRetention", "sign_off: instructor", "sign_off: nobody", 50, "instructor or none"},
};

const auto name_of = [](const testing::TestParamInfo<Broken>& info) {
  return std::string(info.param.name);
};
INSTANTIATE_TEST_SUITE_P(CheckFormat, OneProblem, testing::ValuesIn(kFormat), name_of);
INSTANTIATE_TEST_SUITE_P(CheckNumbers, OneProblem, testing::ValuesIn(kNumbers), name_of);
INSTANTIATE_TEST_SUITE_P(CheckSteps, OneProblem, testing::ValuesIn(kSteps), name_of);
INSTANTIATE_TEST_SUITE_P(CheckScene, OneProblem, testing::ValuesIn(kScene), name_of);
INSTANTIATE_TEST_SUITE_P(CheckMetrics, OneProblem, testing::ValuesIn(kMetrics), name_of);
INSTANTIATE_TEST_SUITE_P(CheckBenchmarks, OneProblem, testing::ValuesIn(kBenchmarks), name_of);
INSTANTIATE_TEST_SUITE_P(CheckReferences, OneProblem, testing::ValuesIn(kReferences), name_of);

// "line:column message" of each, for problems that come together.
std::vector<std::string> places(const std::vector<Problem>& problems) {
  std::vector<std::string> result;
  for (const Problem& p : problems) result.push_back(std::to_string(p.line) + ": " + p.message);
  return result;
}

TEST(CheckTogether, TheColumnCountsCharactersAndNotBytes) {
  // two-byte letters before the mistake must not shift it
  const auto result = check(replaced(valid_curriculum(), "{en: \"Small\", de: \"Klein\"}",
                                     "{de: \"K\xC3\xB6\xC3\xB6l\", en: [a]}"),
                            small_catalogue());
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_EQ(result.problems[0].line, 5);
  EXPECT_EQ(result.problems[0].column, 25);
}

TEST(CheckTogether, WhatIsRequiredMustLeadToProficiency) {
  const auto result = check(
      replaced(valid_curriculum(),
               "    proficiency: {consecutive: 2, additional: 1, min_trials: 3, max_trials: 40}\n",
               ""),
      small_catalogue());
  // the exercise 'turn' and the block 'second' both require it
  EXPECT_EQ(places(result.problems),
            (std::vector<std::string>{
                "34: 'turn' requires 'feed', which has no way to become proficient: add "
                "'proficiency' to it",
                "48: block 'second' requires 'feed', which has no way to become proficient: add "
                "'proficiency' to it"}));
}

TEST(CheckTogether, AnAliasIsRefusedWhereItStands) {
  const auto result =
      check(replaced(valid_curriculum(), "value: 90", "value: *quick"), small_catalogue());
  ASSERT_FALSE(result.problems.empty());
  EXPECT_EQ(result.problems[0].line, 14);
  EXPECT_NE(result.problems[0].message.find("aliases"), std::string::npos);
}

TEST(CheckTogether, ASyntaxErrorIsReportedWithWhatStandsBeforeIt) {
  std::string text = replaced(valid_curriculum(), "status: published", "status: public");
  text = replaced(text, "goal: {en: \"Feed it.\"}", "goal: {en: \"Feed it.\"");
  const auto result = check(text, small_catalogue());
  ASSERT_EQ(result.problems.size(), 2U) << testing::PrintToString(places(result.problems));
  EXPECT_EQ(result.problems[0].line, 4);
  EXPECT_NE(result.problems[1].message.find("YAML cannot be read"), std::string::npos);
  EXPECT_GE(result.problems[1].line, 20);  // the parser sees it where the bracket is missed
  EXPECT_LE(result.problems[1].line, 22);
}

TEST(CheckTogether, RefusesWhatIsNotUtf8) {
  const auto result = check(replaced(valid_curriculum(), "somebody",
                                     "some\xE9"
                                     "body"),
                            small_catalogue());
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_EQ(result.problems[0].line, 6);
  EXPECT_EQ(result.problems[0].column, 16);
  EXPECT_NE(result.problems[0].message.find("UTF-8"), std::string::npos);
}

TEST(CheckTogether, RefusesControlCharacters) {
  const auto result = check(replaced(valid_curriculum(), "somebody",
                                     "some\x04"
                                     "body"),
                            small_catalogue());
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_EQ(result.problems[0].line, 6);
  EXPECT_NE(result.problems[0].message.find("control character"), std::string::npos);
}

TEST(CheckTogether, RefusesFilesOverOneMebibyte) {
  std::string text = valid_curriculum();
  text.append(1024 * 1024 - text.size(), '#');
  text[valid_curriculum().size() - 1] = '\n';
  EXPECT_TRUE(check(text, small_catalogue()).ok());  // just fits
  const auto result = check(text + "#", small_catalogue());
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_NE(result.problems[0].message.find("1 MiB"), std::string::npos);
}

TEST(CheckTogether, RefusesMoreThan32Levels) {
  // the pass rule of 'turn' stands on levels 4 and below: map, list, map, then this
  const auto nested = [](int depth) {
    std::string rule = "{goal: reached}";
    for (int i = 0; i < depth; ++i) rule = "{not: " + rule + "}";
    return replaced(valid_curriculum(), "{goal: reached}", rule);
  };
  EXPECT_TRUE(check(nested(26), small_catalogue()).ok());  // 3 + {any: [ : 2, + 26 + 1 = 32
  const auto result = check(nested(27), small_catalogue());
  EXPECT_FALSE(result.ok());
  ASSERT_FALSE(result.problems.empty());
  EXPECT_NE(result.problems[0].message.find("32 levels"), std::string::npos);
}

TEST(CheckTogether, AnEmptyFileSaysHowToBegin) {
  const auto result = check("", small_catalogue());
  ASSERT_EQ(result.problems.size(), 1U);
  EXPECT_NE(result.problems[0].message.find("schema"), std::string::npos);
}

TEST(CheckTogether, AThousandProblemsAreEnough) {
  std::string text = valid_curriculum();
  for (int i = 0; i < 5000; ++i) text += "zzzzzzzzzz" + std::to_string(i) + ": 1\n";
  const auto result = check(text, small_catalogue());
  ASSERT_EQ(result.problems.size(), 1001U);
  EXPECT_NE(result.problems.back().message.find("4000 further problems"), std::string::npos);
}

// The whole list for a file with many mistakes, as `curriculum check` prints it.
TEST(CheckTogether, FindsEveryProblemOfABrokenFileInOnePass) {
  const std::string folder = std::string(CATHEDRA_SOURCE_DIR) + "/tests/fixtures/curricula/";
  const auto read = [&](const char* name) {
    std::ifstream stream(folder + name);
    EXPECT_TRUE(stream) << name;
    return std::string{std::istreambuf_iterator<char>(stream), {}};
  };
  std::string found;
  for (const Problem& p : check(read("broken.yaml"), small_catalogue()).problems) {
    found += "broken.yaml:" + std::to_string(p.line) + ":" + std::to_string(p.column) + ": " +
             p.message + "\n";
  }
  EXPECT_EQ(found, read("broken.expected.txt"));
}

}  // namespace
