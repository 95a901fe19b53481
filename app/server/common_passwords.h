// Passwords that are tried first by whoever guesses; only those long enough to be accepted else.
#pragma once

#include <string_view>

namespace app {

bool is_common_password(std::string_view lower_case);

}  // namespace app
