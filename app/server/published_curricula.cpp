#include "app/server/published_curricula.h"

#include <utility>

#include "database/curricula.h"

namespace app {
namespace {

// The one published last.
base::Result<database::CurriculumVersion> newest(database::Store& store) {
  auto versions = database::curriculum_versions(store);
  if (!versions) return versions.error();
  const database::CurriculumVersion* best = nullptr;
  for (const database::CurriculumVersion& version : *versions) {
    if (version.status != "published") continue;
    if (best == nullptr || version.published_utc > best->published_utc) best = &version;
  }
  if (best == nullptr) {
    return base::Error{base::ErrorCode::not_found,
                       "No curriculum is published yet; ask your administrator to publish one."};
  }
  return *best;
}

}  // namespace

base::Result<std::shared_ptr<const curricula::Curriculum>> PublishedCurricula::current(
    database::Store& store, const curricula::Catalogue& catalogue) {
  const auto version = newest(store);
  if (!version) return version.error();
  const std::lock_guard lock(mutex_);
  const auto found = by_hash_.find(version->sha256);
  if (found != by_hash_.end()) return found->second;

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
