#include "app/server/access.h"

#include <algorithm>

#include "app/server/site.h"
#include "database/trials.h"

namespace app {
namespace {

bool share_a_group(const database::Person& left, const database::Person& right) {
  return std::any_of(left.groups.begin(), left.groups.end(), [&](const std::string& group) {
    return std::find(right.groups.begin(), right.groups.end(), group) != right.groups.end();
  });
}

base::Status check_person(database::Store& store, const database::Person& viewer,
                          const std::string& person_id) {
  if (person_id == "me" || person_id == viewer.id) return base::Done{};
  const auto person = database::person_by_id(store, person_id);
  if (!person) return person.error();
  if (may_see(viewer, *person)) return base::Done{};
  return base::Error{base::ErrorCode::denied, "You may not see this person's training."};
}

base::Status check_trial(database::Store& store, const database::Person& viewer,
                         const std::string& trial_id) {
  const auto trial = database::trial(store, trial_id);
  if (!trial) return trial.error();
  return check_person(store, viewer, trial->head.person_id);
}

base::Status check_practice(const database::Person& viewer, const std::string& person_id) {
  if (person_id == viewer.id) return base::Done{};
  return base::Error{base::ErrorCode::denied,
                     "Practice is for the one who practises: nobody else sees it."};
}

}  // namespace

bool may_see(const database::Person& viewer, const database::Person& person) {
  if (viewer.id == person.id) return true;
  switch (viewer.role) {
    case database::Role::administrator:
      return true;
    case database::Role::instructor:
      return person.kind != database::PersonKind::live || share_a_group(viewer, person);
    case database::Role::trainee:
    case database::Role::researcher:
      return false;
  }
  return false;
}

base::Status check_subject(database::Store& store, Site& site, const database::Person& viewer,
                           Subject subject, const std::map<std::string, std::string>& parameters) {
  switch (subject) {
    case Subject::nobody:
      return base::Done{};
    case Subject::person:
      return check_person(store, viewer, parameters.at("id"));
    case Subject::trial:
      return check_trial(store, viewer, parameters.at("id"));
    case Subject::live_trial: {
      const auto running = site.live.find(parameters.at("id"));
      if (running && running->practice) return check_practice(viewer, running->person_id);
      return check_trial(store, viewer, parameters.at("id"));
    }
    case Subject::practice: {
      if (const auto running = site.live.find(parameters.at("id")); running && running->practice) {
        return check_practice(viewer, running->person_id);
      }
      const auto result = site.practice.find(parameters.at("id"));
      if (result) return check_practice(viewer, result->person_id);
      return base::Error{base::ErrorCode::not_found,
                         "There is no such practice, or its result is no longer kept."};
    }
  }
  return base::Error{base::ErrorCode::denied, "You may not see this."};
}

}  // namespace app
