// Reads the JSON object in a request's body; every failure is a sentence.
#pragma once

#include <initializer_list>
#include <string>

#include <nlohmann/json.hpp>

#include "app/server/message.h"
#include "sim/base/result.h"

namespace app {

// An object with any fields. The content must be declared as JSON: a form of another site cannot do
// that. For fields that are not all text, see json_fields.h.
base::Result<nlohmann::json> read_json_object(const Request& request);

// An object with exactly these fields, each a string.
base::Result<nlohmann::json> read_text_fields(const Request& request,
                                              std::initializer_list<const char*> names);

Response json_response(const nlohmann::json& body, int status = 200);

}  // namespace app
