#include "curricula/copy.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "curricula/fields.h"
#include "curricula/yaml_tree.h"

namespace curricula {
namespace {

// One past the last byte of a scalar as it is written, quotes included.
std::size_t end_of_scalar(std::string_view text, const YamlNode& scalar) {
  const std::size_t begin = scalar.begin;
  if (!scalar.quoted) return begin + scalar.text.size();
  const char quote = text[begin];
  std::size_t i = begin + 1;
  while (i < text.size() && text[i] != quote) i += text[i] == '\\' && quote == '"' ? 2 : 1;
  return std::min(i + 1, text.size());
}

}  // namespace

namespace {

base::Result<std::string> with_head(const std::string& yaml,
                                    const std::vector<std::pair<std::string, std::string>>& head) {
  Problems problems;
  std::string text = yaml.starts_with("\xEF\xBB\xBF") ? yaml.substr(3) : yaml;
  const YamlTree tree = parse_yaml(text, problems);
  struct Edit {
    std::size_t begin, end;
    std::string value;
  };
  std::vector<Edit> edits;
  for (const auto& [key, value] : head) {
    const YamlNode* node = tree.root.find(key);
    const bool plain =
        node && node->kind == YamlNode::Kind::scalar && end_of_scalar(text, *node) <= text.size();
    if (!plain) {
      return base::Error{base::ErrorCode::corrupt_data,
                         "The text of the curriculum has no '" + key + "': check the file first."};
    }
    edits.push_back({node->begin, end_of_scalar(text, *node), value});
  }
  // from the back, so that the places in front stay valid
  std::sort(edits.begin(), edits.end(),
            [](const Edit& a, const Edit& b) { return a.begin > b.begin; });
  for (const Edit& edit : edits) text.replace(edit.begin, edit.end - edit.begin, edit.value);
  return text;
}

}  // namespace

base::Result<std::string> copy_as_draft(const Curriculum& source, const std::string& new_id) {
  if (!is_id(new_id)) {
    return base::Error{base::ErrorCode::invalid_input,
                       "'" + new_id +
                           "' cannot be an id: use up to 64 small letters, digits, '-' and '_', "
                           "beginning with a letter."};
  }
  if (new_id == source.id) {
    return base::Error{base::ErrorCode::invalid_input, "A copy needs an id of its own: '" + new_id +
                                                           "' is the curriculum it is made from."};
  }
  return with_head(source.yaml, {{"id", new_id}, {"version", "1.0.0"}, {"status", "draft"}});
}

base::Result<std::string> next_draft(const std::string& yaml, const std::string& version) {
  return with_head(yaml, {{"version", version}, {"status", "draft"}});
}

base::Result<std::string> as_published(const std::string& yaml) {
  return with_head(yaml, {{"status", "published"}});
}

}  // namespace curricula
