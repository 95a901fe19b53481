// Walks every route of the server's own table as nobody and as every role, for own, other's and
// absent objects, and compares with the table here, which was written by hand from the rules.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "app/server/router.h"
#include "tests/app/server_fixture.h"

namespace app::test {
namespace {

// T trainee, I instructor, A administrator, R researcher; N nobody signed in.
struct Rule {
  const char* method;
  const char* pattern;
  const char* allowed;
};
constexpr Rule kRules[] = {
    {"GET", "/api/health", "NTIAR"},
    {"GET", "/api/site", "NTIAR"},
    {"POST", "/api/session", "NTIAR"},
    {"GET", "/api/session", "TIAR"},
    {"DELETE", "/api/session", "TIAR"},
    {"POST", "/api/setup", "NTIAR"},
    {"GET", "/api/training", "TIA"},
    {"GET", "/api/exercises/{id}", "TIA"},
    {"GET", "/api/anatomies/{id}/mesh.glb", "TIAR"},
    {"GET", "/api/metrics", "TIAR"},
    {"POST", "/api/trials", "TIA"},
    {"GET", "/api/live/mine", "TIA"},
    {"GET", "/api/live/{id}", "TIA"},
    {"GET", "/api/trials/{id}", "TIA"},
    {"GET", "/api/people", "IA"},
    {"GET", "/api/people/{id}/progress", "TIA"},
    {"GET", "/api/compare", "IAR"},
    {"GET", "/api/compare/{id}", "IAR"},
    {"GET", "/api/compare/{id}.csv", "IAR"},
    {"GET", "/api/compare/{id}.html", "IAR"},
};

struct Visitor {
  char letter;
  const char* name;  // null: nobody
};
constexpr Visitor kVisitors[] = {
    {'N', nullptr}, {'T', "ann"}, {'I', "ina"}, {'A', "ada"}, {'R', "rex"}};

const Rule* rule_of(const Route& route) {
  for (const Rule& rule : kRules) {
    if (route.pattern == rule.pattern && std::string(word(route.method)) == rule.method) {
      return &rule;
    }
  }
  return nullptr;
}

// The pattern with an object that does not exist in place of every parameter.
std::string with_absent_object(std::string pattern) {
  const std::size_t open = pattern.find('{');
  if (open == std::string::npos) return pattern;
  return pattern.replace(open, pattern.find('}') - open + 1,
                         "00000000-0000-7000-8000-000000000000");
}

TEST(Access, EveryRouteHasARuleHereAndEveryRuleARoute) {
  std::size_t found = 0;
  for (const Route& route : routes()) {
    EXPECT_NE(rule_of(route), nullptr) << word(route.method) << " " << route.pattern;
    found += rule_of(route) != nullptr ? 1 : 0;
  }
  EXPECT_EQ(found, std::size(kRules));
}

TEST(Access, EveryRouteAdmitsExactlyTheRolesOfItsRule) {
  RunningServer running;
  for (const Visitor& visitor : kVisitors) {
    for (const Route& route : routes()) {
      // a session per route: signing out is one of the routes
      Client client = visitor.name == nullptr ? running.client() : running.client_of(visitor.name);
      const std::string method = word(route.method);
      const std::string body = method == "POST" ? "{}" : "";
      const Answer answer = client.send(method, with_absent_object(route.pattern), body);
      const Rule* rule = rule_of(route);
      ASSERT_NE(rule, nullptr);
      const bool allowed = std::string(rule->allowed).find(visitor.letter) != std::string::npos;
      const std::string what = method + " " + route.pattern + " as " + visitor.letter + ": " +
                               std::to_string(answer.status);
      if (allowed) {
        // behind the gate: an empty body is 400, an absent object 404, never a refusal
        EXPECT_NE(answer.status, 401) << what;
        EXPECT_NE(answer.status, 403) << what;
        EXPECT_LT(answer.status, 500) << what << answer.body;
      } else {
        EXPECT_EQ(answer.status, visitor.letter == 'N' ? 401 : 403) << what;
      }
      if (answer.status >= 400) {
        EXPECT_TRUE(answer.json().is_object()) << what;
        EXPECT_TRUE(answer.json().contains("error")) << what;
      }
    }
  }
}

struct Expectation {
  const char* viewer;
  const char* owner;
  int status;
};
// ina shares a group with ann and none with ben; no.1 is published.
constexpr Expectation kObjects[] = {
    {"ann", "ann", 200}, {"ann", "ben", 403},  {"ann", "ina", 403}, {"ann", "no.1", 403},
    {"ben", "ann", 403}, {"ben", "ben", 200},  {"ina", "ann", 200}, {"ina", "ben", 403},
    {"ina", "ina", 200}, {"ina", "no.1", 200}, {"ada", "ann", 200}, {"ada", "ben", 200},
    {"rex", "ann", 403}, {"rex", "no.1", 403},
};

TEST(Access, ATrialIsSeenByItsPersonTheirInstructorAndTheAdministrator) {
  RunningServer running;
  std::map<std::string, std::string> trials;
  for (const char* name : {"ann", "ben", "ina", "no.1"}) {
    trials[name] = running.workplace.add_trial(name);
  }
  for (const Expectation& expected : kObjects) {
    Client client = running.client_of(expected.viewer);
    const std::string& trial = trials[expected.owner];
    const Answer answer = client.get("/api/trials/" + trial);
    EXPECT_EQ(answer.status, expected.status)
        << expected.viewer << " reads a trial of " << expected.owner << ": " << answer.body;
    if (answer.status == 200) {
      EXPECT_EQ(answer.json()["trial"]["trial_id"], trial);
    }
  }
}

TEST(Access, ProgressIsSeenByThePersonTheirInstructorAndTheAdministrator) {
  RunningServer running;
  for (const Expectation& expected : kObjects) {
    Client client = running.client_of(expected.viewer);
    const std::string id = running.workplace.id_of(expected.owner);
    const Answer answer = client.get("/api/people/" + id + "/progress");
    EXPECT_EQ(answer.status, expected.status)
        << expected.viewer << " reads the progress of " << expected.owner << ": " << answer.body;
    if (answer.status == 200) {
      EXPECT_EQ(answer.json()["person"]["person_id"], id);
    }
  }
}

TEST(Access, AbsentObjectsAreNotFound) {
  RunningServer running;
  Client client = running.client_of("ann");
  EXPECT_EQ(client.get("/api/trials/none").status, 404);
  EXPECT_EQ(client.get("/api/people/none/progress").status, 404);
  EXPECT_EQ(client.get("/api/exercises/none").status, 404);
  EXPECT_EQ(client.get("/api/anatomies/none/mesh.glb").status, 404);
}

TEST(Access, AnInstructorListsTheOwnGroupsAndAnAdministratorEverybody) {
  RunningServer running;
  const auto names = [](const Answer& answer) {
    std::set<std::string> found;
    const nlohmann::json body = answer.json();
    for (const auto& person : body["people"]) found.insert(person["name"]);
    return found;
  };
  const std::set<std::string> seen = names(running.client_of("ina").get("/api/people"));
  EXPECT_TRUE(seen.contains("ann"));
  EXPECT_FALSE(seen.contains("ben"));
  EXPECT_EQ(names(running.client_of("ada").get("/api/people")),
            (std::set<std::string>{"ada", "ann", "ben", "ina", "no.1", "rex"}));
}

}  // namespace
}  // namespace app::test
