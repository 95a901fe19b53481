// An editable draft of a curriculum: its own text, comments and all, under a new id.
#pragma once

#include <string>

#include "curricula/curriculum.h"
#include "sim/base/result.h"

namespace curricula {

// The text of `source` with the id `new_id`, version 1.0.0 and status draft. Everything else stays
// as it is written. `invalid_input` when the id is none or is the source's own.
base::Result<std::string> copy_as_draft(const Curriculum& source, const std::string& new_id);

// The text with another version and status draft: the next version of the same curriculum.
// corrupt_data when the text has no version or status to replace.
base::Result<std::string> next_draft(const std::string& yaml, const std::string& version);

// The text as it is published: its status says so, nothing else changes.
base::Result<std::string> as_published(const std::string& yaml);

}  // namespace curricula
