#include "curricula/semantic_version.h"

#include <gtest/gtest.h>

namespace {

using curricula::parse_version;
using curricula::SemanticVersion;

TEST(SemanticVersion, ReadsThreeNumbers) {
  EXPECT_EQ(parse_version("1.20.3"), (SemanticVersion{1, 20, 3}));
  EXPECT_EQ(curricula::version_text({1, 20, 3}), "1.20.3");
}

TEST(SemanticVersion, RefusesEverythingElse) {
  for (const char* text :
       {"", "1", "1.0", "1.0.0.0", "1.0.", "v1.0.0", "1.0.0-rc", "-1.0.0", "+1.0.0", "01.0.0",
        "1.0.00", "1.0.9999999", "1.0.99999999999999999999", " 1.0.0", "1.a.0"}) {
    EXPECT_FALSE(parse_version(text).has_value()) << text;
  }
}

TEST(SemanticVersion, OrdersByNumberAndNotByText) {
  EXPECT_LT(*parse_version("1.9.0"), *parse_version("1.10.0"));
  EXPECT_LT(*parse_version("9.0.0"), *parse_version("10.0.0"));
}

}  // namespace
