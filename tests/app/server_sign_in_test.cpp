#include <cstring>

#include <gtest/gtest.h>
#include <sodium.h>

#include "app/server/setup_link.h"
#include "tests/app/server_fixture.h"

namespace app::test {
namespace {

Answer try_to_sign_in(Client client, const std::string& name, const std::string& password) {
  return client.post("/api/session", {{"name", name}, {"password", password}});
}

TEST(SignIn, TheRightPasswordOpensASession) {
  RunningServer running;
  Client client = running.client();
  const Answer answer = client.post("/api/session", {{"name", "ann"}, {"password", kPassword}});
  ASSERT_EQ(answer.status, 200) << answer.body;
  EXPECT_EQ(answer.json()["name"], "ann");
  EXPECT_EQ(answer.json()["role"], "trainee");
  EXPECT_EQ(answer.json()["person_id"], running.workplace.id_of("ann"));

  client.cookie = answer.header("set-cookie").substr(0, answer.header("set-cookie").find(';'));
  const Answer session = client.get("/api/session");
  EXPECT_EQ(session.status, 200);
  EXPECT_EQ(session.json()["csrf"], answer.json()["csrf"]);
}

TEST(SignIn, TheCookieIsOutOfReachOfScriptsAndOtherSites) {
  RunningServer running;
  const Answer answer = try_to_sign_in(running.client(), "ann", kPassword);
  const std::string cookie = answer.header("set-cookie");
  EXPECT_NE(cookie.find("; HttpOnly"), std::string::npos) << cookie;
  EXPECT_NE(cookie.find("; SameSite=Strict"), std::string::npos);
  EXPECT_NE(cookie.find("; Path=/"), std::string::npos);
  EXPECT_EQ(cookie.find("Domain"), std::string::npos);
  // 128 bits are 22 characters of base64; the name and "=" take 9
  EXPECT_GE(cookie.find(';'), 9U + 22U);
}

TEST(SignIn, BehindAProxyTheCookieIsSecureAndBoundToTheHost) {
  RunningServer running([](ServerOptions& options) { options.behind_proxy = true; });
  const Answer answer = try_to_sign_in(running.client(), "ann", kPassword);
  const std::string cookie = answer.header("set-cookie");
  EXPECT_EQ(cookie.rfind("__Host-cathedra=", 0), 0U) << cookie;
  EXPECT_NE(cookie.find("; Secure"), std::string::npos);
  EXPECT_NE(answer.header("strict-transport-security"), "");
}

TEST(SignIn, AWrongPasswordAndAnUnknownNameGetTheSameAnswer) {
  RunningServer running;
  const Answer wrong = try_to_sign_in(running.client(), "ann", "not the password");
  const Answer unknown = try_to_sign_in(running.client(), "nobody", "not the password");
  EXPECT_EQ(wrong.status, 401);
  EXPECT_EQ(unknown.status, 401);
  EXPECT_EQ(wrong.body, unknown.body);
  EXPECT_EQ(wrong.header("set-cookie"), "");
}

TEST(SignIn, DisabledAndPublishedPeopleCannotSignIn) {
  RunningServer running;
  Workplace& workplace = running.workplace;
  ASSERT_TRUE(database::set_disabled(workplace.store(), workplace.id_of("ann"), true, "system"));
  EXPECT_EQ(try_to_sign_in(running.client(), "ann", kPassword).status, 401);
  EXPECT_EQ(try_to_sign_in(running.client(), "no.1", "").status, 401);
}

TEST(SignIn, ManyFailuresForANameAreThrottledEvenWithTheRightPassword) {
  RunningServer running;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(try_to_sign_in(running.client(), "ann", "wrong one").status, 401);
  }
  const Answer throttled = try_to_sign_in(running.client(), "ann", kPassword);
  EXPECT_EQ(throttled.status, 429);
  EXPECT_NE(throttled.header("retry-after"), "");
  // and the throttle does not tell names apart either
  EXPECT_EQ(try_to_sign_in(running.client(), "ben", kPassword).status, 200);
}

TEST(SignIn, EachSignInIsANewSessionAndEndsTheOneBefore) {
  RunningServer running;
  Client client = running.client_of("ann");
  const std::string before = client.cookie;
  client.sign_in("ann");
  EXPECT_NE(client.cookie, before);
  Client old = running.client();
  old.cookie = before;
  EXPECT_EQ(old.get("/api/session").status, 401);
}

TEST(SignIn, SigningOutEndsTheSessionOnTheServer) {
  RunningServer running;
  Client client = running.client_of("ann");
  const Answer out = client.send("DELETE", "/api/session");
  EXPECT_EQ(out.status, 204);
  EXPECT_NE(out.header("set-cookie").find("Max-Age=0"), std::string::npos);
  EXPECT_EQ(client.get("/api/session").status, 401);
}

TEST(SignIn, ASessionEndsWhenItsPersonIsDisabled) {
  RunningServer running;
  Client client = running.client_of("ann");
  Workplace& workplace = running.workplace;
  ASSERT_TRUE(database::set_disabled(workplace.store(), workplace.id_of("ann"), true, "system"));
  EXPECT_EQ(client.get("/api/session").status, 401);
}

TEST(SignIn, IdleAndAbsoluteLimitsEndASession) {
  // a negative limit has always passed already
  RunningServer idle([](ServerOptions& options) { options.session_idle_s = -1.0; });
  EXPECT_EQ(idle.client_of("ann").get("/api/session").status, 401);
  RunningServer absolute([](ServerOptions& options) { options.session_absolute_s = -1.0; });
  EXPECT_EQ(absolute.client_of("ann").get("/api/session").status, 401);
}

TEST(SignIn, AForgedCookieOpensNothing) {
  RunningServer running;
  Client client = running.client();
  client.cookie = "cathedra=AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA";
  EXPECT_EQ(client.get("/api/session").status, 401);
}

TEST(SignIn, FromAnotherSiteIsRefused) {
  RunningServer running;
  const nlohmann::json body{{"name", "ann"}, {"password", kPassword}};
  Client client = running.client();
  EXPECT_EQ(
      client.send("POST", "/api/session", body.dump(), {{"Origin", "http://evil.example"}}).status,
      403);
  EXPECT_EQ(
      client.send("POST", "/api/session", body.dump(), {{"Sec-Fetch-Site", "cross-site"}}).status,
      403);
  // a form cannot declare JSON
  EXPECT_EQ(
      client.send("POST", "/api/session", body.dump(), {{"Content-Type", "text/plain"}}).status,
      400);
}

TEST(SignIn, APasswordOfWeakerParametersIsHashedAgain) {
  RunningServer running;
  Workplace& workplace = running.workplace;
  char weak[crypto_pwhash_STRBYTES];
  ASSERT_EQ(crypto_pwhash_str_alg(weak, kPassword, std::strlen(kPassword), 1, 8192 * 1024,
                                  crypto_pwhash_ALG_ARGON2ID13),
            0);
  const std::string ann = workplace.id_of("ann");
  ASSERT_TRUE(database::set_password(workplace.store(), ann, weak, "system"));
  running.client_of("ann");
  const auto after = database::person_by_id(workplace.store(), ann);
  ASSERT_TRUE(after);
  EXPECT_EQ(after->password_phc.rfind("$argon2id$v=19$m=19456,t=2,p=1$", 0), 0U);
  running.client_of("ann");  // and still opens
}

TEST(Csrf, AChangeWithoutTheSessionsTokenIsRefused) {
  RunningServer running;
  Client client = running.client_of("ann");
  Client other = running.client_of("ben");
  const std::string own = client.csrf;
  for (const std::string& token : {std::string(), std::string("x"), other.csrf}) {
    client.csrf = token;
    EXPECT_EQ(client.send("DELETE", "/api/session").status, 403) << token;
    EXPECT_EQ(
        client.post("/api/trials", {{"exercise_id", "linear"}, {"device", "keyboard"}}).status,
        403);
  }
  client.csrf = own;
  EXPECT_EQ(client.send("DELETE", "/api/session").status, 204);
}

nlohmann::json setup_body(const std::string& token, const std::string& name,
                          const std::string& password) {
  return {{"token", token}, {"name", name}, {"password", password}};
}

std::string make_token(RunningServer& running) {
  const auto token = make_setup_token(running.workplace.store());
  return token ? *token : std::string{};
}

TEST(Setup, TheLinkMakesAnAdministratorOnce) {
  RunningServer running;
  const std::string token = make_token(running);
  ASSERT_FALSE(token.empty());
  Client client = running.client();
  const Answer first = client.post("/api/setup", setup_body(token, "chief", "v7#kq2zp-long"));
  ASSERT_EQ(first.status, 200) << first.body;
  EXPECT_EQ(first.json()["role"], "administrator");
  EXPECT_NE(first.header("set-cookie"), "");
  EXPECT_EQ(try_to_sign_in(client, "chief", "v7#kq2zp-long").status, 200);

  const Answer again = client.post("/api/setup", setup_body(token, "other", "v7#kq2zp-long"));
  EXPECT_EQ(again.status, 403);
  EXPECT_EQ(try_to_sign_in(client, "other", "v7#kq2zp-long").status, 401);
}

TEST(Setup, AForgedTokenAndABadPasswordAreRefusedAndTheLinkStaysGood) {
  RunningServer running;
  const std::string token = make_token(running);
  Client client = running.client();
  EXPECT_EQ(client.post("/api/setup", setup_body("forged", "chief", "v7#kq2zp-long")).status, 403);
  EXPECT_EQ(client.post("/api/setup", setup_body(token, "chief", "password1")).status, 400);
  EXPECT_EQ(client.post("/api/setup", setup_body(token, "", "v7#kq2zp-long")).status, 400);
  EXPECT_EQ(client.post("/api/setup", setup_body(token, "ann", "v7#kq2zp-long")).status, 409);
  EXPECT_EQ(client.post("/api/setup", setup_body(token, "chief", "v7#kq2zp-long")).status, 200);
}

TEST(Setup, ALockedOutAdministratorGetsANewPasswordAndLosesOldSessions) {
  RunningServer running;
  Client before = running.client_of("ada");
  const std::string token = make_token(running);
  Client client = running.client();
  EXPECT_EQ(client.post("/api/setup", setup_body(token, "ada", "v7#kq2zp-long")).status, 200);
  EXPECT_EQ(before.get("/api/session").status, 401);
  EXPECT_EQ(try_to_sign_in(client, "ada", kPassword).status, 401);
}

TEST(Site, SaysWhetherItNeedsSettingUpAndShowsAccountsOnlyInTheDemo) {
  RunningServer running([](ServerOptions& options) {
    options.demo_accounts = {{"ann", "secret", database::Role::trainee}};
  });
  const Answer site = running.client().get("/api/site");
  EXPECT_EQ(site.status, 200);
  EXPECT_EQ(site.json()["needs_setup"], false);
  EXPECT_EQ(site.json()["demo"], false);
  EXPECT_EQ(site.json()["demo_accounts"].size(), 0U);
  Workplace& workplace = running.workplace;
  ASSERT_TRUE(database::set_disabled(workplace.store(), workplace.id_of("ada"), true, "system"));
  EXPECT_EQ(running.client().get("/api/site").json()["needs_setup"], true);
}

}  // namespace
}  // namespace app::test
