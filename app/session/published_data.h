// The paper's own result rows, loaded as published data: participants No.1 to No.6 on their own
// apparatus. Shown and compared, never a pass mark here, never pooled with trials made here.
#pragma once

#include <string>

#include "database/store.h"

namespace app {

inline constexpr const char* kPaperDataset = "paper";
inline constexpr const char* kPaperApparatus = "the paper's own VR simulator";

// Loads app/demo/published_trials.csv (task,group,participant,trial,seconds) unless the data set
// is already there. Returns how many rows were added. Fails with corrupt_data naming the line.
base::Result<int> load_published_data(database::Store& store, const std::string& csv_path);

}  // namespace app
