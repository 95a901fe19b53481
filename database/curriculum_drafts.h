// Drafts of curricula: one per curriculum, kept as it was last saved, right or wrong, until it is
// published or thrown away.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "database/curricula.h"
#include "database/store.h"

namespace database {

struct CurriculumDraft {
  std::string curriculum_id, yaml, sha256;
  std::string from_version;  // "vascular-basics@1.0.0"
  std::string saved_utc;
  std::string saved_by;       // id of the person
  std::string saved_by_name;  // display name, where there is one
};

base::Result<std::vector<CurriculumDraft>> curriculum_drafts(Store& store);  // by id
base::Result<CurriculumDraft> curriculum_draft(Store& store,
                                               const std::string& curriculum_id);  // not_found
// conflict: there is one already.
base::Result<CurriculumDraft> begin_draft(Store& store, const CurriculumDraft& draft,
                                          const std::string& actor);
// conflict: what is stored is not `replaces_sha256`; the sentence says who saved it and when.
base::Result<CurriculumDraft> save_draft(Store& store, const CurriculumDraft& draft,
                                         const std::string& replaces_sha256,
                                         const std::string& actor);
base::Status delete_draft(Store& store, const std::string& curriculum_id, const std::string& actor);
// Publishes `version`, made of the draft whose hash is `seen_sha256`, and removes the draft, in
// one transaction. conflict: the draft is another by now, or the version exists.
base::Result<CurriculumVersion> publish_from_draft(Store& store, const CurriculumVersion& version,
                                                   const std::string& seen_sha256,
                                                   const std::string& actor);
// Takes a published version out of use. conflict: it is the last published one of the default
// curriculum, or of one that people are assigned to; or not published.
base::Status retire_curriculum(Store& store, const std::string& curriculum_id,
                               const std::string& version, const std::string& actor);

// A version in a list, without its text.
struct VersionSummary {
  std::string curriculum_id, version, status, published_utc, sha256;
  int exercises = 0;
  int trials = 0;  // made under it
};
base::Result<std::vector<VersionSummary>> version_summaries(Store& store);  // newest first
// How many live trainees, not disabled, are assigned each; "" counts those with the default.
base::Result<std::map<std::string, int>> trainees_by_curriculum(Store& store);

}  // namespace database
