// A request and its answer as the handlers see them: plain data, no socket and no Beast.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace app {

enum class Method { get, post, put, remove };
const char* word(Method method);

struct Request {
  Method method = Method::get;
  std::string path;                            // percent-decoded, begins with /
  std::map<std::string, std::string> query;    // decoded
  std::map<std::string, std::string> headers;  // lower-case names; the first value of each
  std::string body;
  std::string client;  // address of the browser

  // Empty when absent.
  const std::string& header(const std::string& name) const;
  const std::string& parameter(const std::string& name) const;  // of the query
  std::string cookie(const std::string& name) const;
};

struct Response {
  int status = 200;
  std::string type = "application/json";
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers;
};

// Splits a request target ("/api/x%20y?a=b") into the request's path and query. False when it is
// not a path or is wrongly encoded.
bool read_target(const std::string& target, Request& request);

}  // namespace app
