#include "database/training_by.h"

#include <gtest/gtest.h>

#include "database/audit.h"
#include "database/curricula.h"
#include "tests/database/temporary_store.h"

namespace database_test {
namespace {

using base::ErrorCode;

class TrainingBy : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::unique_ptr<database::Store> store_ = open_store(folder_.url());
  std::string anna_ = add_trainee(*store_, "anna").id;

  void publish(const std::string& id, const std::string& version = "1.0.0",
               const std::string& published_utc = "") {
    database::CurriculumVersion curriculum;
    curriculum.curriculum_id = id;
    curriculum.version = version;
    curriculum.sha256 = id + version;
    curriculum.yaml = "id: " + id + "\n";
    curriculum.status = "published";
    curriculum.published_utc = published_utc;
    curriculum.exercises = {{"", "linear", 1, "id: linear\n"}};
    const auto published = publish_curriculum(*store_, curriculum, "system");
    EXPECT_TRUE(published) << (published ? "" : published.error().message);
  }

  std::string trains_by(const std::string& person_id) {
    const auto id = curriculum_of(*store_, person_id);
    return id ? *id : "error: " + id.error().message;
  }

  int audit_rows() { return static_cast<int>(audit_log(*store_, 1000)->size()); }
};

TEST_F(TrainingBy, NothingIsFoundBeforeSomethingIsPublished) {
  EXPECT_EQ(curriculum_of(*store_, anna_).error().code, ErrorCode::not_found);
  EXPECT_EQ(default_curriculum(*store_).error().code, ErrorCode::not_found);
  EXPECT_EQ(set_default_curriculum(*store_, "basics", "system").error().code, ErrorCode::not_found);
}

TEST_F(TrainingBy, TheOnlyCurriculumIsEverybodys) {
  publish("basics");
  EXPECT_EQ(trains_by(anna_), "basics");
  EXPECT_EQ(*default_curriculum(*store_), "basics");
  EXPECT_EQ(curriculum_of(*store_, "nobody").error().code, ErrorCode::not_found);
}

TEST_F(TrainingBy, PublishingAnotherCurriculumChangesNobodysTraining) {
  publish("basics");
  publish("our-own");
  publish("our-own", "1.1.0");
  EXPECT_EQ(trains_by(anna_), "basics");
  EXPECT_EQ(*default_curriculum(*store_), "basics");
}

TEST_F(TrainingBy, TheDefaultIsTheOneThatWasChosen) {
  publish("basics");
  publish("our-own");
  ASSERT_TRUE(set_default_curriculum(*store_, "our-own", anna_));
  EXPECT_EQ(trains_by(anna_), "our-own");
  const database::AuditRow row = audit_log(*store_, 1)->front();
  EXPECT_EQ(row.action, "site.default_curriculum");
  EXPECT_EQ(row.actor, anna_);
  EXPECT_NE(row.before_hash, row.after_hash);
  EXPECT_TRUE(verify_audit(*store_));
}

TEST_F(TrainingBy, AnAssignmentComesBeforeTheDefaultAndCanBeTakenBack) {
  publish("basics");
  publish("our-own");
  const std::string bob = add_trainee(*store_, "bob").id;
  ASSERT_TRUE(assign_curriculum(*store_, anna_, "our-own", "system"));
  EXPECT_EQ(trains_by(anna_), "our-own");
  EXPECT_EQ(trains_by(bob), "basics");
  EXPECT_EQ(*assigned_curriculum(*store_, anna_), "our-own");
  EXPECT_EQ(*assigned_curriculum(*store_, bob), std::nullopt);
  const auto all = assigned_curricula(*store_);
  ASSERT_EQ(all->size(), 1u);
  EXPECT_EQ(all->at(anna_), "our-own");

  ASSERT_TRUE(set_default_curriculum(*store_, "our-own", "system"));
  ASSERT_TRUE(assign_curriculum(*store_, anna_, "basics", "system"));
  EXPECT_EQ(trains_by(anna_), "basics");
  ASSERT_TRUE(assign_curriculum(*store_, anna_, std::nullopt, "system"));
  EXPECT_EQ(trains_by(anna_), "our-own");
  EXPECT_TRUE(assigned_curricula(*store_)->empty());
}

TEST_F(TrainingBy, AssigningIsAuditedAndAssigningTheSameAgainIsNot) {
  publish("basics");
  const int before = audit_rows();
  ASSERT_TRUE(assign_curriculum(*store_, anna_, "basics", "system"));
  ASSERT_TRUE(assign_curriculum(*store_, anna_, "basics", "system"));
  EXPECT_EQ(audit_rows(), before + 1);
  const database::AuditRow row = audit_log(*store_, 1)->front();
  EXPECT_EQ(row.action, "person.curriculum");
  EXPECT_EQ(row.object, "person:" + anna_);
  EXPECT_EQ(row.before_hash, "");
  EXPECT_NE(row.after_hash, "");
  ASSERT_TRUE(assign_curriculum(*store_, anna_, std::nullopt, "system"));
  EXPECT_EQ(audit_rows(), before + 2);
  EXPECT_TRUE(verify_audit(*store_));
}

TEST_F(TrainingBy, WhatDoesNotExistIsRefusedAndNothingIsWritten) {
  publish("basics");
  EXPECT_EQ(assign_curriculum(*store_, anna_, "none", "system").error().code, ErrorCode::not_found);
  EXPECT_EQ(assign_curriculum(*store_, "nobody", "basics", "system").error().code,
            ErrorCode::not_found);
  EXPECT_EQ(assign_curriculum(*store_, anna_, "", "system").error().code, ErrorCode::invalid_input);
  EXPECT_EQ(assigned_curriculum(*store_, "nobody").error().code, ErrorCode::not_found);
  EXPECT_TRUE(assigned_curricula(*store_)->empty());
}

TEST_F(TrainingBy, ATrialOfAnotherCurriculumIsNotAmongThoseOfThisOne) {
  publish("basics");
  publish("our-own");
  const auto begin_under = [&](const std::string& curriculum) {
    database::NewTrial trial = new_trial_of(anna_);
    if (!curriculum.empty()) trial.enrolment_id = *enrol(*store_, anna_, curriculum);
    EXPECT_TRUE(begin_trial(*store_, trial));
    EXPECT_TRUE(finish_trial(*store_, trial.id, passed_in(60.0), {}, {}));
    return trial.id;
  };
  const std::string of_basics = begin_under("basics");
  const std::string of_our_own = begin_under("our-own");
  const std::string of_none = begin_under("");

  database::TrialFilter filter;
  filter.person_id = anna_;
  ASSERT_EQ(trials(*store_, filter)->size(), 3u);
  EXPECT_EQ(trials(*store_, filter)->at(0).curriculum_id, "basics");
  EXPECT_EQ(trials(*store_, filter)->at(2).curriculum_id, "");
  filter.curriculum_id = "our-own";
  const auto found = trials(*store_, filter);
  ASSERT_EQ(found->size(), 2u);
  EXPECT_EQ(found->at(0).head.id, of_our_own);
  EXPECT_EQ(found->at(1).head.id, of_none);
  EXPECT_EQ(found->at(0).metrics.size(), 1u);  // read by a query of their own
}

}  // namespace
}  // namespace database_test
