#include <array>
#include <chrono>
#include <cstdint>

#include <sodium.h>

#include "database/store.h"
#include "sim/base/require.h"

namespace database {

// RFC 9562, 5.7: 48 bits of Unix time in ms, then random bits around version and variant. Keys
// made later sort later, so new rows go to the end of an index.
std::string new_id() {
  // more threads than one may come here first
  static const bool ready = sodium_init() >= 0;
  base::require(ready, "libsodium must be usable");
  std::array<std::uint8_t, 16> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  auto time_ms = static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::milliseconds>(now).count());
  for (std::size_t i = 6; i-- > 0; time_ms >>= 8) {
    bytes[i] = static_cast<std::uint8_t>(time_ms & 0xff);
  }
  bytes[6] = static_cast<std::uint8_t>(0x70 | (bytes[6] & 0x0f));
  bytes[8] = static_cast<std::uint8_t>(0x80 | (bytes[8] & 0x3f));

  const char* digits = "0123456789abcdef";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i == 4 || i == 6 || i == 8 || i == 10) text += '-';
    text += digits[bytes[i] >> 4];
    text += digits[bytes[i] & 0x0f];
  }
  return text;
}

}  // namespace database
