#include "curricula/yaml_source.h"

#include <algorithm>
#include <vector>

namespace curricula {
namespace {

// One past the bracket that closes the one at `begin`.
std::size_t end_of_brackets(std::string_view text, std::size_t begin) {
  int depth = 0;
  char before = ' ';  // the last character, to know where a quoted word or a comment begins
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    const bool starts = before == ' ' || before == '\n' || before == ',' || before == '[' ||
                        before == '{' || before == '\t';
    if (starts && (c == '"' || c == '\'')) {
      for (++i; i < text.size() && text[i] != c; ++i) {
        if (c == '"' && text[i] == '\\') ++i;
      }
    } else if (starts && c == '#') {
      while (i + 1 < text.size() && text[i + 1] != '\n') ++i;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if ((c == ']' || c == '}') && --depth == 0) {
      return i + 1;
    }
    before = i < text.size() ? text[i] : ' ';
  }
  return text.size();
}

// A line that says nothing of its own: blank, a comment, or the dash of the next item.
bool is_trailing(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || line[first] == '#') return true;
  return line[first] == '-' &&
         line.find_first_not_of(" \t\r\n", first + 1) == std::string_view::npos;
}

}  // namespace

std::string source_of(std::string_view text, const YamlNode& map, std::size_t next) {
  const std::size_t begin = std::min(map.begin, text.size());
  if (map.flow) return std::string(text.substr(begin, end_of_brackets(text, begin) - begin)) + "\n";

  // whole lines up to the line of the next node
  std::size_t end = std::min(next, text.size());
  if (end < text.size()) {
    const std::size_t line_start = text.rfind('\n', end);
    end = line_start == std::string_view::npos || line_start < begin ? end : line_start + 1;
  }
  std::vector<std::string_view> lines;
  for (std::size_t i = begin; i < end;) {
    const std::size_t stop = std::min(text.find('\n', i), end - 1) + 1;
    lines.push_back(text.substr(i, stop - i));
    i = stop;
  }
  while (!lines.empty() && is_trailing(lines.back())) lines.pop_back();

  const std::size_t line_start = begin == 0 ? 0 : text.rfind('\n', begin - 1) + 1;
  const std::size_t indent = begin - line_start;
  std::string result;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::size_t skip = 0;
    while (i > 0 && skip < indent && skip < lines[i].size() && lines[i][skip] == ' ') ++skip;
    result += lines[i].substr(skip);
  }
  if (!result.empty() && result.back() != '\n') result += '\n';
  return result;
}

}  // namespace curricula
