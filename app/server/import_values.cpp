#include "app/server/import_values.h"

#include <algorithm>
#include <charconv>

#include "database/text_limits.h"

namespace app {
namespace {

using Problems = std::vector<std::string>;

std::vector<std::string> groups_in(const std::string& cell) {
  std::vector<std::string> groups;
  for (std::size_t start = 0; start <= cell.size();) {
    const std::size_t end = std::min(cell.find('|', start), cell.size());
    std::string group = cell.substr(start, end - start);
    group.erase(0, std::min(group.find_first_not_of(' '), group.size()));
    group.erase(group.find_last_not_of(' ') + 1);
    const bool known = std::find(groups.begin(), groups.end(), group) != groups.end();
    if (!group.empty() && !known) groups.push_back(group);
    start = end + 1;
  }
  std::sort(groups.begin(), groups.end());
  return groups;
}

template <typename Value>
void read_word(const std::string& cell, const char* what, const char* choices,
               std::optional<Value>& value, Problems& problems) {
  if (cell.empty()) return;
  Value read{};
  if (database::parse(lower_name(cell), read)) {
    value = read;
  } else {
    problems.push_back(quoted_cell(cell) + " is no " + what + ": use " + choices);
  }
}

void read_cases(const std::string& cell, std::optional<int>& cases, Problems& problems) {
  if (cell.empty()) return;
  constexpr int kMost = 1000000;
  int read = -1;
  const auto [end, failure] = std::from_chars(cell.data(), cell.data() + cell.size(), read);
  if (failure == std::errc{} && end == cell.data() + cell.size() && read >= 0 && read <= kMost) {
    cases = read;
  } else {
    problems.push_back(quoted_cell(cell) +
                       " is no number of cases: write a whole number, 0 or more");
  }
}

std::string choices_of(const std::vector<std::string>& curricula) {
  if (curricula.empty()) return "an empty cell";
  std::string choices;
  for (const std::string& id : curricula) choices += (choices.empty() ? "" : ", ") + id;
  return choices;
}

}  // namespace

std::string lower_name(std::string text) {
  for (char& c : text) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

std::string quoted_cell(const std::string& text) {
  std::size_t shown = std::min<std::size_t>(text.size(), 60);
  // never in the middle of a character
  while (shown < text.size() && (static_cast<unsigned char>(text[shown]) & 0xc0) == 0x80) --shown;
  return '"' + text.substr(0, shown) + (shown < text.size() ? "…" : "") + '"';
}

void add_import_failure(const base::Status& status, Problems& problems) {
  if (status) return;
  std::string sentence = status.error().message;
  if (sentence.starts_with("The ")) sentence.front() = 't';
  if (sentence.ends_with('.')) sentence.pop_back();
  problems.push_back(sentence);
}

ImportValues read_import_values(const ImportLine& line, const std::vector<std::string>& curricula,
                                Problems& problems) {
  ImportValues values;
  add_import_failure(database::check_email(line.cell(ImportColumn::email)), problems);
  read_word(line.cell(ImportColumn::role), "role",
            "trainee, instructor, administrator or researcher", values.role, problems);
  read_word(line.cell(ImportColumn::level), "level", "novice, intermediate or expert", values.level,
            problems);
  read_cases(line.cell(ImportColumn::cases), values.cases, problems);
  if (const std::string& cell = line.cell(ImportColumn::groups); !cell.empty()) {
    values.groups = groups_in(cell);
    for (const std::string& group : *values.groups) {
      add_import_failure(database::check_name("name of the group", group), problems);
    }
  }
  if (const std::string& cell = line.cell(ImportColumn::curriculum); !cell.empty()) {
    if (std::find(curricula.begin(), curricula.end(), cell) == curricula.end()) {
      problems.push_back("no curriculum " + quoted_cell(cell) + " is published: use " +
                         choices_of(curricula));
    }
    values.curriculum = cell;
  }
  return values;
}

}  // namespace app
