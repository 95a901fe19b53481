// An editable draft of a curriculum: its own text, comments and all, under a new id.
#pragma once

#include <string>

#include "curricula/curriculum.h"
#include "sim/base/result.h"

namespace curricula {

// The text of `source` with the id `new_id`, version 1.0.0 and status draft. Everything else stays
// as it is written. `invalid_input` when the id is none or is the source's own.
base::Result<std::string> copy_as_draft(const Curriculum& source, const std::string& new_id);

}  // namespace curricula
