// Walks every route of the server's own table as nobody and as every role, for own, other's and
// absent objects, and compares with the table here, which was written by hand from the rules.
//
// A new route fails the first test until it has one line in kRules; everything else about it is
// worked out from that line.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "app/server/router.h"
#include "tests/app/server_fixture.h"

namespace app::test {
namespace {

// What {id} in the path names.
enum class About {
  nothing,  // no {id}
  person,   // somebody's data: of a person ...
  trial,    // ... or of one of their trials
  thing     // nobody's: an exercise, a curriculum, a backup
};

// T trainee, I instructor, A administrator, R researcher; N nobody signed in.
struct Rule {
  const char* method;
  const char* pattern;
  const char* allowed;
  About about = About::nothing;
};
constexpr Rule kRules[] = {
    {"GET", "/api/health", "NTIAR"},
    {"GET", "/api/site", "NTIAR"},
    {"POST", "/api/session", "NTIAR"},
    {"GET", "/api/session", "TIAR"},
    {"DELETE", "/api/session", "TIAR"},
    {"POST", "/api/setup", "NTIAR"},
    {"POST", "/api/invitation/look", "NTIAR"},
    {"POST", "/api/invitation", "NTIAR"},

    // one's own
    {"GET", "/api/training", "TIA"},
    {"GET", "/api/exercises/{id}", "TIA", About::thing},
    {"GET", "/api/anatomies/{id}/mesh.glb", "TIAR", About::thing},
    {"GET", "/api/metrics", "TIAR"},
    {"GET", "/api/me/settings", "TIAR"},
    {"PUT", "/api/me/settings", "TIAR"},
    {"POST", "/api/me/password", "TIAR"},

    // trials
    {"POST", "/api/trials", "TIA"},
    {"POST", "/api/practice", "TIA"},
    {"GET", "/api/practice/{id}/result", "TIA", About::thing},
    {"GET", "/api/live", "TIA"},
    {"GET", "/api/live/mine", "TIA"},
    {"GET", "/api/live/{id}", "TIA", About::trial},
    {"GET", "/api/trials/{id}", "TIA", About::trial},
    {"POST", "/api/trials/{id}/comments", "IA", About::trial},
    {"DELETE", "/api/trials/{id}/comments/{comment}", "IA", About::trial},
    {"POST", "/api/trials/{id}/void", "IA", About::trial},

    // people
    {"GET", "/api/people", "IA"},
    {"POST", "/api/people", "A"},
    {"GET", "/api/people/{id}", "A", About::person},
    {"PUT", "/api/people/{id}", "A", About::person},
    {"POST", "/api/people/{id}/invitation", "A", About::person},
    {"GET", "/api/people/{id}/progress", "TIA", About::person},
    {"POST", "/api/people/import/preview", "A"},
    {"POST", "/api/people/import", "A"},
    {"GET", "/api/groups", "IA"},

    // curricula, instruments
    {"GET", "/api/curricula", "A"},
    {"POST", "/api/curricula", "A"},
    {"POST", "/api/curricula/check", "A"},
    {"PUT", "/api/curricula/default", "A"},
    {"GET", "/api/curricula/{id}/versions/{version}", "A", About::thing},
    {"PUT", "/api/curricula/{id}/draft", "A", About::thing},
    {"DELETE", "/api/curricula/{id}/draft", "A", About::thing},
    {"POST", "/api/curricula/{id}/publish", "A", About::thing},
    {"POST", "/api/curricula/{id}/retire", "A", About::thing},
    {"GET", "/api/curricula/{id}/diff", "A", About::thing},
    {"GET", "/api/catalogue", "IA"},
    {"GET", "/api/instruments", "IA"},

    // cohort

    // the system
    {"GET", "/api/system", "A"},
    {"POST", "/api/system/backups", "A"},
    {"GET", "/api/system/backups/{name}", "A", About::thing},
    {"GET", "/api/audit", "A"},

    // reports
    {"GET", "/api/compare", "IAR"},
    {"GET", "/api/compare/{id}", "IAR", About::thing},
    {"GET", "/api/compare/{id}.csv", "IAR", About::thing},
    {"GET", "/api/compare/{id}.html", "IAR", About::thing},
};

struct Visitor {
  char letter;
  const char* name;  // null: nobody
};
constexpr Visitor kVisitors[] = {
    {'N', nullptr}, {'T', "ann"}, {'I', "ina"}, {'A', "ada"}, {'R', "rex"}};

// Whose object it is. ina shares a group with ann and none with ben; no.1 is published.
constexpr const char* kOwners[] = {"ann", "ben", "ina", "ada", "rex", "no.1"};

// Who may see whose data, by the rules in words: one's own; an instructor that of the own groups
// and of published people; an administrator everybody's.
bool may_see(const std::string& viewer, const std::string& owner) {
  if (viewer == owner || viewer == "ada") return true;
  return viewer == "ina" && (owner == "ann" || owner == "no.1");
}

constexpr const char* kAbsent = "00000000-0000-7000-8000-000000000000";

bool admits(const Rule& rule, char letter) {
  return std::string(rule.allowed).find(letter) != std::string::npos;
}

const Rule* rule_of(const Route& route) {
  for (const Rule& rule : kRules) {
    if (route.pattern == rule.pattern && std::string(word(route.method)) == rule.method) {
      return &rule;
    }
  }
  return nullptr;
}

// The pattern with `id` in place of {id} and nothing that exists in place of other parameters.
std::string path_for(std::string pattern, const std::string& id) {
  for (std::size_t open = pattern.find('{'); open != std::string::npos; open = pattern.find('{')) {
    const std::size_t length = pattern.find('}') - open + 1;
    const bool named_id = pattern.substr(open, length) == "{id}";
    pattern.replace(open, length, named_id ? id : kAbsent);
  }
  return pattern;
}

// A change is asked for with an empty object: past the gate it is refused or finds nothing, and the
// object is there for the next visitor.
Answer ask(Client& client, const Rule& rule, const std::string& id) {
  const std::string method = rule.method;
  const bool with_body = method == "POST" || method == "PUT";
  return client.send(method, path_for(rule.pattern, id), with_body ? "{}" : "");
}

void expect_sentence(const Answer& answer, const std::string& what) {
  if (answer.status < 400) return;
  const nlohmann::json body = answer.json();
  ASSERT_TRUE(body.is_object()) << what;
  EXPECT_GT(body.value("error", "").size(), 10U) << what;
}

TEST(Access, EveryRouteHasARuleHereAndEveryRuleARoute) {
  std::size_t found = 0;
  for (const Route& route : routes()) {
    const Rule* rule = rule_of(route);
    EXPECT_NE(rule, nullptr) << "no rule for " << word(route.method) << " " << route.pattern;
    if (rule == nullptr) continue;
    ++found;
    const bool has_id = route.pattern.find('{') != std::string::npos;
    EXPECT_EQ(rule->about != About::nothing, has_id)
        << route.pattern << ": say in its rule what {id} names";
  }
  EXPECT_EQ(found, std::size(kRules)) << "a rule without a route";
}

TEST(Access, EveryRouteAdmitsExactlyTheRolesOfItsRule) {
  RunningServer running;
  for (const Visitor& visitor : kVisitors) {
    for (const Rule& rule : kRules) {
      // a session per route: signing out is one of the routes
      Client client = visitor.name == nullptr ? running.client() : running.client_of(visitor.name);
      const Answer answer = ask(client, rule, kAbsent);
      const std::string what = std::string(rule.method) + " " + rule.pattern + " as " +
                               visitor.letter + ": " + std::to_string(answer.status);
      if (admits(rule, visitor.letter)) {
        // behind the gate: an empty body is 400, an absent object 404, never a refusal
        EXPECT_NE(answer.status, 401) << what;
        EXPECT_NE(answer.status, 403) << what;
        EXPECT_LT(answer.status, 500) << what << answer.body;
        if (rule.about == About::person || rule.about == About::trial) {
          EXPECT_EQ(answer.status, 404) << what;
        } else if (rule.about == About::thing) {
          EXPECT_TRUE(answer.status == 404 || answer.status == 400) << what;
        }
      } else {
        EXPECT_EQ(answer.status, visitor.letter == 'N' ? 401 : 403) << what;
      }
      expect_sentence(answer, what);
    }
  }
}

TEST(Access, EveryRouteAboutSomebodyAdmitsWhoMaySeeThem) {
  RunningServer running;
  std::map<std::string, std::string> people, trials;
  for (const char* owner : kOwners) {
    people[owner] = running.workplace.id_of(owner);
    trials[owner] = running.workplace.add_trial(owner);
  }
  for (const Visitor& visitor : kVisitors) {
    if (visitor.name == nullptr) continue;
    for (const Rule& rule : kRules) {
      if (rule.about != About::person && rule.about != About::trial) continue;
      for (const char* owner : kOwners) {
        Client client = running.client_of(visitor.name);
        const Answer answer =
            ask(client, rule, rule.about == About::person ? people[owner] : trials[owner]);
        const std::string what = std::string(rule.method) + " " + rule.pattern + " of " + owner +
                                 " as " + visitor.name + ": " + std::to_string(answer.status) +
                                 " " + answer.body;
        if (admits(rule, visitor.letter) && may_see(visitor.name, owner)) {
          EXPECT_NE(answer.status, 401) << what;
          EXPECT_NE(answer.status, 403) << what;
          EXPECT_LT(answer.status, 500) << what;
        } else {
          EXPECT_EQ(answer.status, 403) << what;
        }
        expect_sentence(answer, what);
      }
    }
  }
}

struct Expectation {
  const char* viewer;
  const char* owner;
  int status;
};
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
