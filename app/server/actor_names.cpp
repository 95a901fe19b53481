#include "app/server/actor_names.h"

#include "database/people.h"

namespace app {

base::Result<ActorNames> ActorNames::load(database::Store& store) {
  const auto people = database::people(store);
  if (!people) return people.error();
  ActorNames names;
  for (const database::Person& person : *people) {
    names.by_id_.emplace(person.id, person.display_name);
  }
  return names;
}

std::string ActorNames::actor(const std::string& id) const {
  const auto found = by_id_.find(id);
  if (found != by_id_.end()) return found->second;
  if (id == "system") return "the program";
  if (id == "shell") return "the shell";
  return id;
}

std::string ActorNames::object(const std::string& object) const {
  const std::size_t colon = object.find(':');
  if (colon == std::string::npos) return object;
  const std::string kind = object.substr(0, colon), id = object.substr(colon + 1);
  const auto found = kind == "person" ? by_id_.find(id) : by_id_.end();
  return kind + " " + (found == by_id_.end() ? id : found->second);
}

}  // namespace app
