#include "app/server/json_body.h"

#include <utility>

namespace app {
namespace {

using nlohmann::json;

base::Error refuse(const std::string& sentence) {
  return base::Error{base::ErrorCode::invalid_input, sentence};
}

// Brackets nested deeper than any message of ours; the parser itself knows no limit. Those inside
// a string, such as the text of a curriculum, are none.
bool nested_too_deep(const std::string& text) {
  constexpr int kDeepest = 16;
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char character = text[i];
    if (character == '"') quoted = !quoted;
    if (quoted) {
      if (character == '\\') ++i;
      continue;
    }
    if (character == '{' || character == '[') ++depth;
    if (character == '}' || character == ']') --depth;
    if (depth > kDeepest) return true;
  }
  return false;
}

}  // namespace

base::Result<json> read_json_object(const Request& request) {
  if (!request.header("content-type").starts_with("application/json")) {
    return refuse("Send the request as JSON (Content-Type: application/json).");
  }
  if (nested_too_deep(request.body)) return refuse("The JSON in the request is nested too deep.");
  json body = json::parse(request.body, nullptr, false);
  if (!body.is_object()) return refuse("The request is not a readable JSON object.");
  return body;
}

base::Result<json> read_text_fields(const Request& request,
                                    std::initializer_list<const char*> names) {
  auto read = read_json_object(request);
  if (!read) return read.error();
  json body = *std::move(read);
  for (const char* name : names) {
    const auto found = body.find(name);
    if (found == body.end() || !found->is_string()) {
      return refuse(std::string("The request needs the text field \"") + name + "\".");
    }
  }
  if (body.size() != names.size()) return refuse("The request has fields it should not have.");
  return body;
}

Response json_response(const json& body, int status) {
  Response response;
  response.status = status;
  response.body = body.dump(-1, ' ', false, json::error_handler_t::replace);
  return response;
}

}  // namespace app
