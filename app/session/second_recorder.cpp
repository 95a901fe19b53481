#include "app/session/second_recorder.h"

#include <utility>

namespace app {

SecondRecorder::SecondRecorder() {
  state_.reserve(256 * 1024);
  reserve();
}

// So that the steps in between allocate nothing.
void SecondRecorder::reserve() {
  current_.inputs.reserve(64 * 1024);
  current_.observed.reserve(16 * 1024);
}

void SecondRecorder::note_input(std::uint32_t step, const sim::HandleInput& input) {
  write_input(current_.inputs, {step, input});
}

void SecondRecorder::note_sample(std::uint32_t step, const assessment::Sample& sample) {
  write_sample(current_.observed, step, sample);
}

void SecondRecorder::close_second(std::uint32_t step, const sim::World& world,
                                  const std::vector<assessment::Event>& events) {
  state_.clear();
  world.append_state(state_);
  last_state_ = hash_of(state_);
  write_hashes(current_.hashes,
               {step, last_state_, hash_of(current_.inputs), hash_of(current_.observed)});
  current_.events.assign(events.begin() + static_cast<std::ptrdiff_t>(events_taken_), events.end());
  events_taken_ = events.size();
  all_inputs_.insert(all_inputs_.end(), current_.inputs.begin(), current_.inputs.end());
  const int next = current_.seq + 1;
  complete_.push_back(std::move(current_));
  current_ = {};
  current_.seq = next;
  reserve();
}

std::vector<RecordedSecond> SecondRecorder::take() { return std::exchange(complete_, {}); }

std::string SecondRecorder::state_hash() const { return hex(last_state_); }

std::string SecondRecorder::input_sha256() const { return sha256_hex(all_inputs_); }

}  // namespace app
