// Takes a JSON object apart, field by field. What is missing, of the wrong kind, out of range or
// left over becomes one sentence; the first failure counts, and what is read after it is empty.
//
//     JsonFields fields(*body);
//     const std::string name = fields.text("name");
//     if (fields.has("cases")) change.cases = fields.whole("cases", 0, kMany);
//     if (const auto read = fields.done(); !read) return read.error();
#pragma once

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/base/result.h"

namespace app {

class JsonFields {
 public:
  // The object must outlive this.
  explicit JsonFields(const nlohmann::json& object) : object_(object) {}

  bool has(const char* name) const { return object_.contains(name); }

  std::string text(const char* name);
  std::optional<std::string> text_or_null(const char* name);
  std::string one_of(const char* name, std::initializer_list<const char*> words);
  bool truth(const char* name);
  double number(const char* name, double low, double high);
  std::optional<double> number_or_null(const char* name, double low, double high);
  int whole(const char* name, int low, int high);
  std::vector<std::string> texts(const char* name);
  nlohmann::json object(const char* name);

  // A failure that the caller has found in a value.
  void fail(const std::string& sentence);
  // The first failure, or a field that nobody has asked for.
  base::Status done();

 private:
  const nlohmann::json* find(const char* name);  // null: a failure, now or before

  const nlohmann::json& object_;
  std::set<std::string> asked_;
  std::string failure_;
};

}  // namespace app
