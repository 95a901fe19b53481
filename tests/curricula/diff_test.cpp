#include "curricula/diff.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "curricula/line_diff.h"
#include "tests/curricula/valid_curriculum.h"

namespace {

using curricula::Change;
using curricula::check;
using curricula::compare_versions;
using curricula::Curriculum;
using curricula::diff;
using curricula::DiffLine;
using curricula::line_diff;
using test::replaced;
using test::small_catalogue;
using test::valid_curriculum;

Curriculum read(const std::string& text) {
  auto result = check(text, small_catalogue());
  for (const auto& problem : result.problems)
    ADD_FAILURE() << problem.line << ": " << problem.message;
  return result.curriculum.value_or(Curriculum{});
}

Curriculum changed(const std::string& from, const std::string& to) {
  return read(replaced(valid_curriculum(), from, to));
}

TEST(Diff, NothingChangedIsNothingSaid) {
  EXPECT_TRUE(diff(read(valid_curriculum()), read(valid_curriculum())).empty());
  EXPECT_TRUE(diff(read(valid_curriculum()), read(valid_curriculum() + "# a comment\n")).empty());
}

TEST(Diff, NamesEachChangeWithItsWeight) {
  struct Case {
    const char* from;
    const char* to;
    const char* weight;
    const char* sentence;
  };
  const Case cases[] = {
      {"to_mm: 300", "to_mm: 290", "major", "feed: step 'there' goes to 290 mm instead of 300 mm"},
      {"tolerance_mm: 2", "tolerance_mm: 3", "major",
       "feed: step 'there' has a tolerance of 3 mm instead of 2 mm"},
      {"seconds: 3", "seconds: 4", "major", "feed: step 'still' lasts 4 s instead of 3 s"},
      {"hold_s: 1}", "hold_s: 2}", "major", "feed: step 'there' is held for 2 s instead of 1 s"},
      {"value: 1.5", "value: 2", "major", "feed: the limit on force_max_n is 2 instead of 1.5"},
      {"on_breach: mark", "on_breach: fail", "major",
       "feed: a breach of the limit on time_s is judged differently"},
      {"value: 90", "value: 80", "major", "feed: the pass mark of time_s is 80 instead of 90"},
      {"errors: critical, op", "errors: fail, op", "major",
       "feed: the pass rule asks for other things"},
      {"consecutive: 1}", "consecutive: 2}", "major",
       "turn: what makes a person proficient changed"},
      {"start_mm: 50", "start_mm: 60", "major",
       "feed: it starts with 60 mm instead of 50 mm inserted"},
      {"time_limit_s: 60", "time_limit_s: 50", "major",
       "turn: the time limit is 50 s instead of 60 s"},
      {"record: [time_s, force_max_n]", "record: [time_s, force_max_n, wall_hits]", "minor",
       "feed: wall_hits is recorded as well"},
      {"record: [time_s, force_max_n]", "record: [time_s]", "minor",
       "feed: force_max_n is no longer recorded"},
      {"max_trials_per_day: 4", "max_trials_per_day: 5", "minor", "the plan changed"},
      {"    requires: {all: [{exercise: feed, state: proficient}]}\n", "", "minor",
       "turn: what must be proficient before it changed"},
      {"{en: \"Feed it.\"}", "{en: \"Feed it slowly.\"}", "patch",
       "feed: the text of the goal changed"},
      {"authors: [\"somebody\"]", "authors: [\"another\"]", "patch", "the authors changed"},
  };
  const Curriculum before = read(valid_curriculum());
  for (const Case& c : cases) {
    const auto changes = diff(before, changed(c.from, c.to));
    const auto found = std::find_if(changes.begin(), changes.end(), [&](const Change& change) {
      return change.sentence == c.sentence;
    });
    ASSERT_NE(found, changes.end()) << c.sentence << "\n"
                                    << (changes.empty() ? "nothing" : changes[0].sentence);
    EXPECT_STREQ(curricula::word(found->weight), c.weight) << c.sentence;
  }
}

TEST(Diff, RotationsAreGivenInDegrees) {
  const auto changes = diff(read(valid_curriculum()), changed("to_deg: 180", "to_deg: 360"));
  ASSERT_EQ(changes.size(), 2U);  // once per round
  EXPECT_EQ(changes[0].sentence, "turn: step 'cw.1' goes to 360 degrees instead of 180 degrees");
}

TEST(Diff, AnExerciseTakenOutIsMajorAndANewOneMinor) {
  const std::string text = valid_curriculum();
  std::string without = text;
  without.erase(text.find("  - id: turn"), text.find("plan:") - text.find("  - id: turn"));
  without = replaced(without, "exercises: [turn], order: listed, after: first",
                     "exercises: [], order: any");
  without.erase(without.find("  - {block: second"),
                without.find("completion:") - without.find("  - {block: second"));
  const auto gone = diff(read(text), read(without));
  EXPECT_TRUE(std::any_of(gone.begin(), gone.end(), [](const Change& change) {
    return change.sentence == "turn: the exercise is gone" &&
           change.weight == Change::Weight::major;
  }));
  const auto added = diff(read(without), read(text));
  EXPECT_TRUE(std::any_of(added.begin(), added.end(), [](const Change& change) {
    return change.sentence == "turn: the exercise is new" && change.weight == Change::Weight::minor;
  }));
}

std::string bump(const std::string& text, const char* version) {
  return replaced(text, "version: 1.2.0", std::string("version: ") + version);
}

TEST(CompareVersions, AnEditedPublishedFileIsRefused) {
  const auto problems =
      compare_versions(read(valid_curriculum()), read(valid_curriculum() + "# edited\n"));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].line, 3);
  EXPECT_NE(problems[0].message.find("must not be edited: make this version 1.2.1"),
            std::string::npos)
      << problems[0].message;
}

TEST(CompareVersions, TheSameFileIsFine) {
  EXPECT_TRUE(compare_versions(read(valid_curriculum()), read(valid_curriculum())).empty());
}

TEST(CompareVersions, ADraftMayChangeAsItLikes) {
  const Curriculum draft = changed("status: published", "status: draft");
  EXPECT_TRUE(compare_versions(draft, changed("to_mm: 300", "to_mm: 290")).empty());
}

TEST(CompareVersions, AChangedStepNeedsAMajorVersionAndANewExerciseVersion) {
  const std::string text = replaced(valid_curriculum(), "to_mm: 300", "to_mm: 290");
  const auto problems = compare_versions(read(valid_curriculum()), read(bump(text, "1.3.0")));
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].line, 3);
  EXPECT_NE(problems[0].message.find("write 2.0.0"), std::string::npos) << problems[0].message;
  EXPECT_EQ(problems[1].line, 18);
  EXPECT_NE(problems[1].message.find("still version 3: write 4"), std::string::npos)
      << problems[1].message;

  const std::string right = replaced(bump(text, "2.0.0"), "version: 3", "version: 4");
  EXPECT_TRUE(compare_versions(read(valid_curriculum()), read(right)).empty());
}

TEST(CompareVersions, ARecordedMetricNeedsAMinorVersionOnly) {
  const std::string text =
      replaced(valid_curriculum(), "[time_s, reversals]", "[time_s, reversals, wall_hits]");
  EXPECT_EQ(compare_versions(read(valid_curriculum()), read(bump(text, "1.2.1"))).size(), 1U);
  EXPECT_TRUE(compare_versions(read(valid_curriculum()), read(bump(text, "1.3.0"))).empty());
}

TEST(CompareVersions, AWordNeedsAPatchAndNeverGoesBack) {
  const std::string text = replaced(valid_curriculum(), "Feed it.", "Feed it, please.");
  EXPECT_TRUE(compare_versions(read(valid_curriculum()), read(bump(text, "1.2.1"))).empty());
  EXPECT_EQ(compare_versions(read(valid_curriculum()), read(bump(text, "1.1.9"))).size(), 1U);
  const std::string back = replaced(bump(text, "1.2.1"), "version: 3", "version: 2");
  const auto problems = compare_versions(read(valid_curriculum()), read(back));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].message.find("never go back"), std::string::npos);
}

TEST(CompareVersions, AnotherCurriculumIsNoVersion) {
  const auto problems =
      compare_versions(read(valid_curriculum()), changed("id: small", "id: other"));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].line, 2);
}

// One letter per line: ' ' same, '-' removed, '+' added.
std::string signs(const std::vector<DiffLine>& lines) {
  std::string result;
  for (const DiffLine& line : lines) {
    result += line.kind == DiffLine::Kind::same      ? ' '
              : line.kind == DiffLine::Kind::removed ? '-'
                                                     : '+';
  }
  return result;
}

TEST(LineDiff, ShowsWhatWasTakenOutAndPutIn) {
  const auto lines = line_diff("a\nb\nc\nd\n", "a\nc\nx\nd\n");
  EXPECT_EQ(signs(lines), " - + ");
  EXPECT_EQ(lines[1].text, "b");
  EXPECT_EQ(lines[1].before_line, 2);
  EXPECT_EQ(lines[1].after_line, 0);
  EXPECT_EQ(lines[3].text, "x");
  EXPECT_EQ(lines[3].after_line, 3);
  EXPECT_EQ(lines[4].before_line, 4);
  EXPECT_EQ(lines[4].after_line, 4);
}

TEST(LineDiff, TakesLineEndsOfEitherKindForTheSame) {
  EXPECT_EQ(signs(line_diff("a\r\nb\r\n", "a\nb")), "  ");
  EXPECT_EQ(signs(line_diff("", "a")), "+");
  EXPECT_EQ(signs(line_diff("a", "")), "-");
  EXPECT_TRUE(line_diff("", "").empty());
}

TEST(LineDiff, GivesLargeRewritesAsTwoBlocks) {
  std::string before, after;
  for (int i = 0; i < 5000; ++i) {
    before += "b" + std::to_string(i) + "\n";
    after += "a" + std::to_string(i) + "\n";
  }
  EXPECT_EQ(signs(line_diff(before, after)), std::string(5000, '-') + std::string(5000, '+'));
}

}  // namespace
