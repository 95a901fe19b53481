#include <gtest/gtest.h>
#include <sodium.h>

#include "app/server/passwords.h"

namespace app {
namespace {

TEST(Passwords, HashIsArgon2idWithAtLeast19MiBAndTwoPasses) {
  const auto phc = hash_password("correct horse battery");
  ASSERT_TRUE(phc);
  // the parameters stand in the PHC text: m in KiB
  EXPECT_EQ(phc->rfind("$argon2id$v=19$m=19456,t=2,p=1$", 0), 0U) << *phc;
}

TEST(Passwords, OnlyTheRightPasswordVerifies) {
  const auto phc = hash_password("correct horse battery");
  ASSERT_TRUE(phc);
  EXPECT_TRUE(verify_password(*phc, "correct horse battery"));
  EXPECT_FALSE(verify_password(*phc, "correct horse batterx"));
  EXPECT_FALSE(verify_password(*phc, ""));
}

TEST(Passwords, TheSamePasswordHashesDifferentlyEachTime) {
  const auto first = hash_password("correct horse battery");
  const auto second = hash_password("correct horse battery");
  ASSERT_TRUE(first && second);
  EXPECT_NE(*first, *second);
}

TEST(Passwords, AnEmptyOrUnreadableHashVerifiesNothing) {
  EXPECT_FALSE(verify_password("", ""));
  EXPECT_FALSE(verify_password("plain text", "plain text"));
}

TEST(Passwords, WeakerParametersNeedARehash) {
  char weak[crypto_pwhash_STRBYTES];
  ASSERT_EQ(crypto_pwhash_str_alg(weak, "x", 1, 1, 8192 * 1024, crypto_pwhash_ALG_ARGON2ID13), 0);
  EXPECT_TRUE(needs_rehash(weak));
  const auto today = hash_password("correct horse battery");
  ASSERT_TRUE(today);
  EXPECT_FALSE(needs_rehash(*today));
}

TEST(Passwords, EightTo128CharactersAreAccepted) {
  EXPECT_FALSE(check_new_password("v7#kq2z", "ann"));
  EXPECT_TRUE(check_new_password("v7#kq2zp", "ann"));
  std::string longest;
  while (longest.size() < 128) longest += "ab3x";
  EXPECT_TRUE(check_new_password(longest, "ann"));
  EXPECT_FALSE(check_new_password(longest + "y", "ann"));
}

TEST(Passwords, CharactersAreCountedNotBytes) {
  // seven letters of two bytes each are still seven
  EXPECT_FALSE(check_new_password("äöüäöüä", "ann"));
  EXPECT_TRUE(check_new_password("äöüäöüäö", "ann"));
}

TEST(Passwords, CommonOnesAndTheNameAreRefused) {
  for (const char* common : {"password", "PassWord1", "12345678", "qwertyuiop", "aaaaaaaaaa"}) {
    const auto checked = check_new_password(common, "ann");
    ASSERT_FALSE(checked) << common;
    EXPECT_EQ(checked.error().code, base::ErrorCode::invalid_input);
  }
  EXPECT_FALSE(check_new_password("Annabella", "annabella"));
}

}  // namespace
}  // namespace app
