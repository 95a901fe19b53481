#include "database/audit.h"

#include <gtest/gtest.h>

#include "tests/database/temporary_store.h"

namespace database_test {
namespace {

using base::ErrorCode;

class Audit : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::unique_ptr<database::Store> store_ = open_store(folder_.url());

  void SetUp() override {
    for (const char* name : {"anna", "bob", "carl", "dora", "emil"}) add_trainee(*store_, name);
  }
  void tamper(const std::string& statements) { RawFile(folder_.file("store.db")).run(statements); }
  void expect_found(const std::string& words) {
    const base::Status status = verify_audit(*store_);
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().code, ErrorCode::corrupt_data);
    EXPECT_NE(status.error().message.find(words), std::string::npos) << status.error().message;
  }
};

TEST_F(Audit, IsAChainOfWhatWasDone) {
  const std::string anna = person_by_name(*store_, "anna")->id;
  ASSERT_TRUE(set_disabled(*store_, anna, true, "boss"));
  EXPECT_TRUE(verify_audit(*store_));
  const auto log = audit_log(*store_, 100);
  ASSERT_TRUE(log);
  ASSERT_EQ(log->size(), 6u);
  const database::AuditRow& last = (*log)[0];
  EXPECT_EQ(last.seq, 6);
  EXPECT_EQ(last.actor, "boss");
  EXPECT_EQ(last.action, "person.disable");
  EXPECT_EQ(last.object, "person:" + anna);
  EXPECT_EQ(last.prev_hash, (*log)[1].hash);
  EXPECT_EQ(last.before_hash, (*log)[5].after_hash);  // as anna was added
  EXPECT_NE(last.before_hash, last.after_hash);
  EXPECT_EQ((*log)[5].prev_hash, "");
  EXPECT_EQ((*log)[5].before_hash, "");
  EXPECT_EQ(*audit_head(*store_), "6 " + last.hash);
  EXPECT_EQ(audit_log(*store_, 2)->size(), 2u);
  EXPECT_TRUE(audit_log(*store_, 0)->empty());
}

TEST_F(Audit, TheSameChangeBackGivesTheSameHash) {
  const std::string anna = person_by_name(*store_, "anna")->id;
  ASSERT_TRUE(set_disabled(*store_, anna, true, "boss"));
  ASSERT_TRUE(set_disabled(*store_, anna, false, "boss"));
  const auto log = audit_log(*store_, 2);
  EXPECT_EQ((*log)[0].after_hash, (*log)[1].before_hash);
}

TEST_F(Audit, AChangeThatFailsLeavesNoRow) {
  database::NewPerson taken;
  taken.name = "anna";
  EXPECT_FALSE(add_person(*store_, taken, "system"));
  EXPECT_FALSE(set_disabled(*store_, "nobody", true, "system"));
  EXPECT_EQ(audit_log(*store_, 100)->size(), 5u);
}

TEST_F(Audit, EveryColumnIsProtected) {
  for (const char* column :
       {"utc", "actor", "action", "object", "before_hash", "after_hash", "prev_hash"}) {
    tamper(
        "CREATE TABLE kept AS SELECT * FROM audit;"
        "UPDATE audit SET " +
        std::string(column) + " = 'forged' WHERE seq = 3");
    expect_found("row 3 ");
    tamper("DELETE FROM audit; INSERT INTO audit SELECT * FROM kept; DROP TABLE kept");
    EXPECT_TRUE(verify_audit(*store_));
  }
}

TEST_F(Audit, ARemovedRowIsFoundWhereverItWas) {
  tamper("CREATE TABLE kept AS SELECT * FROM audit");
  for (int seq = 1; seq <= 5; ++seq) {
    tamper("DELETE FROM audit WHERE seq = " + std::to_string(seq));
    expect_found("row " + std::to_string(seq) + " was removed");
    tamper("DELETE FROM audit; INSERT INTO audit SELECT * FROM kept");
  }
  tamper("DELETE FROM audit");
  expect_found("row 1 was removed");
}

TEST_F(Audit, RowsClosedUpAfterARemovalAreFound) {
  tamper("DELETE FROM audit WHERE seq = 3; UPDATE audit SET seq = seq - 1 WHERE seq > 3");
  expect_found("row 3 ");
}

TEST_F(Audit, ReorderedRowsAreFound) {
  tamper(
      "UPDATE audit SET seq = 100 WHERE seq = 2; UPDATE audit SET seq = 2 WHERE seq = 4;"
      "UPDATE audit SET seq = 4 WHERE seq = 100");
  expect_found("row 2 ");
}

TEST_F(Audit, AnAddedRowIsFound) {
  tamper(
      "INSERT INTO audit SELECT 6, utc, actor, action, object, before_hash, after_hash, "
      "hash, hash FROM audit WHERE seq = 5");
  expect_found("row 6 ");
}

TEST_F(Audit, ARowThatCarriesAHashOfItsOwnStillBreaksTheChain) {
  // a forger who takes over all of a row that is consistent in itself: the same row of another log
  TemporaryFolder other_folder;
  auto other = open_store(other_folder.url());
  for (const char* name : {"1", "2", "3", "4", "5"}) add_trainee(*other, name);
  tamper("ATTACH '" + other_folder.file("store.db") +
         "' AS other;"
         "DELETE FROM audit WHERE seq = 3;"
         "INSERT INTO audit SELECT * FROM other.audit WHERE seq = 3");
  expect_found("row 3 ");
  tamper("ATTACH '" + other_folder.file("store.db") +
         "' AS other;"
         "DELETE FROM audit; INSERT INTO audit SELECT * FROM other.audit");
  expect_found("row 5 ");
}

}  // namespace
}  // namespace database_test
