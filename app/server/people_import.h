// What a list of people from a spreadsheet would do, row by row, before anything is done.
//
//     name,display_name,email,role,level,cases,groups,curriculum
//     ann,Ann Amsel,ann@clinic.example,trainee,novice,0,2026|Mondays,
//
// Names that are new become people with an invitation; known ones change where their cells differ.
// An empty cell leaves things as they are. Nobody is enabled, disabled or removed by a list.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "database/people.h"
#include "database/person_changes.h"
#include "database/store.h"

namespace app {

inline constexpr std::size_t kMostImportRows = 2000;
inline constexpr std::size_t kLongestImport = 768 * 1024;  // bytes

// What the list is compared with.
struct KnownPeople {
  std::vector<database::Person> people;
  std::map<std::string, int> cases;             // by person, those declared last
  std::map<std::string, std::string> assigned;  // curricula by person, where not the default
  std::vector<std::string> curricula;           // published
};
base::Result<KnownPeople> known_people(database::Store& store);

enum class ImportAction { add, change, unchanged, broken };
const char* word(ImportAction action);

struct ImportedRow {
  int line = 0;
  std::string name, display_name;
  ImportAction action = ImportAction::broken;
  std::string sentence;           // what will happen, or what is wrong and what to do
  database::ListedPerson listed;  // for add (without its link) and change
};

struct ImportPlan {
  std::vector<ImportedRow> rows;
  std::vector<std::string> problems;  // of the file; then there are no rows
  std::string sha256;                 // of the file and what it would do

  int count(ImportAction action) const;
};

ImportPlan plan_import(const std::string& csv, const KnownPeople& known);

}  // namespace app
