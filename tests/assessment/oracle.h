// Reference values computed elsewhere (R, SciPy, the published implementation of SPARC), read from
// tests/fixtures/oracles. Each entry of the files names the call that gave it.
#pragma once

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace oracle {

inline std::string fixture(const std::string& name) {
  return std::string(CATHEDRA_SOURCE_DIR) + "/tests/fixtures/" + name;
}

inline nlohmann::json load(const std::string& name) {
  std::ifstream file(fixture("oracles/" + name));
  return nlohmann::json::parse(file).at("oracles");
}

inline const nlohmann::json& statistics() {
  static const nlohmann::json values = load("statistics_linear.json");
  return values;
}

inline double value(const std::string& key) { return statistics().at(key).at("value"); }
inline std::vector<double> values(const std::string& key) {
  return statistics().at(key).at("value").get<std::vector<double>>();
}

// Relative to the reference, with a floor for references that are zero.
inline void expect_close(double actual, double reference, double relative,
                         const std::string& what) {
  const double tolerance = relative * std::max(std::abs(reference), 1e-9);
  EXPECT_NEAR(actual, reference, tolerance) << what;
}

// The linear task's published trials: participant -> seconds of trials 1..10.
inline std::map<std::string, std::vector<double>> linear_seconds(
    const std::string& task = "linear") {
  std::map<std::string, std::vector<double>> result;
  std::ifstream file(fixture("paper/trials.csv"));
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::stringstream fields(line);
    std::string row_task, group, participant, trial, seconds;
    std::getline(fields, row_task, ',');
    std::getline(fields, group, ',');
    std::getline(fields, participant, ',');
    std::getline(fields, trial, ',');
    std::getline(fields, seconds, ',');
    if (row_task != task) continue;
    auto& series = result[participant];
    EXPECT_EQ(series.size() + 1, std::stoul(trial));  // the file lists each one's trials in order
    series.push_back(std::stod(seconds));
  }
  return result;
}

}  // namespace oracle
