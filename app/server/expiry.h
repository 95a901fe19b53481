// When something made now runs out.
#pragma once

#include <ctime>
#include <string>

namespace app {

std::string utc_in(std::time_t seconds);  // from now, as the database stores times

}  // namespace app
