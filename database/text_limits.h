// What text the store takes: valid UTF-8, without NUL, of a bounded length. Text from outside is
// only ever bound as a parameter; these limits keep it readable, not safe.
#pragma once

#include <cstddef>
#include <string>

#include "sim/base/result.h"

namespace database {

inline constexpr std::size_t kMaxName = 128;          // bytes: names, ids, words
inline constexpr std::size_t kMaxText = 4000;         // bytes: reasons, sentences, hashes
inline constexpr std::size_t kMaxDocument = 4 << 20;  // bytes: the text of a curriculum

// Names are one line: no control characters, not empty, no blanks around.
base::Status check_name(const char* what, const std::string& text);
// One address, of the form NAME@HOST; empty is none. Whether it exists only a letter can tell.
base::Status check_email(const std::string& text);
// Text may be empty and have several lines.
base::Status check_text(const char* what, const std::string& text, std::size_t max = kMaxText);

}  // namespace database
