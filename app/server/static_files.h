// The built browser application. Any path that is no file is the application's own page, which
// shows it or says that it does not know it.
#pragma once

#include <filesystem>
#include <string>

#include "app/server/message.h"

namespace app {

// The content's type by the file's ending; application/octet-stream when unknown.
std::string mime_type(const std::filesystem::path& file);

Response static_file(const Request& request, const std::filesystem::path& web_root);

}  // namespace app
