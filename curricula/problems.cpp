#include "curricula/problems.h"

#include <algorithm>
#include <utility>

#include "curricula/yaml_tree.h"

namespace curricula {
namespace {

constexpr std::size_t kMostProblems = 1000;

}  // namespace

void Problems::error(int line, int column, std::string message) {
  any_error_ = true;
  add({Problem::Severity::error, line, column, std::move(message)});
}

void Problems::error(const YamlNode& at, std::string message) {
  error(at.line, at.column, std::move(message));
}

void Problems::warning(const YamlNode& at, std::string message) {
  add({Problem::Severity::warning, at.line, at.column, std::move(message)});
}

void Problems::add(Problem problem) {
  if (!full()) {
    list_.push_back(std::move(problem));
  } else {
    ++dropped_;
  }
}

bool Problems::full() const { return list_.size() >= kMostProblems; }

std::vector<Problem> Problems::sorted() && {
  std::stable_sort(list_.begin(), list_.end(), [](const Problem& a, const Problem& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
  if (dropped_ > 0) {
    list_.push_back(
        {Problem::Severity::error, list_.back().line, list_.back().column,
         std::to_string(dropped_) + " further problems are not listed: correct these first"});
  }
  return std::move(list_);
}

}  // namespace curricula
