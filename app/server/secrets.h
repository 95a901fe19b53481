// Random tokens. Only their hash is stored, so that a stolen database opens nothing.
#pragma once

#include <string>

namespace app {

std::string new_token();                                              // 256 random bits, URL-safe
std::string token_hash(const std::string& token);                     // SHA-256, hex
bool same_secret(const std::string& left, const std::string& right);  // in constant time

}  // namespace app
