#include "app/session/build_info.h"

#include <cstddef>
#include <fstream>
#include <iterator>
#include <vector>

#include "app/session/recording.h"

namespace app {

const std::string& build_id() {
  static const std::string kBuild = [] {
    std::ifstream file("/proc/self/exe", std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(file), {}};
    const auto* data = reinterpret_cast<const std::byte*>(bytes.data());
    return std::string(kVersion) + "+" + sha256_hex({data, bytes.size()}).substr(0, 12);
  }();
  return kBuild;
}

}  // namespace app
