// Small inputs the tests of the reports share, and a parser that is not ours.
#pragma once

#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include "assessment/comparison.h"
#include "reports/comparison_report.h"

namespace samples {

// The paper's trials of one task (Tables VI and VII), as the demo carries them.
inline std::vector<assessment::TrialValue> paper_rows(const std::string& task) {
  std::ifstream file(std::string(CATHEDRA_SOURCE_DIR) + "/app/demo/published_trials.csv");
  std::vector<assessment::TrialValue> rows;
  std::string line;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string name, group, person, trial, seconds;
    std::getline(cells, name, ',');
    std::getline(cells, group, ',');
    std::getline(cells, person, ',');
    std::getline(cells, trial, ',');
    std::getline(cells, seconds, ',');
    if (name == task) rows.push_back({group, person, std::stoi(trial), std::stod(seconds)});
  }
  return rows;
}

// `people` experts near 80 and novices near 120, falling slowly with the trial; no two alike.
inline std::vector<assessment::TrialValue> made_up_rows(int people, int trials,
                                                        const std::string& name = "P") {
  std::vector<assessment::TrialValue> rows;
  for (int person = 1; person <= people; ++person) {
    for (int trial = 1; trial <= trials; ++trial) {
      const double shift = 0.7 * person + 5.0 / trial;
      rows.push_back({"expert", name + "e" + std::to_string(person), trial, 80.0 + shift});
      rows.push_back({"novice", name + "n" + std::to_string(person), trial, 120.0 + shift});
    }
  }
  return rows;
}

inline assessment::GroupComparison compared(const std::vector<assessment::TrialValue>& rows,
                                            const assessment::ComparisonQuestion& question = {}) {
  return *assessment::compare_groups(rows, question);
}

inline reports::ComparisonSubject subject() {
  return {"linear", "Linear", "paper", "Published data", "their own simulator", "ab12", "Cathedra"};
}

inline std::optional<boost::property_tree::ptree> parsed(const std::string& xml) {
  std::istringstream stream(xml);
  boost::property_tree::ptree tree;
  try {
    boost::property_tree::read_xml(stream, tree);
  } catch (const boost::property_tree::xml_parser_error&) {
    return std::nullopt;
  }
  return tree;
}

inline int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
    ++count;
  }
  return count;
}

}  // namespace samples
