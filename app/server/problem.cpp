#include "app/server/problem.h"

#include <nlohmann/json.hpp>

namespace app {
namespace {

const char* word(base::ErrorCode code) {
  switch (code) {
    case base::ErrorCode::invalid_input:
      return "invalid_input";
    case base::ErrorCode::not_found:
      return "not_found";
    case base::ErrorCode::corrupt_data:
      return "corrupt_data";
    case base::ErrorCode::not_enough_data:
      return "not_enough_data";
    case base::ErrorCode::conflict:
      return "conflict";
    case base::ErrorCode::denied:
      return "denied";
    case base::ErrorCode::unavailable:
      return "unavailable";
  }
  return "unavailable";
}

}  // namespace

Response problem(int status, const std::string& code, const std::string& sentence) {
  Response response;
  response.status = status;
  // a sentence may quote what the client sent, which need not be UTF-8
  response.body = nlohmann::json{{"error", sentence}, {"code", code}}.dump(
      -1, ' ', false, nlohmann::json::error_handler_t::replace);
  return response;
}

int http_status(base::ErrorCode code) {
  switch (code) {
    case base::ErrorCode::invalid_input:
      return 400;
    case base::ErrorCode::not_found:
      return 404;
    case base::ErrorCode::corrupt_data:
      return 500;
    case base::ErrorCode::not_enough_data:
      return 422;
    case base::ErrorCode::conflict:
      return 409;
    case base::ErrorCode::denied:
      return 403;
    case base::ErrorCode::unavailable:
      return 503;
  }
  return 500;
}

Response problem(const base::Error& error) {
  return problem(http_status(error.code), word(error.code), error.message);
}

}  // namespace app
