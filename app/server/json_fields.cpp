#include "app/server/json_fields.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using nlohmann::json;

// 0.05, 100: as short as it can be told.
std::string plain(double value) { return json(value).dump(); }

std::string range_sentence(const char* name, const std::string& low, const std::string& high) {
  return std::string("The field \"") + name + "\" is a number from " + low + " to " + high + ".";
}

}  // namespace

void JsonFields::fail(const std::string& sentence) {
  if (failure_.empty()) failure_ = sentence;
}

const json* JsonFields::find(const char* name) {
  asked_.insert(name);
  if (!failure_.empty()) return nullptr;
  const auto found = object_.find(name);
  if (found != object_.end()) return &*found;
  fail(std::string("The request needs the field \"") + name + "\".");
  return nullptr;
}

std::string JsonFields::text(const char* name) {
  const json* value = find(name);
  if (value == nullptr) return {};
  if (value->is_string()) return value->get<std::string>();
  fail(std::string("The field \"") + name + "\" is a text.");
  return {};
}

std::optional<std::string> JsonFields::text_or_null(const char* name) {
  const json* value = find(name);
  if (value == nullptr || value->is_null()) return std::nullopt;
  return text(name);
}

std::string JsonFields::one_of(const char* name, std::initializer_list<const char*> words) {
  const std::string value = text(name);
  if (!failure_.empty()) return {};
  if (std::find(words.begin(), words.end(), value) != words.end()) return value;
  std::string choices;
  for (const char* word : words) choices += (choices.empty() ? "" : ", ") + std::string(word);
  fail(std::string("The field \"") + name + "\" is one of " + choices + ".");
  return {};
}

bool JsonFields::truth(const char* name) {
  const json* value = find(name);
  if (value == nullptr) return false;
  if (value->is_boolean()) return value->get<bool>();
  fail(std::string("The field \"") + name + "\" is true or false.");
  return false;
}

double JsonFields::number(const char* name, double low, double high) {
  const json* value = find(name);
  if (value == nullptr) return low;
  const double number = value->is_number() ? value->get<double>() : std::nan("");
  if (number >= low && number <= high) return number;
  fail(range_sentence(name, plain(low), plain(high)));
  return low;
}

std::optional<double> JsonFields::number_or_null(const char* name, double low, double high) {
  const json* value = find(name);
  if (value == nullptr || value->is_null()) return std::nullopt;
  return number(name, low, high);
}

int JsonFields::whole(const char* name, int low, int high) {
  const double value = number(name, low, high);
  if (value == std::floor(value)) return static_cast<int>(value);
  fail(std::string("The field \"") + name + "\" is a whole number.");
  return low;
}

std::vector<std::string> JsonFields::texts(const char* name) {
  const json* value = find(name);
  if (value == nullptr) return {};
  const bool all =
      value->is_array() && std::all_of(value->begin(), value->end(),
                                       [](const json& element) { return element.is_string(); });
  if (all) return value->get<std::vector<std::string>>();
  fail(std::string("The field \"") + name + "\" is a list of texts.");
  return {};
}

json JsonFields::object(const char* name) {
  const json* value = find(name);
  if (value == nullptr) return json::object();
  if (value->is_object()) return *value;
  fail(std::string("The field \"") + name + "\" is an object.");
  return json::object();
}

base::Status JsonFields::done() {
  if (failure_.empty()) {
    for (const auto& [name, value] : object_.items()) {
      if (!asked_.contains(name)) {
        fail("The request has a field it should not have: \"" + name.substr(0, 60) + "\".");
      }
    }
  }
  if (failure_.empty()) return base::Done{};
  return base::Error{base::ErrorCode::invalid_input, failure_};
}

}  // namespace app
