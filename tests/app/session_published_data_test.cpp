// The paper's rows are loaded once and never mixed with trials made here.
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "app/session/comparison_data.h"
#include "app/session/published_data.h"
#include "database/trials.h"
#include "tests/app/session_bench.h"

namespace app::test {
namespace {

constexpr const char* kRows = CATHEDRA_SOURCE_DIR "/app/demo/published_trials.csv";

class PublishedData : public ::testing::Test {
 protected:
  int load() { return checked(load_published_data(*store, kRows)); }
  std::size_t rows(const std::string& exercise, const std::string& dataset) {
    curricula::Exercise asked;
    asked.id = exercise;
    asked.title = {{"en", exercise}};
    return checked(comparison_data(*store, asked, dataset)).rows.size();
  }
  void file_trial(const std::string& person, assessment::Source source, bool interrupted = false,
                  bool voided = false) {
    database::NewTrial trial = database_test::new_trial_of(person);
    trial.source = source;
    checked(database::begin_trial(*store, trial));
    database::FinishedTrial finished = database_test::passed_in(50.0);
    finished.interrupted = interrupted;
    check_done(database::finish_trial(*store, trial.id, finished, {}, {}));
    if (voided) check_done(database::void_trial(*store, trial.id, "a slip", "shell"));
  }

  database_test::TemporaryFolder folder;
  std::unique_ptr<database::Store> store = database_test::open_store(folder.url());
};

TEST_F(PublishedData, IsLoadedOnce) {
  EXPECT_EQ(load(), 120);
  EXPECT_EQ(load(), 0);
  EXPECT_EQ(rows("linear", "paper"), 60u);
  EXPECT_EQ(rows("rotational", "paper"), 60u);
}

TEST_F(PublishedData, ALoadThatWasCutOffGoesOn) {
  std::ifstream all(kRows);
  const std::string part = folder.file("part.csv");
  {
    std::ofstream first(part);
    std::string line;
    for (int k = 0; k < 38 && std::getline(all, line); ++k) first << line << '\n';
  }
  EXPECT_EQ(checked(load_published_data(*store, part)), 37);
  EXPECT_EQ(load(), 83);
  EXPECT_EQ(load(), 0);
}

TEST_F(PublishedData, ABrokenRowIsNamedByItsLine) {
  const std::string file = folder.file("broken.csv");
  std::ofstream(file)
      << "task,group,participant,trial,seconds\nlinear,expert,No.1,1,252\nlinear,x\n";
  const auto loaded = load_published_data(*store, file);
  ASSERT_FALSE(loaded);
  EXPECT_EQ(loaded.error().code, base::ErrorCode::corrupt_data);
  EXPECT_NE(loaded.error().message.find("broken.csv:3"), std::string::npos);
  EXPECT_FALSE(load_published_data(*store, folder.file("absent.csv")));
}

TEST_F(PublishedData, SourcesAreNeverPooled) {
  load();
  database::NewPerson live;
  live.name = "resident";
  live.level = database::Level::novice;
  const std::string person = checked(database::add_person(*store, live, "shell")).id;
  file_trial(person, assessment::Source::live);
  file_trial(person, assessment::Source::live, true);         // interrupted: shown, not counted
  file_trial(person, assessment::Source::live, false, true);  // voided
  const std::string machine = checked(simulated_person(*store, "simulated:expert", "S", "expert"));
  file_trial(machine, assessment::Source::simulated_operator);
  file_trial(machine, assessment::Source::simulated_operator);
  EXPECT_EQ(rows("linear", "live"), 1u);
  EXPECT_EQ(rows("linear", "simulated"), 2u);
  EXPECT_EQ(rows("linear", "paper"), 60u);
  curricula::Exercise linear;
  linear.id = "linear";
  linear.title = {{"en", "Linear"}};
  const auto everything = comparison_data(*store, linear, "all");
  ASSERT_FALSE(everything);
  EXPECT_EQ(everything.error().code, base::ErrorCode::invalid_input);
}

}  // namespace
}  // namespace app::test
