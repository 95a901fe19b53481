// Every answer that says no: a status and one sentence, the wire's Problem.
#pragma once

#include <string>

#include "app/server/message.h"
#include "sim/base/result.h"

namespace app {

Response problem(int status, const std::string& code, const std::string& sentence);
// The one place where an error of the program becomes a status of HTTP.
int http_status(base::ErrorCode code);
Response problem(const base::Error& error);

}  // namespace app
