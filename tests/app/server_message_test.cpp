#include <gtest/gtest.h>

#include "app/server/message.h"
#include "app/server/same_origin.h"
#include "app/server/views/live_message.h"

namespace app {
namespace {

TEST(Message, TargetIsDecodedAndSplit) {
  Request request;
  ASSERT_TRUE(read_target("/api/compare/a%20b?dataset=pa%2Bper&x=1+2&empty", request));
  EXPECT_EQ(request.path, "/api/compare/a b");
  EXPECT_EQ(request.parameter("dataset"), "pa+per");
  EXPECT_EQ(request.parameter("x"), "1 2");
  EXPECT_EQ(request.parameter("empty"), "");
  EXPECT_EQ(request.parameter("absent"), "");
}

TEST(Message, WronglyEncodedTargetsAreRefused) {
  for (const char* target : {"", "api", "http://x/", "/%", "/%4", "/%zz", "/%00", "/?a=%00", "*"}) {
    Request request;
    EXPECT_FALSE(read_target(target, request)) << target;
  }
}

TEST(Message, CookieIsFoundByItsWholeName) {
  Request request;
  request.headers["cookie"] = "xcathedra=no; cathedra=yes; cathedra2=no";
  EXPECT_EQ(request.cookie("cathedra"), "yes");
  EXPECT_EQ(request.cookie("dra"), "");
}

Request from(const char* origin, const char* host, const char* fetch_site = nullptr) {
  Request request;
  request.headers["host"] = host;
  if (origin != nullptr) request.headers["origin"] = origin;
  if (fetch_site != nullptr) request.headers["sec-fetch-site"] = fetch_site;
  return request;
}

TEST(SameOrigin, OnlyTheOwnOriginPasses) {
  const ServerOptions options;
  EXPECT_TRUE(is_same_origin(from("http://127.0.0.1:8080", "127.0.0.1:8080"), options, true));
  EXPECT_FALSE(is_same_origin(from("http://127.0.0.1:9999", "127.0.0.1:8080"), options, true));
  EXPECT_FALSE(is_same_origin(from("http://evil.example", "127.0.0.1:8080"), options, true));
  EXPECT_FALSE(is_same_origin(from("null", "127.0.0.1:8080"), options, true));
}

TEST(SameOrigin, AClientThatDoesNotSayPassesOnlyWhereAllowed) {
  const ServerOptions options;
  EXPECT_TRUE(is_same_origin(from(nullptr, "127.0.0.1:8080"), options, false));
  EXPECT_FALSE(is_same_origin(from(nullptr, "127.0.0.1:8080"), options, true));
}

TEST(SameOrigin, FetchMetadataOfAnotherSiteIsRefused) {
  const ServerOptions options;
  EXPECT_FALSE(is_same_origin(from(nullptr, "127.0.0.1:8080", "cross-site"), options, false));
  EXPECT_FALSE(is_same_origin(from(nullptr, "127.0.0.1:8080", "same-site"), options, false));
  EXPECT_TRUE(is_same_origin(from(nullptr, "127.0.0.1:8080", "same-origin"), options, false));
}

TEST(SameOrigin, UnderTlsThePageMustHaveComeByTls) {
  ServerOptions options;
  options.tls_certificate = "cert.pem";
  EXPECT_FALSE(is_same_origin(from("http://c.example", "c.example"), options, true));
  EXPECT_TRUE(is_same_origin(from("https://c.example", "c.example"), options, true));
}

TEST(SameOrigin, ALoopbackServerAnswersOnlyToNamesOfTheMachine) {
  ServerOptions options;
  for (const char* host : {"localhost:8080", "127.0.0.1", "[::1]:8080"}) {
    EXPECT_TRUE(is_own_host(host, options)) << host;
  }
  for (const char* host :
       {"", "evil.example:8080", "localhost.evil.example", "10.0.0.1", "127.evil.example"}) {
    EXPECT_FALSE(is_own_host(host, options)) << host;
  }
  options.behind_proxy = true;
  EXPECT_TRUE(is_own_host("training.example", options));
}

TEST(LiveMessage, AHandleMessageIsReadInOurUnits) {
  const auto message = read_client_message(
      R"({"type":"handle","feed_mm_s":12.5,"turn_deg_s":180,"move_mm":-1,"rotate_deg":90})");
  ASSERT_TRUE(message);
  const auto& command = std::get<LiveCommand>(*message);
  EXPECT_DOUBLE_EQ(command.feed, 12.5);
  EXPECT_DOUBLE_EQ(command.turn, 3.14159265358979323846);
  EXPECT_DOUBLE_EQ(command.move, -1.0);
  EXPECT_DOUBLE_EQ(command.rotate, 3.14159265358979323846 / 2.0);
}

TEST(LiveMessage, ControlsAndPingsAreRead) {
  EXPECT_EQ(std::get<LiveControl>(*read_client_message(R"({"type":"end"})")), LiveControl::end);
  EXPECT_EQ(std::get<LiveControl>(*read_client_message(R"({"type":"pause"})")), LiveControl::pause);
  EXPECT_DOUBLE_EQ(
      std::get<LivePing>(*read_client_message(R"({"type":"ping","sent_ms":17.5})")).sent_ms, 17.5);
}

TEST(LiveMessage, EverythingElseIsRefusedWithASentence) {
  const char* const malformed[] = {
      "",
      "null",
      "[]",
      "{}",
      "{\"type\":1}",
      R"({"type":"fly"})",
      R"({"type":"handle"})",
      R"({"type":"handle","feed_mm_s":1})",
      R"({"type":"handle","feed_mm_s":"1","turn_deg_s":0})",
      R"({"type":"handle","feed_mm_s":200.1,"turn_deg_s":0})",
      R"({"type":"handle","feed_mm_s":0,"turn_deg_s":-1081})",
      R"({"type":"handle","feed_mm_s":1e999,"turn_deg_s":0})",
      R"({"type":"handle","feed_mm_s":0,"turn_deg_s":0,"move_mm":51})",
      R"({"type":"handle","feed_mm_s":0,"turn_deg_s":0,"extra":1})",
      R"({"type":"pause","extra":1})",
      R"({"type":"ping"})",
      "{\"type\":\"pause\"} trailing",
      "\xff\xfe",
  };
  for (const char* text : malformed) {
    const auto message = read_client_message(text);
    ASSERT_FALSE(message) << text;
    EXPECT_FALSE(message.error().message.empty());
  }
}

}  // namespace
}  // namespace app
