#include <gtest/gtest.h>

#include "database/people.h"
#include "tests/database/temporary_store.h"

namespace database_test {
namespace {

using base::ErrorCode;
using database::WebSession;

constexpr const char* kPast = "2020-01-01T00:00:00.000Z";
constexpr const char* kFuture = "2999-01-01T00:00:00.000Z";

class SignIn : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::unique_ptr<database::Store> store_ = open_store(folder_.url());
  std::string anna_ = add_trainee(*store_, "anna").id;
};

TEST_F(SignIn, ASetUpLinkWorksOnce) {
  ASSERT_TRUE(add_setup_token(*store_, "hash", kFuture));
  EXPECT_FALSE(*use_setup_token(*store_, "other"));
  EXPECT_TRUE(*use_setup_token(*store_, "hash"));
  EXPECT_FALSE(*use_setup_token(*store_, "hash"));
  EXPECT_EQ(add_setup_token(*store_, "hash", kFuture).error().code, ErrorCode::conflict);
}

TEST_F(SignIn, ASetUpLinkExpires) {
  ASSERT_TRUE(add_setup_token(*store_, "hash", kPast));
  EXPECT_FALSE(*use_setup_token(*store_, "hash"));
  EXPECT_EQ(add_setup_token(*store_, "second", "tomorrow").error().code, ErrorCode::invalid_input);
}

TEST_F(SignIn, ASessionIsReadAsItWasAdded) {
  ASSERT_TRUE(add_web_session(*store_, "hash", {anna_, "csrf", kPast, kPast}));
  const auto session = web_session(*store_, "hash");
  ASSERT_TRUE(session);
  EXPECT_EQ(session->person_id, anna_);
  EXPECT_EQ(session->csrf_token, "csrf");
  EXPECT_EQ(session->created_utc, kPast);
  EXPECT_EQ(session->last_seen_utc, kPast);
  ASSERT_TRUE(touch_web_session(*store_, "hash"));
  EXPECT_GT(web_session(*store_, "hash")->last_seen_utc, kPast);
  EXPECT_EQ(web_session(*store_, "hash")->created_utc, kPast);
}

TEST_F(SignIn, ASessionBelongsToSomebody) {
  EXPECT_EQ(add_web_session(*store_, "hash", {"nobody", "csrf", "", ""}).error().code,
            ErrorCode::not_found);
}

TEST_F(SignIn, ASessionEnds) {
  ASSERT_TRUE(add_web_session(*store_, "one", {anna_, "csrf", "", ""}));
  ASSERT_TRUE(add_web_session(*store_, "two", {anna_, "csrf", "", ""}));
  ASSERT_TRUE(end_web_session(*store_, "one"));
  EXPECT_EQ(web_session(*store_, "one").error().code, ErrorCode::not_found);
  EXPECT_EQ(touch_web_session(*store_, "one").error().code, ErrorCode::not_found);
  EXPECT_TRUE(web_session(*store_, "two"));
  ASSERT_TRUE(end_web_sessions_of(*store_, anna_));
  EXPECT_FALSE(web_session(*store_, "two"));
}

TEST_F(SignIn, DisablingSomebodyEndsTheirSessions) {
  const std::string bob = add_trainee(*store_, "bob").id;
  ASSERT_TRUE(add_web_session(*store_, "annas", {anna_, "csrf", "", ""}));
  ASSERT_TRUE(add_web_session(*store_, "bobs", {bob, "csrf", "", ""}));
  ASSERT_TRUE(set_disabled(*store_, anna_, true, "system"));
  EXPECT_FALSE(web_session(*store_, "annas"));
  EXPECT_TRUE(web_session(*store_, "bobs"));
}

TEST_F(SignIn, ExpiredSessionsAreRemoved) {
  ASSERT_TRUE(add_web_session(*store_, "old", {anna_, "csrf", kPast, ""}));
  ASSERT_TRUE(add_web_session(*store_, "new", {anna_, "csrf", "", ""}));
  EXPECT_EQ(*end_web_sessions_before(*store_, "2020-01-01T00:00:01Z"), 1);
  EXPECT_FALSE(web_session(*store_, "old"));
  EXPECT_TRUE(web_session(*store_, "new"));
}

}  // namespace
}  // namespace database_test
