#include <gtest/gtest.h>

#include "app/server/throttle.h"

namespace app {
namespace {

TEST(FailureThrottle, WaitsOnlyAfterTheFreeFailures) {
  FailureThrottle throttle(3);
  throttle.failed("ann", 0.0);
  throttle.failed("ann", 1.0);
  EXPECT_EQ(throttle.wait("ann", 1.0), 0.0);
  throttle.failed("ann", 2.0);
  EXPECT_DOUBLE_EQ(throttle.wait("ann", 2.0), 15.0);
  EXPECT_DOUBLE_EQ(throttle.wait("ann", 10.0), 7.0);
  EXPECT_EQ(throttle.wait("ann", 17.0), 0.0);
}

TEST(FailureThrottle, EachFurtherFailureDoublesTheWaitUpTo15Minutes) {
  FailureThrottle throttle(1);
  const double waits[] = {15, 30, 60, 120, 240, 480, 900, 900};
  for (const double wait : waits) {
    throttle.failed("ann", 0.0);
    EXPECT_DOUBLE_EQ(throttle.wait("ann", 0.0), wait);
  }
}

TEST(FailureThrottle, KeysDoNotAffectEachOtherAndSuccessForgets) {
  FailureThrottle throttle(1);
  throttle.failed("ann", 0.0);
  EXPECT_EQ(throttle.wait("ben", 0.0), 0.0);
  throttle.succeeded("ann");
  EXPECT_EQ(throttle.wait("ann", 0.0), 0.0);
}

TEST(FailureThrottle, AnHourWithoutFailureForgets) {
  FailureThrottle throttle(2);
  throttle.failed("ann", 0.0);
  throttle.failed("ann", 3700.0);
  EXPECT_EQ(throttle.wait("ann", 3700.0), 0.0);
}

TEST(RequestThrottle, AllowsABurstAndThenTheRate) {
  RequestThrottle throttle(2.0);  // a burst of 20
  int admitted = 0;
  for (int i = 0; i < 100; ++i) admitted += throttle.admit("a", 0.0) ? 1 : 0;
  EXPECT_EQ(admitted, 20);
  admitted = 0;
  for (int i = 0; i < 100; ++i) admitted += throttle.admit("a", 1.0) ? 1 : 0;
  EXPECT_EQ(admitted, 2);
  EXPECT_TRUE(throttle.admit("b", 1.0));
}

}  // namespace
}  // namespace app
