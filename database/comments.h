// What instructors wrote about trials. A comment that was taken back keeps its row without its
// text, so that the audit still has something to point at.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/store.h"

namespace database {

struct Comment {
  std::string id, trial_id, author_id, author_name, written_utc, text;
  std::optional<double> time_s;  // of the trial; none: of the whole
};

// The trial may still run. `text`: 1 to 2000 bytes. not_found: the trial.
base::Result<Comment> add_comment(Store& store, const std::string& trial_id,
                                  const std::string& author_id, const std::string& text,
                                  std::optional<double> time_s);
// Only one's own; denied otherwise, not_found when it is not there or was taken back before.
base::Status withdraw_comment(Store& store, const std::string& trial_id,
                              const std::string& comment_id, const std::string& author_id);
// Those not taken back: of the whole trial first, then by its time, then as they were written.
base::Result<std::vector<Comment>> trial_comments(Store& store, const std::string& trial_id);

}  // namespace database
