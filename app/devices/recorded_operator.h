// Plays the recorded inputs of a trial again.
#pragma once

#include <cstddef>
#include <vector>

#include "app/devices/operator.h"
#include "app/session/recording.h"

namespace app {

class RecordedOperator final : public Operator {
 public:
  explicit RecordedOperator(std::vector<InputChange> changes) : changes_(std::move(changes)) {}

  sim::HandleInput next(const sim::Observation& seen, const ExerciseMonitor&) override {
    const auto step = static_cast<std::uint32_t>(seen.step + 1);
    while (next_ < changes_.size() && changes_[next_].step <= step) {
      current_ = changes_[next_++].input;
    }
    return current_;
  }

 private:
  std::vector<InputChange> changes_;
  std::size_t next_ = 0;
  sim::HandleInput current_;
};

}  // namespace app
