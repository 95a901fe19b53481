#include "app/server/people_import.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <span>
#include <utility>

#include "app/server/import_values.h"
#include "app/session/recording.h"
#include "database/curricula.h"
#include "database/text_limits.h"
#include "database/training_by.h"

namespace app {
namespace {

using database::Person;
using Column = ImportColumn;
using Values = ImportValues;
using Problems = std::vector<std::string>;

std::string joined(const std::vector<std::string>& texts, const char* between) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : between) + text;
  return all;
}

// Parts become "One part; another part."
std::string sentence_of(const std::vector<std::string>& parts) {
  std::string sentence = joined(parts, "; ");
  if (sentence.empty()) return sentence;
  sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  return sentence.back() == '.' ? sentence : sentence + '.';
}

// Reads the lines one after the other: what a line may do depends on those above.
class Planner {
 public:
  explicit Planner(const KnownPeople& known) : known_(known) {
    for (const Person& person : known.people) {
      by_name_.emplace(lower_name(person.name), &person);
      if (person.role == database::Role::administrator && person.can_sign_in()) {
        administrators_.insert(person.id);
      }
    }
  }

  ImportedRow plan(const ImportLine& line) {
    ImportedRow row;
    row.line = line.line;
    row.name = line.cell(Column::name);
    row.display_name = line.cell(Column::display_name);
    Problems problems;
    if (!line.problem.empty()) {
      problems.push_back(line.problem);
    } else {
      fill(line, row, problems);
    }
    if (!problems.empty()) {
      row.action = ImportAction::broken;
      row.sentence = sentence_of(problems);
    }
    return row;
  }

 private:
  void fill(const ImportLine& line, ImportedRow& row, Problems& problems) {
    const Values values = read_import_values(line, known_.curricula, problems);
    check_name(line, problems);
    if (!row.display_name.empty()) {
      add_import_failure(database::check_name("display name", row.display_name), problems);
    }
    const auto found = by_name_.find(lower_name(row.name));
    if (found == by_name_.end()) {
      add(line, values, row, problems);
    } else {
      if (row.display_name.empty()) row.display_name = found->second->display_name;
      change(*found->second, line, values, row, problems);
    }
  }

  void check_name(const ImportLine& line, Problems& problems) {
    const std::string& name = line.cell(Column::name);
    if (name.empty()) {
      problems.push_back("the name is missing: write what the person signs in with");
      return;
    }
    add_import_failure(database::check_name("name", name), problems);
    const auto [first, is_new] = lines_.emplace(lower_name(name), line.line);
    if (!is_new) {
      problems.push_back("the name " + quoted_cell(name) + " is in line " +
                         std::to_string(first->second) + " already: keep one of the two");
    }
  }

  void add(const ImportLine& line, const Values& values, ImportedRow& row, Problems& problems) {
    if (row.display_name.empty()) {
      problems.push_back("the display name is missing: write what others see");
    }
    if (values.cases.value_or(0) > 0 && !values.level) {
      problems.push_back("there are cases without a level: write novice, intermediate or expert");
    }
    database::NewPerson& person = row.listed.added;
    person.name = row.name;
    person.display_name = row.display_name;
    person.email = line.cell(Column::email);
    person.role = values.role.value_or(database::Role::trainee);
    person.level = values.level;
    person.cases = values.cases.value_or(0);
    person.groups = values.groups.value_or(std::vector<std::string>{});
    person.curriculum_id = values.curriculum;
    row.action = ImportAction::add;
    std::vector<std::string> parts = {std::string("new ") + database::word(person.role)};
    if (person.level) parts.front() += std::string(", ") + database::word(*person.level);
    if (!person.groups.empty()) parts.push_back("joins " + joined(person.groups, ", "));
    if (person.curriculum_id) parts.push_back("trains by " + *person.curriculum_id);
    parts.emplace_back("gets a link to set a password");
    row.sentence = sentence_of(parts);
  }

  void change(const Person& person, const ImportLine& line, const Values& values, ImportedRow& row,
              Problems& problems) {
    if (person.kind != database::PersonKind::live) {
      problems.push_back("this name stands for " + std::string(database::word(person.kind)) +
                         " trials and cannot be changed by a list: choose another name");
      return;
    }
    row.listed.person_id = person.id;
    database::PersonChange& change = row.listed.change;
    std::vector<std::string> parts;
    if (row.display_name != person.display_name) {
      change.display_name = row.display_name;
      parts.push_back("display name becomes " + row.display_name);
    }
    if (const std::string& email = line.cell(Column::email);
        !email.empty() && email != person.email) {
      change.email = email;
      parts.push_back("e-mail becomes " + email);
    }
    change_experience(person, values, change, parts, problems);
    if (values.groups) change_groups(person, *values.groups, change, parts);
    change_curriculum(person, values, change, parts);
    change_role(person, values, change, parts, problems);
    row.action = parts.empty() ? ImportAction::unchanged : ImportAction::change;
    row.sentence = parts.empty() ? "Already so." : sentence_of(parts);
  }

  void change_role(const Person& person, const Values& values, database::PersonChange& change,
                   std::vector<std::string>& parts, Problems& problems) {
    if (!values.role || *values.role == person.role) return;
    const bool demoted = administrators_.contains(person.id);
    if (demoted && administrators_.size() == 1) {
      problems.push_back(person.display_name +
                         " is the last administrator who can sign in: leave the role, or make "
                         "somebody else an administrator first");
      return;
    }
    // the last of the checks: a row that is broken for another reason changes no role
    if (demoted && problems.empty()) administrators_.erase(person.id);
    change.role = values.role;
    parts.push_back(std::string("role ") + database::word(person.role) + " becomes " +
                    database::word(*values.role));
  }

  void change_experience(const Person& person, const Values& values, database::PersonChange& change,
                         std::vector<std::string>& parts, Problems& problems) {
    if (!values.level && !values.cases) return;
    if (!values.level && !person.level) {
      if (*values.cases == 0) return;
      problems.push_back("there are cases without a level: write novice, intermediate or expert");
      return;
    }
    const auto cases = known_.cases.find(person.id);
    const int known_cases = cases == known_.cases.end() ? 0 : cases->second;
    const database::Level level = values.level ? *values.level : *person.level;
    const int new_cases = values.cases.value_or(known_cases);
    if (person.level && level == *person.level && new_cases == known_cases) return;
    change.level = level;
    change.cases = new_cases;
    parts.push_back(std::string("is declared ") + database::word(level) + " with " +
                    std::to_string(new_cases) + (new_cases == 1 ? " case" : " cases") +
                    " as of today");
  }

  static void change_groups(const Person& person, const std::vector<std::string>& wanted,
                            database::PersonChange& change, std::vector<std::string>& parts) {
    std::vector<std::string> now = person.groups, joins, leaves;
    std::sort(now.begin(), now.end());
    std::set_difference(wanted.begin(), wanted.end(), now.begin(), now.end(),
                        std::back_inserter(joins));
    std::set_difference(now.begin(), now.end(), wanted.begin(), wanted.end(),
                        std::back_inserter(leaves));
    if (joins.empty() && leaves.empty()) return;
    change.groups = wanted;
    if (!joins.empty()) parts.push_back("joins " + joined(joins, ", "));
    if (!leaves.empty()) parts.push_back("leaves " + joined(leaves, ", "));
  }

  void change_curriculum(const Person& person, const Values& values, database::PersonChange& change,
                         std::vector<std::string>& parts) {
    const auto now = known_.assigned.find(person.id);
    const std::string assigned = now == known_.assigned.end() ? "" : now->second;
    if (!values.curriculum || *values.curriculum == assigned) return;
    change.curriculum_id = values.curriculum;
    parts.push_back("trains by " + *values.curriculum);
  }

  const KnownPeople& known_;
  std::map<std::string, const Person*> by_name_;  // lower-case
  std::set<std::string> administrators_;          // who can sign in, after the lines so far
  std::map<std::string, int> lines_;              // of the names so far
};

std::string hash_of_plan(const std::string& csv, const ImportPlan& plan) {
  std::string all = std::to_string(csv.size()) + ":" + csv;
  for (const std::string& problem : plan.problems) all += "\n" + problem;
  for (const ImportedRow& row : plan.rows) {
    all += "\n" + std::to_string(row.line) + " " + word(row.action) + " " + row.listed.person_id +
           " " + row.sentence;
  }
  return sha256_hex(std::as_bytes(std::span(all)));
}

}  // namespace

const char* word(ImportAction action) {
  switch (action) {
    case ImportAction::add:
      return "add";
    case ImportAction::change:
      return "change";
    case ImportAction::unchanged:
      return "unchanged";
    case ImportAction::broken:
      return "broken";
  }
  return "";
}

int ImportPlan::count(ImportAction action) const {
  return static_cast<int>(std::count_if(
      rows.begin(), rows.end(), [&](const ImportedRow& row) { return row.action == action; }));
}

base::Result<KnownPeople> known_people(database::Store& store) {
  KnownPeople known;
  auto people = database::people(store);
  if (!people) return people.error();
  known.people = *std::move(people);
  auto cases = database::cases_by_person(store);
  if (!cases) return cases.error();
  known.cases = *std::move(cases);
  auto assigned = database::assigned_curricula(store);
  if (!assigned) return assigned.error();
  known.assigned = *std::move(assigned);
  const auto versions = database::curriculum_versions(store);
  if (!versions) return versions.error();
  std::set<std::string> ids;
  for (const database::CurriculumVersion& version : *versions) {
    if (version.status == "published") ids.insert(version.curriculum_id);
  }
  known.curricula.assign(ids.begin(), ids.end());
  return known;
}

ImportPlan plan_import(const std::string& csv, const KnownPeople& known) {
  ImportPlan plan;
  ImportTable table = read_import_table(csv);
  plan.problems = std::move(table.problems);
  Planner planner(known);
  for (const ImportLine& line : table.lines) plan.rows.push_back(planner.plan(line));
  plan.sha256 = hash_of_plan(csv, plan);
  return plan;
}

}  // namespace app
