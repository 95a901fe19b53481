#include "app/server/message.h"

#include <optional>
#include <string_view>

namespace app {
namespace {

const std::string kNone;

int hex_digit(char character) {
  if (character >= '0' && character <= '9') return character - '0';
  if (character >= 'a' && character <= 'f') return character - 'a' + 10;
  if (character >= 'A' && character <= 'F') return character - 'A' + 10;
  return -1;
}

std::optional<std::string> percent_decode(std::string_view text, bool plus_is_space) {
  std::string decoded;
  for (std::size_t i = 0; i < text.size(); ++i) {
    char character = text[i];
    if (character == '%') {
      if (i + 2 >= text.size()) return std::nullopt;
      const int high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
      if (high < 0 || low < 0) return std::nullopt;
      character = static_cast<char>(high * 16 + low);
      i += 2;
    } else if (character == '+' && plus_is_space) {
      character = ' ';
    }
    // a zero byte would end the name of a file early
    if (character == '\0') return std::nullopt;
    decoded += character;
  }
  return decoded;
}

const std::string& value_of(const std::map<std::string, std::string>& values,
                            const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? kNone : found->second;
}

bool read_query(std::string_view text, std::map<std::string, std::string>& query) {
  while (!text.empty()) {
    const std::size_t end = text.find('&');
    const std::string_view pair = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    if (pair.empty()) continue;
    const std::size_t equals = pair.find('=');
    const auto name = percent_decode(pair.substr(0, equals), true);
    const auto value = equals == std::string_view::npos
                           ? std::optional<std::string>("")
                           : percent_decode(pair.substr(equals + 1), true);
    if (!name || !value) return false;
    query.emplace(*name, *value);
  }
  return true;
}

}  // namespace

const char* word(Method method) {
  switch (method) {
    case Method::get:
      return "GET";
    case Method::post:
      return "POST";
    case Method::put:
      return "PUT";
    case Method::remove:
      return "DELETE";
  }
  return "";
}

const std::string& Request::header(const std::string& name) const {
  return value_of(headers, name);
}

const std::string& Request::parameter(const std::string& name) const {
  return value_of(query, name);
}

std::string Request::cookie(const std::string& name) const {
  std::string_view rest = header("cookie");
  while (!rest.empty()) {
    const std::size_t end = rest.find(';');
    std::string_view pair = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
    while (!pair.empty() && pair.front() == ' ') pair.remove_prefix(1);
    if (pair.size() > name.size() && pair.substr(0, name.size()) == name &&
        pair[name.size()] == '=') {
      return std::string(pair.substr(name.size() + 1));
    }
  }
  return {};
}

bool read_target(const std::string& target, Request& request) {
  if (target.empty() || target.front() != '/' || target.size() > 2048) return false;
  const std::size_t question = target.find('?');
  const auto path = percent_decode(std::string_view(target).substr(0, question), false);
  if (!path) return false;
  request.path = *path;
  if (question == std::string::npos) return true;
  return read_query(std::string_view(target).substr(question + 1), request.query);
}

}  // namespace app
