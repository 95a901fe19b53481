#include "database/curricula.h"

#include <gtest/gtest.h>

#include "database/audit.h"
#include "tests/database/temporary_store.h"

namespace database_test {
namespace {

using base::ErrorCode;
using database::CurriculumVersion;
using database::ExerciseVersion;

CurriculumVersion basics(const std::string& version, std::vector<ExerciseVersion> exercises) {
  CurriculumVersion curriculum;
  curriculum.curriculum_id = "vascular-basics";
  curriculum.version = version;
  curriculum.sha256 = "hash of " + version;
  curriculum.yaml = "version: " + version + "\n# \"quoted\" 'text'\n";
  curriculum.status = "published";
  curriculum.exercises = std::move(exercises);
  return curriculum;
}

const ExerciseVersion linear{"", "linear", 1, "id: linear\n"};
const ExerciseVersion rotational{"", "rotational", 3, "id: rotational\n"};

class Curricula : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::unique_ptr<database::Store> store_ = open_store(folder_.url());

  CurriculumVersion publish(const CurriculumVersion& version) {
    const auto published = publish_curriculum(*store_, version, "system");
    EXPECT_TRUE(published) << (published ? "" : published.error().message);
    return published ? *published : CurriculumVersion{};
  }
};

TEST_F(Curricula, AreReadAsTheyWerePublished) {
  CurriculumVersion version = basics("1.0.0", {rotational, linear});
  version.benchmarks = {{"linear_time", "time_s", "fixed", true, 237.33, "paper"}};
  publish(version);
  const auto all = curriculum_versions(*store_);
  ASSERT_TRUE(all);
  ASSERT_EQ(all->size(), 1u);
  const CurriculumVersion& read = all->front();
  EXPECT_FALSE(read.row_id.empty());
  EXPECT_EQ(read.curriculum_id, version.curriculum_id);
  EXPECT_EQ(read.version, "1.0.0");
  EXPECT_EQ(read.sha256, version.sha256);
  EXPECT_EQ(read.yaml, version.yaml);
  EXPECT_EQ(read.status, "published");
  EXPECT_FALSE(read.published_utc.empty());
  ASSERT_EQ(read.exercises.size(), 2u);
  EXPECT_EQ(read.exercises[0].exercise_id, "rotational");
  EXPECT_EQ(read.exercises[0].version, 3);
  EXPECT_EQ(read.exercises[0].yaml, "id: rotational\n");
  EXPECT_EQ(read.exercises[1].exercise_id, "linear");
  ASSERT_EQ(read.benchmarks.size(), 1u);
  EXPECT_EQ(read.benchmarks[0].id, "linear_time");
  EXPECT_EQ(read.benchmarks[0].metric, "time_s");
  EXPECT_EQ(read.benchmarks[0].rule, "fixed");
  EXPECT_TRUE(read.benchmarks[0].provisional);
  EXPECT_EQ(read.benchmarks[0].value, 237.33);
  EXPECT_EQ(read.benchmarks[0].dataset, "paper");
}

TEST_F(Curricula, PublishedTwiceAreStoredOnceAndNeverChange) {
  const CurriculumVersion first = publish(basics("1.0.0", {linear}));
  const CurriculumVersion again = publish(basics("1.0.0", {linear}));
  EXPECT_EQ(again.row_id, first.row_id);
  EXPECT_EQ(again.exercises[0].id, first.exercises[0].id);
  CurriculumVersion changed = basics("1.0.0", {linear});
  changed.sha256 = "another";
  EXPECT_EQ(publish_curriculum(*store_, changed, "system").error().code, ErrorCode::conflict);
  EXPECT_EQ(curriculum_versions(*store_)->size(), 1u);
  EXPECT_EQ(audit_log(*store_, 10)->size(), 1u);
}

TEST_F(Curricula, TheNewestPublishedVersionCounts) {
  const CurriculumVersion first = publish(basics("1.0.0", {linear, rotational}));
  EXPECT_EQ(current_exercise(*store_, "vascular-basics", "rotational")->id, first.exercises[1].id);
  const CurriculumVersion second = publish(basics("1.1.0", {linear}));
  CurriculumVersion draft = basics("2.0.0", {rotational});
  draft.status = "draft";
  publish(draft);
  EXPECT_EQ(current_curriculum(*store_, "vascular-basics")->version, "1.1.0");
  EXPECT_EQ(current_exercise(*store_, "vascular-basics", "linear")->id, second.exercises[0].id);
  // the newest version has dropped it; the text of the old one is kept
  EXPECT_EQ(current_exercise(*store_, "vascular-basics", "rotational").error().code,
            ErrorCode::not_found);
  EXPECT_EQ(exercise_version(*store_, first.exercises[1].id)->yaml, "id: rotational\n");
}

TEST_F(Curricula, AnExerciseOfOneIdInTwoCurriculaIsOneOfEach) {
  const CurriculumVersion first = publish(basics("1.0.0", {linear}));
  CurriculumVersion other = basics("1.0.0", {linear});
  other.curriculum_id = "our-own";
  const CurriculumVersion second = publish(other);
  EXPECT_EQ(current_exercise(*store_, "vascular-basics", "linear")->id, first.exercises[0].id);
  EXPECT_EQ(current_exercise(*store_, "our-own", "linear")->id, second.exercises[0].id);
  EXPECT_EQ(*current_curriculum_sha256(*store_, "our-own"), other.sha256);
  EXPECT_EQ(current_curriculum_sha256(*store_, "none").error().code, ErrorCode::not_found);
}

TEST_F(Curricula, ADraftIsPublishedLaterWithTheSameText) {
  CurriculumVersion draft = basics("2.0.0", {rotational});
  draft.status = "draft";
  const CurriculumVersion stored = publish(draft);
  EXPECT_TRUE(stored.published_utc.empty());
  publish(basics("2.1.0", {linear}));
  draft.status = "published";
  EXPECT_EQ(publish(draft).row_id, stored.row_id);
  EXPECT_EQ(current_curriculum(*store_, "vascular-basics")->version, "2.0.0");
}

TEST_F(Curricula, UnknownOnesAreNotFound) {
  const std::string anna = add_trainee(*store_, "anna").id;
  EXPECT_EQ(current_curriculum(*store_, "none").error().code, ErrorCode::not_found);
  EXPECT_EQ(current_exercise(*store_, "vascular-basics", "none").error().code,
            ErrorCode::not_found);
  EXPECT_EQ(exercise_version(*store_, "none").error().code, ErrorCode::not_found);
  EXPECT_EQ(enrol(*store_, anna, "none").error().code, ErrorCode::not_found);
  publish(basics("1.0.0", {linear}));
  EXPECT_EQ(enrol(*store_, "nobody", "vascular-basics").error().code, ErrorCode::not_found);
}

TEST_F(Curricula, WithAWrongStatusOrUnreadableTextAreRefused) {
  CurriculumVersion version = basics("1.0.0", {linear});
  version.status = "secret";
  EXPECT_EQ(publish_curriculum(*store_, version, "system").error().code, ErrorCode::invalid_input);
  version = basics("1.0.0", {linear});
  version.yaml = "\xff";
  EXPECT_EQ(publish_curriculum(*store_, version, "system").error().code, ErrorCode::invalid_input);
  version = basics("1.0.0", {linear, linear});
  EXPECT_EQ(publish_curriculum(*store_, version, "system").error().code, ErrorCode::conflict);
  EXPECT_TRUE(curriculum_versions(*store_)->empty());
}

TEST_F(Curricula, EnrollingTwiceGivesTheSameEnrolment) {
  publish(basics("1.0.0", {linear}));
  const std::string anna = add_trainee(*store_, "anna").id;
  const std::string bob = add_trainee(*store_, "bob").id;
  const auto first = enrol(*store_, anna, "vascular-basics");
  ASSERT_TRUE(first);
  publish(basics("1.1.0", {linear}));
  EXPECT_EQ(*enrol(*store_, anna, "vascular-basics"), *first);
  EXPECT_NE(*enrol(*store_, bob, "vascular-basics"), *first);
}

}  // namespace
}  // namespace database_test
