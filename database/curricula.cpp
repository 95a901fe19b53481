#include "database/curricula.h"

#include <utility>

#include "database/audit_chain.h"
#include "database/connection.h"
#include "database/curriculum_rows.h"
#include "database/person_rows.h"
#include "database/text_limits.h"
#include "database/training_by_rows.h"
#include "database/utc.h"

namespace database {
namespace {

using base::Error;
using base::ErrorCode;

base::Status check_exercise(const ExerciseVersion& exercise) {
  if (base::Status status = check_name("id of the exercise", exercise.exercise_id); !status) {
    return status;
  }
  return check_text("text of the exercise", exercise.yaml, kMaxDocument);
}

std::vector<ExerciseVersion> load_exercises(soci::session& sql, const std::string& condition,
                                            const std::string& value) {
  std::vector<ExerciseVersion> exercises;
  ExerciseVersion exercise;
  soci::statement select =
      (sql.prepare << "SELECT id, exercise_id, version, yaml FROM exercise_version WHERE " +
                          condition + " ORDER BY position",
       soci::use(value), soci::into(exercise.id), soci::into(exercise.exercise_id),
       soci::into(exercise.version), soci::into(exercise.yaml));
  select.execute();
  while (select.fetch()) exercises.push_back(exercise);
  return exercises;
}

std::vector<BenchmarkVersion> load_benchmarks(soci::session& sql, const std::string& row_id) {
  std::vector<BenchmarkVersion> benchmarks;
  BenchmarkVersion benchmark;
  int provisional = 0;
  soci::statement select =
      (sql.prepare << "SELECT benchmark_id, metric, rule, provisional, value, dataset "
                      "FROM benchmark WHERE curriculum_version_id = :id ORDER BY position",
       soci::use(row_id), soci::into(benchmark.id), soci::into(benchmark.metric),
       soci::into(benchmark.rule), soci::into(provisional), soci::into(benchmark.value),
       soci::into(benchmark.dataset));
  select.execute();
  while (select.fetch()) {
    benchmark.provisional = provisional != 0;
    benchmarks.push_back(benchmark);
  }
  return benchmarks;
}

// Versions with their exercises. `condition` holds the parameter :value once.
std::vector<CurriculumVersion> load_versions(soci::session& sql, const std::string& condition,
                                             const std::string& value) {
  std::vector<CurriculumVersion> versions;
  CurriculumVersion version;
  soci::statement select =
      (sql.prepare << "SELECT id, curriculum_id, version, sha256, yaml, status, "
                      "coalesce(published_utc, '') FROM curriculum_version WHERE " +
                          condition,
       soci::use(value), soci::into(version.row_id), soci::into(version.curriculum_id),
       soci::into(version.version), soci::into(version.sha256), soci::into(version.yaml),
       soci::into(version.status), soci::into(version.published_utc));
  select.execute();
  while (select.fetch()) versions.push_back(version);
  for (CurriculumVersion& each : versions) {
    each.exercises = load_exercises(sql, "curriculum_version_id = :value", each.row_id);
    each.benchmarks = load_benchmarks(sql, each.row_id);
  }
  return versions;
}

std::string hash_of_version(const CurriculumVersion& version) {
  return hash_of(
      {version.row_id, version.curriculum_id, version.version, version.sha256, version.status});
}

void insert_exercises(soci::session& sql, const CurriculumVersion& version,
                      const std::string& row_id) {
  int position = 0;
  for (const ExerciseVersion& exercise : version.exercises) {
    execute(sql,
            "INSERT INTO exercise_version (id, curriculum_version_id, position, exercise_id, "
            "version, yaml) VALUES (:id, :of, :position, :exercise, :version, :yaml)",
            new_id(), row_id, position, exercise.exercise_id, exercise.version, exercise.yaml);
    ++position;
  }
  position = 0;
  for (const BenchmarkVersion& benchmark : version.benchmarks) {
    execute(sql,
            "INSERT INTO benchmark (curriculum_version_id, position, benchmark_id, metric, rule, "
            "provisional, value, dataset) VALUES (:of, :position, :id, :metric, :rule, "
            ":provisional, :value, :dataset)",
            row_id, position, benchmark.id, benchmark.metric, benchmark.rule,
            benchmark.provisional ? 1 : 0, benchmark.value, benchmark.dataset);
    ++position;
  }
}

int next_publication(soci::session& sql, const std::string& curriculum_id) {
  int publication = 0;
  sql << "SELECT coalesce(max(publication), 0) + 1 FROM curriculum_version "
         "WHERE curriculum_id = :id",
      soci::use(curriculum_id), soci::into(publication);
  return publication;
}

// A second curriculum must not take over by being the newest.
void keep_default(soci::session& sql, const CurriculumVersion& version, const std::string& actor) {
  if (version.status == "published") fix_default_curriculum(sql, actor);
}

std::string insert_version(soci::session& sql, const CurriculumVersion& version,
                           const std::string& published_utc) {
  std::string row_id = new_id();
  const bool draft = version.status == "draft";
  const int publication = draft ? 0 : next_publication(sql, version.curriculum_id);
  execute(sql,
          "INSERT INTO curriculum_version (id, curriculum_id, version, sha256, yaml, status, "
          "publication, published_utc) VALUES (:id, :curriculum, :version, :sha256, :yaml, "
          ":status, :publication, nullif(:utc, ''))",
          row_id, version.curriculum_id, version.version, version.sha256, version.yaml,
          version.status, publication, draft ? std::string() : published_utc);
  insert_exercises(sql, version, row_id);
  return row_id;
}

void publish_draft(soci::session& sql, const CurriculumVersion& draft,
                   const std::string& published_utc) {
  execute(sql,
          "UPDATE curriculum_version SET status = 'published', publication = :publication, "
          "published_utc = :utc WHERE id = :id",
          next_publication(sql, draft.curriculum_id), published_utc, draft.row_id);
}

std::vector<CurriculumVersion> load_version(soci::session& sql, const std::string& row_id) {
  return load_versions(sql, "id = :value", row_id);
}

// The stored version of the same curriculum and number, if any.
std::vector<CurriculumVersion> load_same(soci::session& sql, const CurriculumVersion& version) {
  std::string row_id;
  sql << "SELECT id FROM curriculum_version WHERE curriculum_id = :id AND version = :version",
      soci::use(version.curriculum_id), soci::use(version.version), soci::into(row_id);
  if (!sql.got_data()) return {};
  return load_version(sql, row_id);
}

constexpr const char* kNewestPublished =
    "curriculum_id = :value AND status = 'published' ORDER BY publication DESC LIMIT 1";

}  // namespace

base::Status check_curriculum_version(const CurriculumVersion& version) {
  if (base::Status status = check_name("id of the curriculum", version.curriculum_id); !status) {
    return status;
  }
  if (base::Status status = check_name("version", version.version); !status) return status;
  if (base::Status status = check_name("hash", version.sha256); !status) return status;
  if (version.status != "draft" && version.status != "published" && version.status != "retired") {
    return Error{ErrorCode::invalid_input,
                 "The status of a curriculum is draft, published or retired."};
  }
  for (const ExerciseVersion& exercise : version.exercises) {
    if (base::Status status = check_exercise(exercise); !status) return status;
  }
  for (const BenchmarkVersion& benchmark : version.benchmarks) {
    if (base::Status status = check_name("id of the benchmark", benchmark.id); !status) {
      return status;
    }
  }
  return check_text("text of the curriculum", version.yaml, kMaxDocument);
}

base::Result<CurriculumVersion> store_publication(soci::session& sql,
                                                  const CurriculumVersion& version,
                                                  const std::string& utc,
                                                  const std::string& actor) {
  const std::vector<CurriculumVersion> same = load_same(sql, version);
  std::string before_hash, row_id;
  if (same.empty()) {
    keep_default(sql, version, actor);
    row_id = insert_version(sql, version, utc);
  } else {
    const CurriculumVersion& stored = same.front();
    if (stored.sha256 != version.sha256) {
      return Error{ErrorCode::conflict, "Version " + version.version + " of " +
                                            version.curriculum_id +
                                            " is stored with another text; give the changed "
                                            "text a new version."};
    }
    if (stored.status != "draft" || version.status != "published") return stored;
    row_id = stored.row_id;
    before_hash = hash_of_version(stored);
    keep_default(sql, version, actor);
    publish_draft(sql, stored, utc);
  }
  const CurriculumVersion result = load_version(sql, row_id).front();
  add_audit(sql, {actor, "curriculum.publish", "curriculum_version:" + row_id, before_hash,
                  hash_of_version(result)});
  return result;
}

base::Result<CurriculumVersion> publish_curriculum(Store& store, const CurriculumVersion& version,
                                                   const std::string& actor) {
  if (base::Status status = check_curriculum_version(version); !status) return status.error();
  if (base::Status status = check_name("actor", actor); !status) return status.error();
  const base::Result<std::string> utc = stored_utc(version.published_utc);
  if (!utc) return utc.error();
  return writing(store,
                 [&](soci::session& sql) { return store_publication(sql, version, *utc, actor); });
}

base::Result<std::vector<CurriculumVersion>> curriculum_versions(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::vector<CurriculumVersion>> {
    return load_versions(sql, ":value = '' ORDER BY curriculum_id, id", "");
  });
}

base::Result<CurriculumVersion> current_curriculum(Store& store, const std::string& curriculum_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<CurriculumVersion> {
    std::vector<CurriculumVersion> found = load_versions(sql, kNewestPublished, curriculum_id);
    if (found.empty()) {
      return Error{ErrorCode::not_found, "No version of this curriculum is published."};
    }
    return std::move(found.front());
  });
}

base::Result<std::string> current_curriculum_sha256(Store& store,
                                                    const std::string& curriculum_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<std::string> {
    std::string sha256;
    sql << "SELECT sha256 FROM curriculum_version WHERE " + std::string(kNewestPublished),
        soci::use(curriculum_id), soci::into(sha256);
    if (!sql.got_data()) {
      return Error{ErrorCode::not_found, "No version of this curriculum is published."};
    }
    return sha256;
  });
}

base::Result<ExerciseVersion> current_exercise(Store& store, const std::string& curriculum_id,
                                               const std::string& exercise_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<ExerciseVersion> {
    std::string row_id;
    sql << "SELECT e.id FROM exercise_version e WHERE e.exercise_id = :exercise "
           "AND e.curriculum_version_id = (SELECT id FROM curriculum_version WHERE " +
               std::string(kNewestPublished) + ")",
        soci::use(exercise_id), soci::use(curriculum_id), soci::into(row_id);
    if (!sql.got_data()) {
      return Error{ErrorCode::not_found,
                   "The published version of this curriculum has no such exercise."};
    }
    return load_exercises(sql, "id = :value", row_id).front();
  });
}

base::Result<ExerciseVersion> exercise_version(Store& store, const std::string& row_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<ExerciseVersion> {
    std::vector<ExerciseVersion> found = load_exercises(sql, "id = :value", row_id);
    if (found.empty()) {
      return Error{ErrorCode::not_found, "There is no such version of an exercise."};
    }
    return std::move(found.front());
  });
}

base::Result<std::string> enrol(Store& store, const std::string& person_id,
                                const std::string& curriculum_id) {
  return writing(store, [&](soci::session& sql) -> base::Result<std::string> {
    if (const auto person = load_person(sql, person_id); !person) return person.error();
    std::string id;
    sql << "SELECT id FROM enrolment WHERE person_id = :person AND curriculum_id = :curriculum",
        soci::use(person_id), soci::use(curriculum_id), soci::into(id);
    if (sql.got_data()) return id;
    std::string version_id;
    sql << "SELECT id FROM curriculum_version WHERE " + std::string(kNewestPublished),
        soci::use(curriculum_id), soci::into(version_id);
    if (!sql.got_data()) {
      return Error{ErrorCode::not_found, "No version of this curriculum is published."};
    }
    id = new_id();
    execute(sql,
            "INSERT INTO enrolment (id, person_id, curriculum_id, curriculum_version_id, "
            "enrolled_utc) VALUES (:id, :person, :curriculum, :version, :utc)",
            id, person_id, curriculum_id, version_id, utc_now());
    add_audit(sql, {"system", "person.enrol", "enrolment:" + id, "",
                    hash_of({id, person_id, curriculum_id, version_id})});
    return id;
  });
}

}  // namespace database
