#include "database/stored_counts.h"

#include <array>

#include "database/connection.h"

namespace database {
namespace {

struct Counted {
  const char* what;
  const char* rows;  // FROM ...
};
constexpr std::array kCounted = std::to_array<Counted>({
    {"People with an account", "person WHERE kind = 'live'"},
    {"Simulated and published people", "person WHERE kind <> 'live'"},
    {"Groups", "person_group"},
    {"Published curriculum versions", "curriculum_version"},
    {"Trials", "trial"},
    {"Comments on trials", "trial_comment"},
    {"Rows of the audit log", "audit"},
});

}  // namespace

base::Result<std::vector<StoredCount>> stored_counts(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::vector<StoredCount>> {
    std::vector<StoredCount> counts;
    for (const Counted& counted : kCounted) {
      StoredCount row{counted.what, 0};
      sql << "SELECT count(*) FROM " + std::string(counted.rows), soci::into(row.count);
      counts.push_back(row);
    }
    return counts;
  });
}

}  // namespace database
