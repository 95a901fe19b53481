#include "database/people.h"

#include <gtest/gtest.h>

#include "tests/database/temporary_store.h"

namespace database_test {
namespace {

using base::ErrorCode;
using database::Level;
using database::NewPerson;
using database::Person;
using database::PersonKind;
using database::Role;

std::vector<std::string> names(const base::Result<std::vector<Person>>& people) {
  std::vector<std::string> result;
  if (people) {
    for (const Person& person : *people) result.push_back(person.name);
  }
  return result;
}

class People : public testing::Test {
 protected:
  TemporaryFolder folder_;
  std::unique_ptr<database::Store> store_ = open_store(folder_.url());
};

TEST_F(People, AreReadAsTheyWereAdded) {
  NewPerson anna;
  anna.name = "anna@clinic";
  anna.display_name = "Änna 李 O'Hara";
  anna.role = Role::instructor;
  anna.password_phc = "$argon2id$v=19$m=19456,t=2,p=1$c2FsdA$aGFzaA";
  anna.level = Level::intermediate;
  anna.groups = {"b", "a", "b"};
  const auto added = add_person(*store_, anna, "shell");
  ASSERT_TRUE(added) << added.error().message;
  for (const auto& read : {person_by_id(*store_, added->id), person_by_name(*store_, anna.name),
                           base::Result<Person>(*added)}) {
    ASSERT_TRUE(read);
    EXPECT_EQ(read->id, added->id);
    EXPECT_EQ(read->name, "anna@clinic");
    EXPECT_EQ(read->display_name, "Änna 李 O'Hara");
    EXPECT_EQ(read->role, Role::instructor);
    EXPECT_EQ(read->kind, PersonKind::live);
    EXPECT_FALSE(read->disabled);
    EXPECT_EQ(read->password_phc, anna.password_phc);
    EXPECT_EQ(read->level, Level::intermediate);
    EXPECT_EQ(read->groups, (std::vector<std::string>{"a", "b"}));
    EXPECT_FALSE(read->created_utc.empty());
  }
}

TEST_F(People, AreListedByNameEachWithTheirOwnGroupsAndLevel) {
  NewPerson zoe;
  zoe.name = "zoe";
  zoe.groups = {"one"};
  zoe.level = Level::expert;
  NewPerson bob;
  bob.name = "Bob";
  bob.groups = {"two"};
  NewPerson carl;
  carl.name = "carl";
  for (const NewPerson& person : {zoe, bob, carl}) {
    ASSERT_TRUE(add_person(*store_, person, "system"));
  }
  const auto all = people(*store_);
  EXPECT_EQ(names(all), (std::vector<std::string>{"Bob", "carl", "zoe"}));
  EXPECT_EQ((*all)[0].groups, std::vector<std::string>{"two"});
  EXPECT_TRUE((*all)[1].groups.empty());
  EXPECT_FALSE((*all)[1].level);
  EXPECT_EQ((*all)[2].level, Level::expert);
  EXPECT_EQ((*all)[1].display_name, "carl");
}

TEST_F(People, HaveNamesThatDifferInMoreThanCase) {
  add_trainee(*store_, "anna");
  NewPerson second;
  second.name = "ANNA";
  const auto added = add_person(*store_, second, "system");
  ASSERT_FALSE(added);
  EXPECT_EQ(added.error().code, ErrorCode::conflict);
  EXPECT_EQ(person_by_name(*store_, "Anna")->name, "anna");
}

TEST_F(People, UnknownOnesAreNotFound) {
  EXPECT_EQ(person_by_id(*store_, "nobody").error().code, ErrorCode::not_found);
  EXPECT_EQ(person_by_name(*store_, "nobody").error().code, ErrorCode::not_found);
  EXPECT_EQ(set_disabled(*store_, "nobody", true, "system").error().code, ErrorCode::not_found);
  EXPECT_EQ(set_password(*store_, "nobody", "x", "system").error().code, ErrorCode::not_found);
  EXPECT_EQ(declare_experience(*store_, "nobody", Level::expert, 1, "system").error().code,
            ErrorCode::not_found);
  EXPECT_EQ(level_at(*store_, "nobody", "").error().code, ErrorCode::not_found);
  EXPECT_EQ(people_of_instructor(*store_, "nobody").error().code, ErrorCode::not_found);
  EXPECT_EQ(join_group(*store_, "nobody", "g", "system").error().code, ErrorCode::not_found);
}

TEST_F(People, CanBeDisabledAndGivenAPassword) {
  const std::string id = add_trainee(*store_, "anna").id;
  ASSERT_TRUE(set_disabled(*store_, id, true, "system"));
  EXPECT_TRUE(person_by_id(*store_, id)->disabled);
  ASSERT_TRUE(set_disabled(*store_, id, false, "system"));
  EXPECT_FALSE(person_by_id(*store_, id)->disabled);
  ASSERT_TRUE(set_password(*store_, id, "$argon2id$new", id));
  EXPECT_EQ(person_by_id(*store_, id)->password_phc, "$argon2id$new");
}

TEST_F(People, KeepTheLevelTheyHadAtATime) {
  const std::string id = add_trainee(*store_, "anna").id;
  const auto declare = [&](Level level, const char* utc) {
    ASSERT_TRUE(declare_experience(*store_, id, level, 10, "system", utc));
  };
  declare(Level::novice, "2025-01-01T00:00:00Z");
  declare(Level::expert, "2026-06-01T12:00:00Z");
  declare(Level::intermediate, "2025-09-01T00:00:00Z");  // told later, about an earlier time
  const auto at = [&](const char* utc) { return *level_at(*store_, id, utc); };
  EXPECT_EQ(at("2024-12-31T23:59:59Z"), std::nullopt);
  EXPECT_EQ(at("2025-01-01T00:00:00Z"), Level::novice);
  EXPECT_EQ(at("2025-08-31T23:59:59.999Z"), Level::novice);
  EXPECT_EQ(at("2025-12-24T00:00:00Z"), Level::intermediate);
  EXPECT_EQ(at("2026-06-01T12:00:00.001Z"), Level::expert);
  EXPECT_EQ(person_by_id(*store_, id)->level, Level::expert);
  EXPECT_EQ(level_at(*store_, id, "yesterday").error().code, ErrorCode::invalid_input);
  EXPECT_EQ(level_at(*store_, id, "2025-02-30T00:00:00Z").error().code, ErrorCode::invalid_input);
}

TEST_F(People, WhoSayTheirLevelTwiceInAMomentHaveTheSecond) {
  const std::string id = add_trainee(*store_, "anna").id;
  const std::string utc = "2026-01-01T00:00:00.000Z";
  ASSERT_TRUE(declare_experience(*store_, id, Level::expert, 1, "system", utc));
  ASSERT_TRUE(declare_experience(*store_, id, Level::novice, 1, "system", utc));
  EXPECT_EQ(*level_at(*store_, id, utc), Level::novice);
  EXPECT_EQ(person_by_id(*store_, id)->level, Level::novice);
}

TEST_F(People, WhoArePublishedHaveTheirLevelAtAnyTime) {
  NewPerson participant;
  participant.name = "No.1";
  participant.kind = PersonKind::published;
  participant.level = Level::expert;
  const auto added = add_person(*store_, participant, "system");
  ASSERT_TRUE(added);
  EXPECT_EQ(*level_at(*store_, added->id, "1990-01-01T00:00:00Z"), Level::expert);
}

TEST_F(People, AreSeenByInstructorsOfTheirGroupsOnly) {
  const auto add = [&](const char* name, Role role, std::vector<std::string> groups) {
    NewPerson person;
    person.name = name;
    person.role = role;
    person.groups = std::move(groups);
    return add_person(*store_, person, "system")->id;
  };
  const std::string teacher = add("teacher", Role::instructor, {"red", "blue"});
  const std::string other = add("other", Role::instructor, {});
  const std::string anna = add("anna", Role::trainee, {"red", "blue"});
  add("bob", Role::trainee, {"green"});
  const std::string carl = add("carl", Role::trainee, {"blue"});
  EXPECT_EQ(names(people_of_instructor(*store_, teacher)),
            (std::vector<std::string>{"anna", "carl"}));
  EXPECT_TRUE(people_of_instructor(*store_, other)->empty());

  ASSERT_TRUE(leave_group(*store_, carl, "blue", "system"));
  ASSERT_TRUE(leave_group(*store_, carl, "blue", "system"));
  EXPECT_EQ(names(people_of_instructor(*store_, teacher)), std::vector<std::string>{"anna"});
  EXPECT_TRUE(person_by_id(*store_, carl)->groups.empty());
  ASSERT_TRUE(join_group(*store_, carl, "blue", "system"));
  ASSERT_TRUE(join_group(*store_, carl, "blue", "system"));
  EXPECT_EQ(person_by_id(*store_, carl)->groups, std::vector<std::string>{"blue"});
  // both stays are remembered
  EXPECT_EQ(RawFile(folder_.file("store.db"))
                .value("SELECT count(*) FROM membership WHERE person_id = '" + carl + "'"),
            "2");
}

TEST_F(People, WithHostileNamesAreKeptWordForWord) {
  const std::vector<std::string> hostile = {"'; DROP TABLE person; --",
                                            "\" OR \"\"=\"",
                                            ":value",
                                            "%s%n?1",
                                            "<script>alert(1)</script>",
                                            "\\x27 OR 1=1",
                                            "\xf0\x9f\x92\x89 \xd8\xb9\xd8\xb1"};
  for (const std::string& name : hostile) {
    NewPerson person;
    person.name = name;
    person.groups = {name};
    const auto added = add_person(*store_, person, name);
    ASSERT_TRUE(added) << name << ": " << added.error().message;
    const auto read = person_by_name(*store_, name);
    ASSERT_TRUE(read) << name;
    EXPECT_EQ(read->id, added->id);
    EXPECT_EQ(read->name, name);
    EXPECT_EQ(read->groups, std::vector<std::string>{name});
  }
  EXPECT_EQ(people(*store_)->size(), hostile.size());
  EXPECT_EQ(person_by_name(*store_, "' OR 1=1 --").error().code, ErrorCode::not_found);
}

TEST_F(People, WithUnreadableOrHugeNamesAreRefused) {
  using namespace std::string_literals;
  const std::vector<std::string> refused = {""s,
                                            std::string(1 << 20, 'x'),
                                            std::string(129, 'x'),
                                            "a\0b"s,
                                            "line\nbreak"s,
                                            " anna"s,
                                            "anna "s,
                                            "\xff\xfe"s,      // never in UTF-8
                                            "\xc0\xaf"s,      // overlong
                                            "\xed\xa0\x80"s,  // surrogate
                                            "\xf5\x80\x80\x80"s,
                                            "cut \xe2\x82"s};
  for (const std::string& name : refused) {
    NewPerson person;
    person.name = name;
    const auto added = add_person(*store_, person, "system");
    ASSERT_FALSE(added) << name.substr(0, 20);
    EXPECT_EQ(added.error().code, ErrorCode::invalid_input);
    NewPerson member;
    member.name = "member";
    member.groups = {name};
    EXPECT_FALSE(add_person(*store_, member, "system"));
    member.groups.clear();
    EXPECT_FALSE(add_person(*store_, member, name));
  }
  EXPECT_TRUE(people(*store_)->empty());
}

}  // namespace
}  // namespace database_test
