// Publishing inside a transaction. For database/*.cpp only.
#pragma once

#include <string>

#include <soci/soci.h>

#include "database/curricula.h"

namespace database {

// As publish_curriculum(); `utc` is in the stored form.
base::Status check_curriculum_version(const CurriculumVersion& version);
base::Result<CurriculumVersion> store_publication(soci::session& sql,
                                                  const CurriculumVersion& version,
                                                  const std::string& utc, const std::string& actor);

}  // namespace database
