#include "app/session/publish_library.h"

#include "database/curricula.h"

namespace app {

base::Status publish(database::Store& store, const curricula::Curriculum& curriculum,
                     const std::string& actor) {
  database::CurriculumVersion version;
  version.curriculum_id = curriculum.id;
  version.version = curriculum.version;
  version.sha256 = curriculum.sha256;
  version.yaml = curriculum.yaml;
  version.status = "published";
  for (const curricula::Exercise& exercise : curriculum.exercises) {
    version.exercises.push_back({"", exercise.id, exercise.version, exercise.yaml});
  }
  const auto published = database::publish_curriculum(store, version, actor);
  if (!published) return published.error();
  return base::Done{};
}

base::Status publish_library(database::Store& store, const curricula::Library& library) {
  for (const curricula::Curriculum& curriculum : library.curricula) {
    if (curriculum.status != curricula::Lifecycle::published) continue;
    const base::Status published = publish(store, curriculum, "system");
    if (!published) return published.error();
  }
  return base::Done{};
}

}  // namespace app
