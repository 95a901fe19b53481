#include "app/cli/setup_link.h"

#include <algorithm>
#include <ctime>

#include "app/server/secrets.h"
#include "database/people.h"

namespace app::cli {
namespace {

constexpr std::time_t kValidSeconds = 24 * 3600;

std::string utc_after(std::time_t seconds) {
  const std::time_t then = std::time(nullptr) + seconds;
  std::tm parts{};
  gmtime_r(&then, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S.000Z", &parts);
  return text;
}

}  // namespace

base::Result<std::string> new_setup_link(database::Store& store, const std::string& site_url) {
  const std::string token = new_token();
  const base::Status stored =
      database::add_setup_token(store, token_hash(token), utc_after(kValidSeconds));
  if (!stored) return stored.error();
  return site_url + "/setup?token=" + token;
}

base::Result<bool> needs_administrator(database::Store& store) {
  const auto everyone = database::people(store);
  if (!everyone) return everyone.error();
  return std::none_of(everyone->begin(), everyone->end(), [](const database::Person& person) {
    return person.role == database::Role::administrator && !person.disabled;
  });
}

}  // namespace app::cli
