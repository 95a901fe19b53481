// A store in a folder of its own that goes away with it, and small things to put into it.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "database/people.h"
#include "database/store.h"
#include "database/trials.h"
#include "tests/database/raw_file.h"

namespace database_test {

class TemporaryFolder {
 public:
  TemporaryFolder() : path_(std::filesystem::temp_directory_path() / database::new_id()) {
    std::filesystem::create_directory(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;  // what a test left locked is not worth a failure
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string url(const std::string& name = "store.db") const { return "sqlite:" + file(name); }

 private:
  std::filesystem::path path_;
};

inline std::unique_ptr<database::Store> open_store(const std::string& url) {
  base::Result<std::unique_ptr<database::Store>> store = database::Store::open(url);
  EXPECT_TRUE(store) << (store ? "" : store.error().message);
  return store ? *std::move(store) : nullptr;
}

inline database::Person add_trainee(database::Store& store, const std::string& name) {
  database::NewPerson person;
  person.name = name;
  const base::Result<database::Person> added = database::add_person(store, person, "system");
  EXPECT_TRUE(added) << (added ? "" : added.error().message);
  return added ? *added : database::Person{};
}

inline database::NewTrial new_trial_of(const std::string& person_id) {
  database::NewTrial trial;
  trial.id = database::new_id();
  trial.person_id = person_id;
  trial.exercise_id = "linear";
  trial.apparatus = "cathedra";
  trial.device = "keyboard";
  return trial;
}

inline std::vector<std::byte> bytes_of(const std::string& text) {
  const auto* begin = reinterpret_cast<const std::byte*>(text.data());
  return {begin, begin + text.size()};
}

inline database::FinishedTrial passed_in(double time) {  // s
  database::FinishedTrial finished;
  finished.end_reason = assessment::EndReason::completed;
  finished.end_time_s = time;
  finished.metrics = {{"time_s", 1, time}};
  finished.verdict.outcome = assessment::Outcome::passed;
  finished.verdict.sentence = "Passed.";
  finished.rule_version = "linear@1";
  return finished;
}

}  // namespace database_test
