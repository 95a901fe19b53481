#include "curricula/read_sources.h"

namespace curricula {

std::string read_sources(const YamlNode& node, const std::vector<std::string>& topics,
                         Problems& problems) {
  Fields fields(node, "'sources'", problems);
  std::string result;
  for (const std::string& topic : topics) {
    if (!result.empty()) result += "; ";
    result += topic + ": " + fields.need_word(topic, 2000);
  }
  fields.finish();
  return result;
}

}  // namespace curricula
