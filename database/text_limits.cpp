#include "database/text_limits.h"

#include <cstdint>

namespace database {
namespace {

// How many bytes the character that begins with `lead` has; 0 when none begins so.
std::size_t character_length(unsigned char lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xc2 && lead <= 0xdf) return 2;
  if (lead >= 0xe0 && lead <= 0xef) return 3;
  if (lead >= 0xf0 && lead <= 0xf4) return 4;
  return 0;
}

// The range of the second byte excludes overlong forms, surrogates and what lies beyond U+10FFFF
// (Unicode 15, table 3-7).
bool second_byte_fits(unsigned char lead, unsigned char second) {
  switch (lead) {
    case 0xe0:
      return second >= 0xa0 && second <= 0xbf;
    case 0xed:
      return second >= 0x80 && second <= 0x9f;
    case 0xf0:
      return second >= 0x90 && second <= 0xbf;
    case 0xf4:
      return second >= 0x80 && second <= 0x8f;
    default:
      return second >= 0x80 && second <= 0xbf;
  }
}

bool is_utf8(const std::string& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(byte(i));
    if (length == 0 || i + length > text.size()) return false;
    if (length > 1 && !second_byte_fits(byte(i), byte(i + 1))) return false;
    for (std::size_t k = 2; k < length; ++k) {
      if ((byte(i + k) & 0xc0) != 0x80) return false;
    }
    i += length;
  }
  return true;
}

bool has_control_character(const std::string& text) {
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) return true;
  }
  return false;
}

base::Error refused(const char* what, const std::string& why) {
  return {base::ErrorCode::invalid_input, std::string("The ") + what + " " + why + "."};
}

}  // namespace

base::Status check_text(const char* what, const std::string& text, std::size_t max) {
  if (text.size() > max) {
    return refused(what, "is too long: " + std::to_string(text.size()) + " bytes, at most " +
                             std::to_string(max));
  }
  if (!is_utf8(text)) return refused(what, "is not valid UTF-8");
  if (text.find('\0') != std::string::npos) return refused(what, "holds a NUL character");
  return base::Done{};
}

base::Status check_name(const char* what, const std::string& text) {
  if (text.empty()) return refused(what, "is empty");
  if (base::Status status = check_text(what, text, kMaxName); !status) return status;
  if (has_control_character(text)) return refused(what, "holds a control character");
  if (text.front() == ' ' || text.back() == ' ') {
    return refused(what, "begins or ends with a blank");
  }
  return base::Done{};
}

base::Status check_email(const std::string& text) {
  constexpr std::size_t kLongest = 254;  // bytes, RFC 5321, 4.5.3.1.3
  if (text.empty()) return base::Done{};
  if (base::Status status = check_text("e-mail address", text, kLongest); !status) return status;
  const std::size_t at = text.find('@');
  const bool one_at = at != std::string::npos && text.find('@', at + 1) == std::string::npos;
  const bool both_sides = at != 0 && at + 1 != text.size();
  const bool one_word =
      !has_control_character(text) && text.find_first_of(" ,;:<>()[]\\\"") == std::string::npos;
  const bool dots_inside = text.back() != '.' && text.find("@.") == std::string::npos &&
                           text.find("..") == std::string::npos && text.front() != '.';
  if (one_at && both_sides && one_word && dots_inside) return base::Done{};
  return refused("e-mail address", "is not of the form name@clinic.example");
}

}  // namespace database
