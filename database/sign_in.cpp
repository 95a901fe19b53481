#include "database/audit_chain.h"
#include "database/connection.h"
#include "database/people.h"
#include "database/person_rows.h"
#include "database/text_limits.h"
#include "database/utc.h"

namespace database {
namespace {

using base::Error;
using base::ErrorCode;

Error unknown_session() { return {ErrorCode::not_found, "There is no such session."}; }

}  // namespace

base::Status add_setup_token(Store& store, const std::string& token_hash,
                             const std::string& expires_utc) {
  if (base::Status status = check_name("hash of the token", token_hash); !status) return status;
  const base::Result<std::string> expires = stored_utc(expires_utc);
  if (!expires) return expires.error();
  return writing(store, [&](soci::session& sql) -> base::Status {
    execute(sql,
            "INSERT INTO setup_token (token_hash, created_utc, expires_utc) "
            "VALUES (:hash, :now, :expires)",
            token_hash, utc_now(), *expires);
    add_audit(sql, {"system", "setup_token.add", "setup_token", "", hash_of({token_hash})});
    return base::Done{};
  });
}

base::Result<bool> use_setup_token(Store& store, const std::string& token_hash) {
  return writing(store, [&](soci::session& sql) -> base::Result<bool> {
    const std::string now = utc_now();
    execute(sql,
            "UPDATE setup_token SET used_utc = :now "
            "WHERE token_hash = :hash AND used_utc IS NULL AND expires_utc > :limit",
            now, token_hash, now);
    const bool used = changed_rows(store.connection()) == 1;
    if (used) {
      add_audit(sql, {"system", "setup_token.use", "setup_token", hash_of({token_hash}), ""});
    }
    return used;
  });
}

base::Status add_web_session(Store& store, const std::string& token_hash,
                             const WebSession& session) {
  if (base::Status status = check_name("hash of the token", token_hash); !status) return status;
  if (base::Status status = check_text("CSRF token", session.csrf_token); !status) return status;
  const base::Result<std::string> created = stored_utc(session.created_utc);
  if (!created) return created.error();
  const base::Result<std::string> seen =
      session.last_seen_utc.empty() ? *created : stored_utc(session.last_seen_utc);
  if (!seen) return seen.error();
  return writing(store, [&](soci::session& sql) -> base::Status {
    execute(sql,
            "INSERT INTO web_session (token_hash, person_id, csrf_token, created_utc, "
            "last_seen_utc) VALUES (:hash, :person, :csrf, :created, :seen)",
            token_hash, session.person_id, session.csrf_token, *created, *seen);
    return base::Done{};
  });
}

base::Result<WebSession> web_session(Store& store, const std::string& token_hash) {
  return reading(store, [&](soci::session& sql) -> base::Result<WebSession> {
    WebSession session;
    sql << "SELECT person_id, csrf_token, created_utc, last_seen_utc FROM web_session "
           "WHERE token_hash = :hash",
        soci::use(token_hash), soci::into(session.person_id), soci::into(session.csrf_token),
        soci::into(session.created_utc), soci::into(session.last_seen_utc);
    if (!sql.got_data()) return unknown_session();
    return session;
  });
}

base::Status touch_web_session(Store& store, const std::string& token_hash) {
  return writing(store, [&](soci::session& sql) -> base::Status {
    execute(sql, "UPDATE web_session SET last_seen_utc = :now WHERE token_hash = :hash", utc_now(),
            token_hash);
    if (changed_rows(store.connection()) == 0) return unknown_session();
    return base::Done{};
  });
}

base::Status end_web_session(Store& store, const std::string& token_hash) {
  return writing(store, [&](soci::session& sql) -> base::Status {
    execute(sql, "DELETE FROM web_session WHERE token_hash = :hash", token_hash);
    return base::Done{};
  });
}

void end_sessions(soci::session& sql, const std::string& person_id, const std::string& kept_hash) {
  execute(sql, "DELETE FROM web_session WHERE person_id = :id AND token_hash <> :kept", person_id,
          kept_hash);
}

base::Status end_web_sessions_of(Store& store, const std::string& person_id) {
  return writing(store, [&](soci::session& sql) -> base::Status {
    end_sessions(sql, person_id);
    return base::Done{};
  });
}

base::Status note_sign_in(Store& store, const std::string& person_id) {
  return writing(store, [&](soci::session& sql) -> base::Status {
    execute(sql, "UPDATE identity SET last_sign_in_utc = :now WHERE person_id = :id", utc_now(),
            person_id);
    return base::Done{};
  });
}

base::Status change_own_password(Store& store, const std::string& person_id, const std::string& phc,
                                 const std::string& kept_session_hash) {
  if (base::Status status = check_text("password hash", phc); !status) return status;
  return writing(store, [&](soci::session& sql) {
    return change_person(sql, person_id, person_id, "person.password", [&] {
      execute(sql, "UPDATE identity SET password_phc = :phc WHERE person_id = :id", phc, person_id);
      end_sessions(sql, person_id, kept_session_hash);
      withdraw_invitations(sql, person_id);
    });
  });
}

base::Result<int> end_web_sessions_before(Store& store, const std::string& utc) {
  const base::Result<std::string> moment = stored_utc(utc);
  if (!moment) return moment.error();
  return writing(store, [&](soci::session& sql) -> base::Result<int> {
    execute(sql, "DELETE FROM web_session WHERE last_seen_utc < :utc", *moment);
    return changed_rows(store.connection());
  });
}

}  // namespace database
