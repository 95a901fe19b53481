#include "app/session/trial_keeper.h"

#include <utility>

namespace app {

FilingKeeper::FilingKeeper(std::string database_url, std::string trial_id)
    : database_url_(std::move(database_url)), trial_id_(std::move(trial_id)) {}

base::Status FilingKeeper::open() {
  auto store = database::Store::open(database_url_);
  if (!store) return store.error();
  store_ = *std::move(store);
  return base::Done{};
}

base::Status FilingKeeper::append(std::span<const RecordedSecond> seconds) {
  return app::append(*store_, trial_id_, seconds);
}

base::Result<Judgement> FilingKeeper::finish(TrialRun& run, const curricula::Exercise& exercise,
                                             const WallTime& wall) {
  return app::finish(*store_, trial_id_, run, exercise, wall);
}

base::Result<Judgement> PracticeKeeper::finish(TrialRun& run, const curricula::Exercise& exercise,
                                               const WallTime& wall) {
  return judge(exercise, run, wall);
}

}  // namespace app
