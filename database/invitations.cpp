#include "database/invitations.h"

#include "database/audit_chain.h"
#include "database/connection.h"
#include "database/invitation_rows.h"
#include "database/person_rows.h"
#include "database/text_limits.h"
#include "database/utc.h"

namespace database {
namespace {

using base::Error;
using base::ErrorCode;

// The same whatever is wrong with the link, so that nobody learns which ones there were.
Error no_such_link() {
  return {ErrorCode::denied,
          "This link is used up, withdrawn or too old; ask your administrator for a new one."};
}

base::Status check_can_be_invited(const Person& person) {
  if (person.kind != PersonKind::live) {
    return Error{ErrorCode::conflict, person.display_name + " stands for " + word(person.kind) +
                                          " trials and never signs in; invite a person instead."};
  }
  if (person.disabled) {
    return Error{ErrorCode::conflict,
                 person.display_name + " is disabled; enable the account before inviting."};
  }
  return base::Done{};
}

base::Result<OpenInvitation> load_open(soci::session& sql, const std::string& token_hash) {
  std::string person_id;
  OpenInvitation found;
  const std::string now = utc_now();
  sql << "SELECT person_id, expires_utc FROM invitation WHERE token_hash = :hash "
         "AND used_utc IS NULL AND withdrawn_utc IS NULL AND expires_utc > :now",
      soci::use(token_hash), soci::use(now), soci::into(person_id), soci::into(found.expires_utc);
  if (!sql.got_data()) return no_such_link();
  base::Result<Person> person = load_person(sql, person_id);
  if (!person || !check_can_be_invited(*person)) return no_such_link();
  found.person = *std::move(person);
  return found;
}

}  // namespace

void withdraw_invitations(soci::session& sql, const std::string& person_id) {
  execute(sql,
          "UPDATE invitation SET withdrawn_utc = :now WHERE person_id = :id "
          "AND used_utc IS NULL AND withdrawn_utc IS NULL",
          utc_now(), person_id);
}

base::Status insert_invitation(soci::session& sql, const Person& person, const InvitationLink& link,
                               const std::string& actor) {
  if (base::Status status = check_name("hash of the token", link.token_hash); !status) {
    return status;
  }
  if (base::Status status = check_can_be_invited(person); !status) return status;
  const base::Result<std::string> expires = stored_utc(link.expires_utc);
  if (!expires) return expires.error();
  withdraw_invitations(sql, person.id);
  execute(sql,
          "INSERT INTO invitation (token_hash, person_id, created_utc, created_by, expires_utc) "
          "VALUES (:hash, :person, :now, :by, :expires)",
          link.token_hash, person.id, utc_now(), actor, *expires);
  add_audit(sql, {actor, "person.invite", "person:" + person.id, "", hash_of({link.token_hash})});
  return base::Done{};
}

base::Status add_invitation(Store& store, const std::string& person_id, const InvitationLink& link,
                            const std::string& actor) {
  if (base::Status status = check_name("actor", actor); !status) return status;
  return writing(store, [&](soci::session& sql) -> base::Status {
    const base::Result<Person> person = load_person(sql, person_id);
    if (!person) return person.error();
    return insert_invitation(sql, *person, link, actor);
  });
}

base::Result<Person> invite_person(Store& store, const NewPerson& person,
                                   const InvitationLink& link, const std::string& actor) {
  if (base::Status status = check_name("actor", actor); !status) return status.error();
  return writing(store, [&](soci::session& sql) -> base::Result<Person> {
    const base::Result<std::string> id = insert_new_person(sql, person, actor);
    if (!id) return id.error();
    base::Result<Person> added = load_person(sql, *id);
    if (!added) return added.error();
    if (base::Status invited = insert_invitation(sql, *added, link, actor); !invited) {
      return invited.error();
    }
    return added;
  });
}

base::Result<OpenInvitation> open_invitation(Store& store, const std::string& token_hash) {
  return reading(store, [&](soci::session& sql) { return load_open(sql, token_hash); });
}

base::Result<Person> accept_invitation(Store& store, const std::string& token_hash,
                                       const std::string& phc) {
  if (base::Status status = check_name("password hash", phc); !status) return status.error();
  return writing(store, [&](soci::session& sql) -> base::Result<Person> {
    const base::Result<OpenInvitation> open = load_open(sql, token_hash);
    if (!open) return open.error();
    const std::string& id = open->person.id;
    execute(sql, "UPDATE invitation SET used_utc = :now WHERE token_hash = :hash", utc_now(),
            token_hash);
    const base::Status set = change_person(sql, id, id, "person.join", [&] {
      execute(sql, "UPDATE identity SET password_phc = :phc WHERE person_id = :id", phc, id);
      end_sessions(sql, id);
    });
    if (!set) return set.error();
    return load_person(sql, id);
  });
}

base::Result<std::optional<std::string>> invitation_expires(Store& store,
                                                            const std::string& person_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<std::optional<std::string>> {
    std::string expires;
    const std::string now = utc_now();
    sql << "SELECT expires_utc FROM invitation WHERE person_id = :id AND used_utc IS NULL "
           "AND withdrawn_utc IS NULL AND expires_utc > :now",
        soci::use(person_id), soci::use(now), soci::into(expires);
    if (!sql.got_data()) return std::optional<std::string>{};
    return std::optional<std::string>(expires);
  });
}

}  // namespace database
