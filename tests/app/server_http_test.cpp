// What the server does with requests that no browser of ours sends.
#include <string>

#include <gtest/gtest.h>

#include "tests/app/server_fixture.h"

namespace app::test {
namespace {

std::string host_line(const RunningServer& running) {
  return "Host: 127.0.0.1:" + std::to_string(running.server.port()) + "\r\n";
}

bool starts_with(const std::string& text, const std::string& start) {
  return text.rfind(start, 0) == 0;
}

TEST(Http, MalformedRequestsAre400AndTheConnectionIsClosed) {
  RunningServer running;
  const std::string host = host_line(running);
  const std::string malformed[] = {
      "nonsense\r\n\r\n",
      "GET\r\n\r\n",
      "GET / HTTP/9.9\r\n" + host + "\r\n",
      "GET / HTTP/1.1\r\n" + host + "bad header line\r\n\r\n",
      "POST /api/session HTTP/1.1\r\n" + host + "Content-Length: -5\r\n\r\n",
      "POST /api/session HTTP/1.1\r\n" + host + "Content-Length: 5\r\nContent-Length: 7\r\n\r\n",
      "GET /%zz HTTP/1.1\r\n" + host + "\r\n",
      "GET http://elsewhere/ HTTP/1.1\r\n" + host + "\r\n",
      std::string("GET /\0x HTTP/1.1\r\n", 18) + host + "\r\n",
  };
  for (const std::string& request : malformed) {
    // returning at all means that the server closed
    const std::string answer = send_raw(running.server.port(), request);
    EXPECT_TRUE(starts_with(answer, "HTTP/1.1 400")) << request << "\n -> " << answer;
    EXPECT_NE(answer.find("Connection: close"), std::string::npos) << request;
    EXPECT_NE(answer.find("{\"code\""), std::string::npos) << request;
  }
  EXPECT_EQ(running.client().get("/api/health").status, 200);
}

TEST(Http, MalformedJsonIs400WithASentence) {
  RunningServer running;
  Client client = running.client();
  std::string deep(100'000 / 2, '[');
  const std::string bodies[] = {"{",
                                "[]",
                                "null",
                                "\"x\"",
                                "{\"name\":\"ann\"}",
                                "{\"name\":1,\"password\":\"x\"}",
                                "{\"name\":\"a\",\"password\":\"b\",\"more\":1}",
                                "\xff\xfe",
                                deep,
                                "{\"name\":\"\xc3\x28\",\"password\":\"x\"}"};
  for (const std::string& body : bodies) {
    const Answer answer = client.send("POST", "/api/session", body);
    EXPECT_EQ(answer.status, 400) << body.substr(0, 60);
    EXPECT_FALSE(answer.json()["error"].get<std::string>().empty());
  }
}

TEST(Http, ABodyOver64KiBIs413) {
  RunningServer running;
  const std::string body = "{\"name\":\"" + std::string(70'000, 'x') + "\"}";
  EXPECT_EQ(running.client().send("POST", "/api/session", body).status, 413);
  // without a declared length, the limit holds all the same
  std::string chunked =
      "POST /api/session HTTP/1.1\r\n" + host_line(running) + "Transfer-Encoding: chunked\r\n\r\n";
  for (int i = 0; i < 20; ++i) chunked += "1000\r\n" + std::string(4096, 'x') + "\r\n";
  chunked += "0\r\n\r\n";
  const std::string answer = send_raw(running.server.port(), chunked);
  EXPECT_TRUE(starts_with(answer, "HTTP/1.1 413")) << answer.substr(0, 100);
}

TEST(Http, HeadersOver16KiBAre431) {
  RunningServer running;
  const std::string request =
      "GET / HTTP/1.1\r\n" + host_line(running) + "X: " + std::string(20'000, 'x') + "\r\n\r\n";
  EXPECT_TRUE(starts_with(send_raw(running.server.port(), request), "HTTP/1.1 431"));
}

TEST(Http, UnknownRoutesAndMethodsAreProblems) {
  RunningServer running;
  Client client = running.client_of("ann");
  for (const char* path : {"/api", "/api/", "/api/nothing", "/api/trials/x/y", "/api/training/"}) {
    const Answer answer = client.get(path);
    EXPECT_EQ(answer.status, 404) << path;
    EXPECT_EQ(answer.header("content-type"), "application/json");
  }
  const Answer put = client.send("PUT", "/api/training");
  EXPECT_EQ(put.status, 405);
  EXPECT_EQ(put.header("allow"), "GET");
  EXPECT_EQ(client.send("PATCH", "/api/training").status, 405);
  EXPECT_EQ(client.send("OPTIONS", "/api/training").status, 405);
  EXPECT_EQ(client.send("POST", "/").status, 405);
}

TEST(Http, AnotherHostNameIsNotAnswered) {
  RunningServer running;
  const Answer answer =
      running.client().send("GET", "/api/site", "", {{"Host", "rebound.example"}});
  EXPECT_EQ(answer.status, 421);
}

TEST(Http, ARequestThatNeverEndsIsCutOff) {
  RunningServer running([](ServerOptions& options) { options.request_timeout_s = 0.2; });
  // would hang until the client's own limit of 10 s
  EXPECT_EQ(send_raw(running.server.port(), "GET / HTTP/1.1\r\nHost: loc"), "");
}

TEST(Http, TooManyRequestsFromAClientAre429) {
  RunningServer running([](ServerOptions& options) { options.requests_per_second = 1.0; });
  Client client = running.client();
  int admitted = 0;
  while (client.get("/api/health").status == 200 && admitted < 100) ++admitted;
  EXPECT_GE(admitted, 10);  // the burst
  EXPECT_LT(admitted, 20);
  EXPECT_EQ(client.get("/api/health").status, 429);
}

TEST(Http, BeyondTheConnectionLimitNobodyIsLetIn) {
  RunningServer running([](ServerOptions& options) { options.max_connections = 0; });
  EXPECT_EQ(send_raw(running.server.port(), "GET / HTTP/1.1\r\n\r\n"), "");
}

TEST(Http, EveryAnswerCarriesTheSecurityHeaders) {
  RunningServer running;
  Client client = running.client();
  for (const char* path : {"/", "/assets/app.js", "/api/site", "/api/training", "/api/nothing"}) {
    const Answer answer = client.get(path);
    const std::string policy = answer.header("content-security-policy");
    EXPECT_NE(policy.find("default-src 'self'"), std::string::npos) << path;
    EXPECT_NE(policy.find("script-src 'self';"), std::string::npos) << path;
    EXPECT_NE(policy.find("frame-ancestors 'none'"), std::string::npos) << path;
    EXPECT_NE(policy.find("base-uri 'none'"), std::string::npos) << path;
    EXPECT_NE(policy.find("object-src 'none'"), std::string::npos) << path;
    EXPECT_EQ(policy.find("unsafe"), std::string::npos) << path;
    EXPECT_EQ(answer.header("x-content-type-options"), "nosniff") << path;
    EXPECT_EQ(answer.header("referrer-policy"), "no-referrer") << path;
    EXPECT_EQ(answer.header("server"), "") << path;
  }
  EXPECT_EQ(client.get("/api/site").header("cache-control"), "no-store");
}

TEST(StaticFiles, ThePageCarriesAFreshNonceThatThePolicyNames) {
  RunningServer running;
  Client client = running.client();
  const auto nonce_of = [](const Answer& answer) {
    const std::string start = "content=\"";
    const std::size_t at = answer.body.find(start) + start.size();
    return answer.body.substr(at, answer.body.find('"', at) - at);
  };
  const Answer first = client.get("/"), second = client.get("/training/anything");
  EXPECT_EQ(first.header("content-type"), "text/html; charset=utf-8");
  EXPECT_EQ(first.body.find("__CSP_NONCE__"), std::string::npos);
  EXPECT_NE(nonce_of(first), nonce_of(second));
  for (const Answer& answer : {first, second}) {
    EXPECT_GE(nonce_of(answer).size(), 22U);
    EXPECT_NE(answer.header("content-security-policy")
                  .find("style-src 'self' 'nonce-" + nonce_of(answer) + "'"),
              std::string::npos);
  }
}

TEST(StaticFiles, AssetsAreImmutableAndTyped) {
  RunningServer running;
  Client client = running.client();
  const Answer script = client.get("/assets/app.js");
  EXPECT_EQ(script.status, 200);
  EXPECT_EQ(script.header("content-type"), "text/javascript; charset=utf-8");
  EXPECT_NE(script.header("cache-control").find("immutable"), std::string::npos);
  EXPECT_EQ(client.get("/icon.svg").header("content-type"), "image/svg+xml");
  EXPECT_EQ(client.get("/assets/none.js").status, 404);
  const Answer again =
      client.send("GET", "/assets/app.js", "", {{"If-None-Match", script.header("etag")}});
  EXPECT_EQ(again.status, 304);
  EXPECT_EQ(again.body, "");
  const Answer head = client.send("HEAD", "/assets/app.js");
  EXPECT_EQ(head.status, 200);
  EXPECT_EQ(head.body, "");
}

TEST(StaticFiles, NoPathLeavesTheWebFolder) {
  RunningServer running;
  Client client = running.client();
  std::filesystem::create_symlink(running.workplace.folder / "secret.txt",
                                  running.workplace.folder / "web/link.txt");
  for (const char* path :
       {"/../secret.txt", "/..%2fsecret.txt", "/%2e%2e/secret.txt", "/assets/../../secret.txt",
        "/assets/..%2f..%2fsecret.txt", "/..\\secret.txt", "/.hidden", "/link.txt", "//secret.txt",
        "/web/../../secret.txt"}) {
    const Answer answer = client.get(path);
    EXPECT_EQ(answer.body.find("not for the web"), std::string::npos) << path;
  }
}

TEST(Server, RefusesAnOpenAddressWithoutTlsOrProxy) {
  Workplace workplace;
  ServerOptions options = workplace.options();
  options.address = "0.0.0.0";
  Server open(options, workplace.library());
  const auto started = open.start();
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().code, base::ErrorCode::invalid_input);

  options.behind_proxy = true;
  Server proxied(options, workplace.library());
  EXPECT_TRUE(proxied.start());
}

TEST(Server, RefusesACertificateThatCannotBeRead) {
  Workplace workplace;
  ServerOptions options = workplace.options();
  options.tls_certificate = workplace.folder / "none.pem";
  options.tls_key = workplace.folder / "none.pem";
  Server server(options, workplace.library());
  const auto started = server.start();
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().code, base::ErrorCode::invalid_input);
}

TEST(Server, RefusesAPortThatIsTaken) {
  RunningServer running;
  Workplace workplace;
  ServerOptions options = workplace.options();
  options.port = running.server.port();
  Server second(options, workplace.library());
  const auto started = second.start();
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error().code, base::ErrorCode::unavailable);
}

}  // namespace
}  // namespace app::test
