#include "app/session/build_info.h"

#include <cstddef>
#include <fstream>
#include <span>
#include <vector>

#include "app/session/recording.h"

namespace app {

const std::string& build_id() {
  static const std::string kBuild = [] {
    std::ifstream file("/proc/self/exe", std::ios::binary);
    file.seekg(0, std::ios::end);
    std::vector<char> bytes(static_cast<std::size_t>(file.tellg()));
    file.seekg(0);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return std::string(kVersion) + "+" + sha256_hex(std::as_bytes(std::span(bytes))).substr(0, 12);
  }();
  return kBuild;
}

}  // namespace app
