// What becomes of a live trial: filed in the database as it goes, or, for practice, judged at its
// end and kept nowhere. The trial's writer thread calls it, and nobody else.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "app/session/trial_file.h"
#include "app/session/trial_run.h"
#include "curricula/curriculum.h"
#include "database/store.h"

namespace app {

class TrialKeeper {
 public:
  virtual ~TrialKeeper() = default;

  virtual Recording recording() const = 0;
  // Before the first second.
  virtual base::Status open() = 0;
  // What the run has recorded since the last call. May be tried again when it failed.
  virtual base::Status append(std::span<const RecordedSecond> seconds) = 0;
  // Judges the ended run.
  virtual base::Result<Judgement> finish(TrialRun& run, const curricula::Exercise& exercise,
                                         const WallTime& wall) = 0;
};

// Files a trial that was begun in the database, over a connection of its own.
class FilingKeeper : public TrialKeeper {
 public:
  FilingKeeper(std::string database_url, std::string trial_id);

  Recording recording() const override { return Recording::written; }
  base::Status open() override;
  base::Status append(std::span<const RecordedSecond> seconds) override;
  base::Result<Judgement> finish(TrialRun& run, const curricula::Exercise& exercise,
                                 const WallTime& wall) override;

 private:
  std::string database_url_, trial_id_;
  std::unique_ptr<database::Store> store_;
};

class PracticeKeeper : public TrialKeeper {
 public:
  Recording recording() const override { return Recording::none; }
  base::Status open() override { return base::Done{}; }
  base::Status append(std::span<const RecordedSecond>) override { return base::Done{}; }
  base::Result<Judgement> finish(TrialRun& run, const curricula::Exercise& exercise,
                                 const WallTime& wall) override;
};

}  // namespace app
