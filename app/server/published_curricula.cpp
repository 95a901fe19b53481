#include "app/server/published_curricula.h"

#include <utility>

#include "database/curricula.h"
#include "database/training_by.h"

namespace app {

PublishedCurricula::Found PublishedCurricula::of_person(database::Store& store,
                                                        const curricula::Catalogue& catalogue,
                                                        const std::string& person_id) {
  const auto id = database::curriculum_of(store, person_id);
  if (!id) return id.error();
  return by_id(store, catalogue, *id);
}

PublishedCurricula::Found PublishedCurricula::standard(database::Store& store,
                                                       const curricula::Catalogue& catalogue) {
  const auto id = database::default_curriculum(store);
  if (!id) return id.error();
  return by_id(store, catalogue, *id);
}

PublishedCurricula::Found PublishedCurricula::by_id(database::Store& store,
                                                    const curricula::Catalogue& catalogue,
                                                    const std::string& curriculum_id) {
  const auto sha256 = database::current_curriculum_sha256(store, curriculum_id);
  if (!sha256) return sha256.error();
  const std::lock_guard lock(mutex_);
  const auto found = by_hash_.find(*sha256);
  if (found != by_hash_.end()) return found->second;

  const auto version = database::current_curriculum(store, curriculum_id);
  if (!version) return version.error();
  curricula::CheckResult checked = curricula::check(version->yaml, catalogue);
  if (!checked.ok()) {
    const std::string why =
        checked.problems.empty() ? "it is not readable" : checked.problems.front().message;
    return base::Error{base::ErrorCode::corrupt_data,
                       "The published curriculum cannot be used: " + why};
  }
  // shared: with requests that still use it when another is published
  auto curriculum = std::make_shared<const curricula::Curriculum>(*std::move(checked.curriculum));
  by_hash_.emplace(version->sha256, curriculum);
  return curriculum;
}

}  // namespace app
