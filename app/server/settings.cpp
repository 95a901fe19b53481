#include "app/server/settings.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string>

#include "app/server/json_fields.h"

namespace app {
namespace {

using nlohmann::json;

// Which keys there are is the browser's business; that they are names of keys is ours.
bool is_word(const std::string& text, bool with_underscore) {
  constexpr std::size_t kLongest = 32;
  return !text.empty() && text.size() <= kLongest &&
         std::all_of(text.begin(), text.end(), [&](unsigned char c) {
           return std::isalnum(c) != 0 || (with_underscore && c == '_');
         });
}

json read_keys(JsonFields& fields) {
  constexpr std::size_t kMost = 64;
  const json keys = fields.object("keys");
  if (keys.size() > kMost) fields.fail("There are too many keys.");
  std::map<std::string, std::string> actions;  // by key
  for (const auto& [action, code] : keys.items()) {
    if (!is_word(action, true) || !code.is_string() || !is_word(code.get<std::string>(), false)) {
      fields.fail("Each action has one key, by its name such as \"ArrowUp\".");
      continue;
    }
    const auto [other, is_new] = actions.emplace(code.get<std::string>(), action);
    if (!is_new) {
      fields.fail("The key " + other->first + " is given to " + other->second + " and to " +
                  action + "; choose another for one of them.");
    }
  }
  return keys;
}

}  // namespace

json default_settings() {
  return {{"feed_mm_s", 30.0}, {"turn_deg_s", 120.0}, {"fine_fraction", 1.0 / 6.0},
          {"force_unit", "N"}, {"theme", "auto"},     {"keys", json::object()},
          {"tour_seen", false}};
}

base::Result<json> read_settings(const json& body) {
  JsonFields fields(body);
  json settings = {{"feed_mm_s", fields.number("feed_mm_s", 1.0, 100.0)},
                   {"turn_deg_s", fields.number("turn_deg_s", 5.0, 720.0)},
                   {"fine_fraction", fields.number("fine_fraction", 0.05, 1.0)},
                   {"force_unit", fields.one_of("force_unit", {"N", "gf"})},
                   {"theme", fields.one_of("theme", {"auto", "light", "dark"})},
                   {"keys", read_keys(fields)},
                   {"tour_seen", fields.truth("tour_seen")}};
  if (const auto read = fields.done(); !read) return read.error();
  return settings;
}

}  // namespace app
