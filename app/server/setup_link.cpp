#include "app/server/setup_link.h"

#include <algorithm>
#include <cctype>
#include <ctime>
#include <optional>

#include "app/server/expiry.h"
#include "app/server/passwords.h"
#include "app/server/secrets.h"
#include "database/people.h"

namespace app {
namespace {

constexpr std::time_t kGoodFor = 24 * 3600;  // s

base::Error refuse(base::ErrorCode code, const char* sentence) { return {code, sentence}; }

base::Status check_name(const std::string& name) {
  const bool printable =
      std::none_of(name.begin(), name.end(), [](unsigned char c) { return std::iscntrl(c) != 0; });
  const bool padded = !name.empty() && (name.front() == ' ' || name.back() == ' ');
  if (name.empty() || name.size() > 64 || !printable || padded) {
    return refuse(base::ErrorCode::invalid_input,
                  "Choose a name of 1 to 64 characters, without a blank at its ends.");
  }
  return base::Done{};
}

// The administrator of this name, nobody, or conflict.
base::Result<std::optional<database::Person>> administrator(database::Store& store,
                                                            const std::string& name) {
  auto person = database::person_by_name(store, name);
  if (!person) {
    if (person.error().code == base::ErrorCode::not_found) return std::optional<database::Person>{};
    return person.error();
  }
  if (person->role != database::Role::administrator || person->kind != database::PersonKind::live) {
    return refuse(base::ErrorCode::conflict,
                  "This name belongs to somebody who is no administrator; choose another.");
  }
  return std::optional<database::Person>(*std::move(person));
}

base::Result<std::string> let_in_again(database::Store& store, const database::Person& person,
                                       const std::string& phc) {
  if (const auto set = database::set_password(store, person.id, phc, "system"); !set) {
    return set.error();
  }
  if (person.disabled) {
    const auto enabled = database::set_disabled(store, person.id, false, "system");
    if (!enabled) return enabled.error();
  }
  if (const auto ended = database::end_web_sessions_of(store, person.id); !ended) {
    return ended.error();
  }
  return person.id;
}

}  // namespace

base::Result<std::string> make_setup_token(database::Store& store) {
  std::string token = new_token();
  const auto added = database::add_setup_token(store, token_hash(token), utc_in(kGoodFor));
  if (!added) return added.error();
  return token;
}

base::Result<bool> needs_setup(database::Store& store) {
  const auto everybody = database::people(store);
  if (!everybody) return everybody.error();
  return std::none_of(everybody->begin(), everybody->end(), [](const database::Person& person) {
    return person.role == database::Role::administrator && !person.disabled &&
           !person.password_phc.empty();
  });
}

base::Result<std::string> use_setup_link(database::Store& store, const std::string& token,
                                         const std::string& name, const std::string& password) {
  if (const auto named = check_name(name); !named) return named.error();
  if (const auto good = check_new_password(password, name); !good) return good.error();
  const auto existing = administrator(store, name);
  if (!existing) return existing.error();

  const auto used = database::use_setup_token(store, token_hash(token));
  if (!used) return used.error();
  if (!*used) {
    return refuse(
        base::ErrorCode::denied,
        "This set-up link is used up or too old; make a new one with: cathedra user reset");
  }
  const auto phc = hash_password(password);
  if (!phc) return phc.error();
  if (*existing) return let_in_again(store, **existing, *phc);

  database::NewPerson person;
  person.name = name;
  person.display_name = name;
  person.role = database::Role::administrator;
  person.password_phc = *phc;
  const auto added = database::add_person(store, person, "system");
  if (!added) return added.error();
  return added->id;
}

}  // namespace app
