#include "curricula/nearest.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace {

using curricula::nearest;

const std::vector<std::string> kWords = {"time_s", "force_max_n", "wall_hits"};

TEST(Nearest, FindsTheWordMeant) {
  EXPECT_EQ(nearest("tim_s", kWords), "time_s");
  EXPECT_EQ(nearest("force_n_max", kWords), "");  // four errors in eleven letters are too many
  EXPECT_EQ(nearest("wallhits", kWords), "wall_hits");
}

TEST(Nearest, DoesNotGuessWildly) {
  EXPECT_EQ(nearest("colour", kWords), "");
  EXPECT_EQ(nearest("", kWords), "");
  EXPECT_EQ(nearest("x", std::vector<std::string>{"y"}), "");  // nothing in common
  EXPECT_EQ(nearest(std::string(100000, 'a'), kWords), "");
}

TEST(Nearest, PrefersTheFirstOfTwoAsNear) {
  EXPECT_EQ(nearest("cat", std::vector<std::string>{"hat", "bat"}), "hat");
}

}  // namespace
