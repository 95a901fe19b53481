// What is wrong with a file, collected while it is read.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "curricula/check.h"

namespace curricula {

struct YamlNode;

// Collects problems; a broken megabyte must not make a million sentences.
class Problems {
 public:
  void error(int line, int column, std::string message);
  void error(const YamlNode& at, std::string message);
  void warning(const YamlNode& at, std::string message);
  bool any_error() const { return any_error_; }
  std::size_t count() const { return list_.size() + dropped_; }
  bool full() const;  // further ones are counted only: no need to look for good advice
  std::vector<Problem> sorted() &&;  // in the order of their lines

 private:
  void add(Problem problem);
  std::vector<Problem> list_;
  bool any_error_ = false;
  std::size_t dropped_ = 0;
};

}  // namespace curricula
