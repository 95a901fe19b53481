// People, how they sign in, what they may do, and how experienced they said they were, and when.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "database/store.h"

namespace database {

enum class Role { trainee, instructor, administrator, researcher };
enum class Level { novice, intermediate, expert };
const char* word(Role role);
const char* word(Level level);
bool parse(const std::string& text, Role& role);
bool parse(const std::string& text, Level& level);  // these return false on an unknown word

// Where a person came from. Only `live` people sign in.
enum class PersonKind { live, simulated, published };
const char* word(PersonKind kind);
bool parse(const std::string& text, PersonKind& kind);

struct Person {
  std::string id;
  std::string name;  // unique but for A-Z and a-z, what one signs in with
  std::string display_name;
  Role role = Role::trainee;
  PersonKind kind = PersonKind::live;
  bool disabled = false;
  std::string password_phc;         // Argon2id; empty: cannot sign in
  std::optional<Level> level;       // the latest declared
  std::vector<std::string> groups;  // by name
  std::string email;                // empty when none
  std::string created_utc;
  std::string last_sign_in_utc;  // empty: never

  bool can_sign_in() const {
    return kind == PersonKind::live && !disabled && !password_phc.empty();
  }
};

struct NewPerson {
  std::string name, display_name;
  Role role = Role::trainee;
  PersonKind kind = PersonKind::live;
  std::string password_phc;
  std::string email;
  std::optional<Level> level;
  int cases = 0;                             // done so far; counts only with a level
  std::vector<std::string> groups;           // created when absent
  std::optional<std::string> curriculum_id;  // none: the default of the site
  // When the level was declared. Empty: now for live people; for simulated operators and
  // published participants the level holds at any time.
  std::string level_declared_utc;
};

// `actor` is the person's id who does it, or "system" / "shell"; it goes into the audit.
base::Result<Person> add_person(Store& store, const NewPerson& person, const std::string& actor);
base::Result<Person> person_by_id(Store& store, const std::string& id);      // not_found
base::Result<Person> person_by_name(Store& store, const std::string& name);  // not_found
base::Result<std::vector<Person>> people(Store& store);                      // all, by name
// Disabling ends the person's web sessions and withdraws invitations.
base::Status set_disabled(Store& store, const std::string& person_id, bool disabled,
                          const std::string& actor);
base::Status set_password(Store& store, const std::string& person_id, const std::string& phc,
                          const std::string& actor);
// declared_utc empty: now. Earlier declarations stay.
base::Status declare_experience(Store& store, const std::string& person_id, Level level, int cases,
                                const std::string& actor, const std::string& declared_utc = "");
// All declarations, the newest first.
struct Experience {
  Level level = Level::novice;
  int cases = 0;
  std::string declared_utc, declared_by;  // a person's id, or "system" / "shell"
};
base::Result<std::vector<Experience>> experience_of(Store& store, const std::string& person_id);
// Person -> cases declared last, of all who declared any. For lists: one query.
base::Result<std::map<std::string, int>> cases_by_person(Store& store);
// The level that counted at that time: the latest declared by then; none when there was none.
base::Result<std::optional<Level>> level_at(Store& store, const std::string& person_id,
                                            const std::string& utc);
// A group is created when absent. Joining twice and leaving where one is not are no errors.
base::Status join_group(Store& store, const std::string& person_id, const std::string& group,
                        const std::string& actor);
base::Status leave_group(Store& store, const std::string& person_id, const std::string& group,
                         const std::string& actor);
struct Membership {
  std::string group, from_utc, to_utc;  // to_utc: empty while it lasts
};
base::Result<std::vector<Membership>> memberships_of(Store& store, const std::string& person_id);
struct Group {
  std::string name;
  int people = 0;  // now
};
base::Result<std::vector<Group>> groups(Store& store);  // by name
// The people an instructor may see: those who share a group with them, without themselves.
base::Result<std::vector<Person>> people_of_instructor(Store& store,
                                                       const std::string& instructor_id);

// One-time links (set-up of the first administrator). Only a hash of the token is stored.
base::Status add_setup_token(Store& store, const std::string& token_hash,
                             const std::string& expires_utc);
// True once for a known, unexpired, unused token; marks it used.
base::Result<bool> use_setup_token(Store& store, const std::string& token_hash);

// Server-side sessions. The cookie's value is never stored, only its hash.
struct WebSession {
  std::string person_id, csrf_token, created_utc, last_seen_utc;
};
base::Status add_web_session(Store& store, const std::string& token_hash,
                             const WebSession& session);
base::Result<WebSession> web_session(Store& store, const std::string& token_hash);  // not_found
base::Status touch_web_session(Store& store, const std::string& token_hash);  // last_seen = now
base::Status end_web_session(Store& store, const std::string& token_hash);
base::Status end_web_sessions_of(Store& store, const std::string& person_id);
base::Status note_sign_in(Store& store, const std::string& person_id);  // now
// A password of one's own choice: ends all other sessions and every link that would set another.
base::Status change_own_password(Store& store, const std::string& person_id, const std::string& phc,
                                 const std::string& kept_session_hash);
// Removes the sessions last seen before that time, which have expired. How many.
base::Result<int> end_web_sessions_before(Store& store, const std::string& utc);

}  // namespace database
