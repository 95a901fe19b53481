// A comment on the wire.
#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "database/comments.h"

namespace app {

nlohmann::json comment_json(const database::Comment& comment, const std::string& viewer_id);

}  // namespace app
