#include "database/curriculum_drafts.h"

#include <utility>

#include "database/audit_chain.h"
#include "database/connection.h"
#include "database/curriculum_rows.h"
#include "database/text_limits.h"
#include "database/training_by_rows.h"

namespace database {
namespace {

using base::Error;
using base::ErrorCode;

constexpr const char* kSelect =
    "SELECT d.curriculum_id, d.yaml, d.sha256, d.from_version, d.saved_utc, d.saved_by, "
    "coalesce(i.display_name, d.saved_by) FROM curriculum_draft d "
    "LEFT JOIN identity i ON i.person_id = d.saved_by WHERE ";

std::vector<CurriculumDraft> load_drafts(soci::session& sql, const std::string& condition,
                                         const std::string& value) {
  std::vector<CurriculumDraft> drafts;
  CurriculumDraft draft;
  soci::statement select =
      (sql.prepare << kSelect + condition + " ORDER BY d.curriculum_id", soci::use(value),
       soci::into(draft.curriculum_id), soci::into(draft.yaml), soci::into(draft.sha256),
       soci::into(draft.from_version), soci::into(draft.saved_utc), soci::into(draft.saved_by),
       soci::into(draft.saved_by_name));
  select.execute();
  while (select.fetch()) drafts.push_back(draft);
  return drafts;
}

base::Result<CurriculumDraft> load_draft(soci::session& sql, const std::string& curriculum_id) {
  std::vector<CurriculumDraft> found = load_drafts(sql, "d.curriculum_id = :value", curriculum_id);
  if (!found.empty()) return std::move(found.front());
  return Error{ErrorCode::not_found,
               "There is no draft of '" + curriculum_id + "': copy a version to begin one."};
}

base::Status check_draft(const CurriculumDraft& draft, const std::string& actor) {
  if (base::Status status = check_name("actor", actor); !status) return status;
  if (base::Status status = check_name("id of the curriculum", draft.curriculum_id); !status) {
    return status;
  }
  return check_text("text of the curriculum", draft.yaml, kMaxDocument);
}

Error saved_meanwhile(const CurriculumDraft& stored) {
  return {ErrorCode::conflict, stored.saved_by_name + " saved this draft at " + stored.saved_utc +
                                   ": open it again to see that text, then make your change."};
}

std::string object_of(const std::string& curriculum_id) {
  return "curriculum_draft:" + curriculum_id;
}

int published_versions(soci::session& sql, const std::string& curriculum_id) {
  int count = 0;
  sql << "SELECT count(*) FROM curriculum_version "
         "WHERE curriculum_id = :id AND status = 'published'",
      soci::use(curriculum_id), soci::into(count);
  return count;
}

// Somebody would be left without a curriculum.
base::Status check_spare(soci::session& sql, const std::string& curriculum_id) {
  if (published_versions(sql, curriculum_id) > 1) return base::Done{};
  if (load_default_curriculum(sql) == curriculum_id) {
    return Error{ErrorCode::conflict,
                 "This is the only published version of the default curriculum: make another "
                 "curriculum the default first."};
  }
  const int people = assigned_to(sql, curriculum_id);
  if (people == 0) return base::Done{};
  return Error{ErrorCode::conflict, std::to_string(people) +
                                        (people == 1 ? " person trains" : " people train") +
                                        " by this, its only published version: assign them "
                                        "another curriculum first."};
}

}  // namespace

base::Result<std::vector<CurriculumDraft>> curriculum_drafts(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::vector<CurriculumDraft>> {
    return load_drafts(sql, ":value = ''", "");
  });
}

base::Result<CurriculumDraft> curriculum_draft(Store& store, const std::string& curriculum_id) {
  return reading(store, [&](soci::session& sql) { return load_draft(sql, curriculum_id); });
}

base::Result<CurriculumDraft> begin_draft(Store& store, const CurriculumDraft& draft,
                                          const std::string& actor) {
  if (base::Status status = check_draft(draft, actor); !status) return status.error();
  return writing(store, [&](soci::session& sql) -> base::Result<CurriculumDraft> {
    if (const auto stored = load_draft(sql, draft.curriculum_id)) {
      return Error{ErrorCode::conflict, "There is a draft of '" + draft.curriculum_id +
                                            "' already, saved by " + stored->saved_by_name +
                                            ": go on with that one, or delete it first."};
    }
    execute(sql,
            "INSERT INTO curriculum_draft (curriculum_id, yaml, sha256, from_version, saved_utc, "
            "saved_by) VALUES (:id, :yaml, :sha256, :from, :utc, :by)",
            draft.curriculum_id, draft.yaml, draft.sha256, draft.from_version, utc_now(), actor);
    add_audit(sql, {actor, "curriculum.begin_draft", object_of(draft.curriculum_id), "",
                    hash_of({draft.sha256})});
    return load_draft(sql, draft.curriculum_id);
  });
}

base::Result<CurriculumDraft> save_draft(Store& store, const CurriculumDraft& draft,
                                         const std::string& replaces_sha256,
                                         const std::string& actor) {
  if (base::Status status = check_draft(draft, actor); !status) return status.error();
  return writing(store, [&](soci::session& sql) -> base::Result<CurriculumDraft> {
    const auto stored = load_draft(sql, draft.curriculum_id);
    if (!stored) return stored.error();
    if (stored->sha256 == draft.sha256) return *stored;  // nothing to save
    if (stored->sha256 != replaces_sha256) return saved_meanwhile(*stored);
    execute(sql,
            "UPDATE curriculum_draft SET yaml = :yaml, sha256 = :sha256, saved_utc = :utc, "
            "saved_by = :by WHERE curriculum_id = :id",
            draft.yaml, draft.sha256, utc_now(), actor, draft.curriculum_id);
    add_audit(sql, {actor, "curriculum.save_draft", object_of(draft.curriculum_id),
                    hash_of({stored->sha256}), hash_of({draft.sha256})});
    return load_draft(sql, draft.curriculum_id);
  });
}

base::Status delete_draft(Store& store, const std::string& curriculum_id,
                          const std::string& actor) {
  if (base::Status status = check_name("actor", actor); !status) return status;
  return writing(store, [&](soci::session& sql) -> base::Status {
    const auto stored = load_draft(sql, curriculum_id);
    if (!stored) return stored.error();
    execute(sql, "DELETE FROM curriculum_draft WHERE curriculum_id = :id", curriculum_id);
    add_audit(sql, {actor, "curriculum.delete_draft", object_of(curriculum_id),
                    hash_of({stored->sha256}), ""});
    return base::Done{};
  });
}

base::Result<CurriculumVersion> publish_from_draft(Store& store, const CurriculumVersion& version,
                                                   const std::string& seen_sha256,
                                                   const std::string& actor) {
  if (base::Status status = check_curriculum_version(version); !status) return status.error();
  if (base::Status status = check_name("actor", actor); !status) return status.error();
  return writing(store, [&](soci::session& sql) -> base::Result<CurriculumVersion> {
    const auto stored = load_draft(sql, version.curriculum_id);
    if (!stored) return stored.error();
    if (stored->sha256 != seen_sha256) return saved_meanwhile(*stored);
    auto published = store_publication(sql, version, utc_now(), actor);
    if (!published) return published.error();
    execute(sql, "DELETE FROM curriculum_draft WHERE curriculum_id = :id", version.curriculum_id);
    return published;
  });
}

base::Status retire_curriculum(Store& store, const std::string& curriculum_id,
                               const std::string& version, const std::string& actor) {
  if (base::Status status = check_name("actor", actor); !status) return status;
  return writing(store, [&](soci::session& sql) -> base::Status {
    std::string row_id, status;
    sql << "SELECT id, status FROM curriculum_version "
           "WHERE curriculum_id = :id AND version = :version",
        soci::use(curriculum_id), soci::use(version), soci::into(row_id), soci::into(status);
    if (!sql.got_data()) {
      return Error{ErrorCode::not_found, "There is no version " + version + " of '" +
                                             curriculum_id + "': choose one from the list."};
    }
    if (status != "published") {
      return Error{ErrorCode::conflict,
                   "Version " + version + " is " + status + ": only a published one is retired."};
    }
    if (base::Status spare = check_spare(sql, curriculum_id); !spare) return spare;
    execute(sql, "UPDATE curriculum_version SET status = 'retired' WHERE id = :id", row_id);
    add_audit(sql, {actor, "curriculum.retire", "curriculum_version:" + row_id,
                    hash_of({row_id, "published"}), hash_of({row_id, "retired"})});
    return base::Done{};
  });
}

base::Result<std::vector<VersionSummary>> version_summaries(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::vector<VersionSummary>> {
    std::vector<VersionSummary> versions;
    VersionSummary version;
    soci::statement select =
        (sql.prepare << "SELECT v.curriculum_id, v.version, v.status, "
                        "coalesce(v.published_utc, ''), v.sha256, count(e.id), "
                        "coalesce(sum((SELECT count(*) FROM trial t "
                        "WHERE t.exercise_version_id = e.id)), 0) "
                        "FROM curriculum_version v "
                        "LEFT JOIN exercise_version e ON e.curriculum_version_id = v.id "
                        "GROUP BY v.id ORDER BY v.curriculum_id, v.publication DESC",
         soci::into(version.curriculum_id), soci::into(version.version), soci::into(version.status),
         soci::into(version.published_utc), soci::into(version.sha256),
         soci::into(version.exercises), soci::into(version.trials));
    select.execute();
    while (select.fetch()) versions.push_back(version);
    return versions;
  });
}

base::Result<std::map<std::string, int>> trainees_by_curriculum(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::map<std::string, int>> {
    std::map<std::string, int> counts;
    std::string curriculum;
    int people = 0;
    soci::statement select =
        (sql.prepare << "SELECT coalesce(c.curriculum_id, ''), count(*) FROM person p "
                        "JOIN identity i ON i.person_id = p.id "
                        "LEFT JOIN person_curriculum c ON c.person_id = p.id "
                        "WHERE p.kind = 'live' AND i.role = 'trainee' AND i.disabled = 0 "
                        "GROUP BY 1",
         soci::into(curriculum), soci::into(people));
    select.execute();
    while (select.fetch()) counts[curriculum] = people;
    return counts;
  });
}

}  // namespace database
