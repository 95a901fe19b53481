#include "curricula/copy.h"

#include <string>

#include <gtest/gtest.h>

#include "curricula/check.h"
#include "tests/curricula/valid_curriculum.h"

namespace {

using curricula::check;
using curricula::copy_as_draft;
using test::replaced;
using test::small_catalogue;
using test::valid_curriculum;

TEST(CopyAsDraft, ChangesThreeWordsAndNothingElse) {
  const std::string text = "# a comment to keep\n" + valid_curriculum();
  const auto source = check(text, small_catalogue()).curriculum;
  ASSERT_TRUE(source.has_value());

  const auto copy = copy_as_draft(*source, "mine");

  ASSERT_TRUE(copy.has_value()) << copy.error().message;
  std::string expected = replaced(text, "id: small", "id: mine");
  expected = replaced(expected, "version: 1.2.0", "version: 1.0.0");
  expected = replaced(expected, "status: published", "status: draft");
  EXPECT_EQ(*copy, expected);
  EXPECT_TRUE(check(*copy, small_catalogue()).ok());
}

TEST(CopyAsDraft, FindsTheWordsInQuotesToo) {
  const auto source = check(replaced(valid_curriculum(), "id: small", "id: 'small'   # named so"),
                            small_catalogue())
                          .curriculum;
  ASSERT_TRUE(source.has_value());
  const auto copy = copy_as_draft(*source, "mine");
  ASSERT_TRUE(copy.has_value());
  EXPECT_NE(copy->find("\nid: mine   # named so\n"), std::string::npos);
}

TEST(CopyAsDraft, RefusesAnIdThatIsNoneOrTaken) {
  const auto source = check(valid_curriculum(), small_catalogue()).curriculum;
  ASSERT_TRUE(source.has_value());
  EXPECT_EQ(copy_as_draft(*source, "Not An Id").error().code, base::ErrorCode::invalid_input);
  EXPECT_EQ(copy_as_draft(*source, "").error().code, base::ErrorCode::invalid_input);
  EXPECT_EQ(copy_as_draft(*source, "small").error().code, base::ErrorCode::invalid_input);
}

TEST(CopyAsDraft, SaysWhenTheTextIsNotACurriculum) {
  curricula::Curriculum source;
  source.id = "odd";
  source.yaml = "[1, 2";
  EXPECT_EQ(copy_as_draft(source, "mine").error().code, base::ErrorCode::corrupt_data);
}

}  // namespace
