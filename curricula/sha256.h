// The fingerprint of a file: what a trial stores of the curriculum and catalogue it ran under.
#pragma once

#include <string>
#include <string_view>

namespace curricula {

std::string sha256_hex(std::string_view bytes);  // 64 small hexadecimal digits

}  // namespace curricula
