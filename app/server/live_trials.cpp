#include "app/server/live_trials.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <utility>

#include <spdlog/spdlog.h>

#include "app/server/throttle.h"

namespace app {
namespace {

constexpr int kFrameWaitMs = 100;     // how often to look around while nothing moves
constexpr double kLinger = 30.0;      // s a finished trial can still be joined, to hear that it is
constexpr double kNeverFiled = 60.0;  // s after its end that a trial is given up

}  // namespace

struct LiveTrials::Entry {
  Entry(RunningTrial what, LiveTrialSetup setup, std::function<void(const LiveResult&)> tell)
      : about(std::move(what)), on_finished(std::move(tell)), trial(std::move(setup)) {}

  const RunningTrial about;
  const std::function<void(const LiveResult&)> on_finished;
  LiveTrial trial;
  std::thread pump;
  std::atomic<bool> closing{false};
  std::atomic<bool> finished{false};  // filed or given up: the person may start another
  std::atomic<bool> gone{false};      // the pump has ended

  std::mutex mutex;  // guards what follows
  std::map<std::size_t, LiveListener> listeners;
  std::size_t next_seat = 1;
  std::size_t wheel = 0;  // the seat that steers; 0: nobody
  double unsteered_since = steady_seconds();
  std::optional<double> still_since = steady_seconds();  // paused; absent while it runs

  void run(const LivePatience& patience);
  void send_newest_frame(std::uint64_t& last);
  void tell_finished(const std::string& failure);
  bool abandoned(const LivePatience& patience);
  void pause();  // under the lock
};

void LiveTrials::Entry::send_newest_frame(std::uint64_t& last) {
  if (!trial.wait_frame(last, kFrameWaitMs)) return;
  const Frame frame = trial.frame(last);
  if (!frame) return;
  const std::lock_guard lock(mutex);
  for (const auto& [seat, listener] : listeners) listener.frame(frame);
}

void LiveTrials::Entry::tell_finished(const std::string& failure) {
  const std::lock_guard lock(mutex);
  finished = true;
  for (const auto& [seat, listener] : listeners) {
    if (failure.empty()) {
      listener.finished(about.practice);
    } else {
      listener.failed(failure);
    }
  }
}

bool LiveTrials::Entry::abandoned(const LivePatience& patience) {
  const std::lock_guard lock(mutex);
  const double now = steady_seconds();
  if (about.practice) return still_since && now - *still_since > patience.practice_s;
  return wheel == 0 && now - unsteered_since > patience.trial_s;
}

void LiveTrials::Entry::pause() {
  trial.pause();
  if (!still_since) still_since = steady_seconds();
}

// Carries frames to the listeners until the trial is finished and a little longer.
void LiveTrials::Entry::run(const LivePatience& patience) {
  std::uint64_t last = 0;
  double ended_at = -1.0;
  while (!trial.finished() && trial.failure().empty()) {
    send_newest_frame(last);
    const double now = steady_seconds();
    if (!trial.ended()) {
      if (closing || abandoned(patience)) trial.abort();
    } else if (ended_at < 0.0) {
      ended_at = now;
    } else if (now - ended_at > kNeverFiled) {
      break;
    }
  }
  send_newest_frame(last);
  std::string failure = trial.failure();
  if (failure.empty() && !trial.finished()) failure = "The trial could not be filed in time.";
  if (!failure.empty()) spdlog::error("trial {}: {}", about.trial_id, failure);
  if (failure.empty() && on_finished) on_finished(trial.result());
  tell_finished(failure);

  const double until = steady_seconds() + kLinger;
  while (!closing && steady_seconds() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(kFrameWaitMs));
  }
  gone = true;
}

LiveTrials::Seat::Seat(std::shared_ptr<Entry> entry, std::size_t number, bool may_steer)
    : entry_(std::move(entry)), number_(number), may_steer_(may_steer) {}

LiveTrials::Seat::~Seat() {
  const std::lock_guard lock(entry_->mutex);
  entry_->listeners.erase(number_);
  if (entry_->wheel != number_) return;
  entry_->wheel = 0;
  entry_->unsteered_since = steady_seconds();
  entry_->pause();
}

bool LiveTrials::Seat::take_wheel() {
  if (!may_steer_) return false;
  const std::lock_guard lock(entry_->mutex);
  if (entry_->wheel == 0) entry_->wheel = number_;
  return entry_->wheel == number_;
}

bool LiveTrials::Seat::steers() const { return entry_->wheel == number_; }

void LiveTrials::Seat::command(const LiveCommand& command) {
  const std::lock_guard lock(entry_->mutex);
  if (steers()) entry_->trial.command(command);
}

void LiveTrials::Seat::pause() {
  const std::lock_guard lock(entry_->mutex);
  if (steers()) entry_->pause();
}

void LiveTrials::Seat::resume() {
  const std::lock_guard lock(entry_->mutex);
  if (!steers()) return;
  entry_->still_since.reset();
  entry_->trial.resume();
}

void LiveTrials::Seat::abort() {
  const std::lock_guard lock(entry_->mutex);
  if (steers()) entry_->trial.abort();
}

LiveTrials::LiveTrials(int limit, LivePatience patience) : limit_(limit), patience_(patience) {}

LiveTrials::~LiveTrials() { stop(); }

base::Status LiveTrials::reserve(const std::string& person_id) {
  const std::lock_guard lock(mutex_);
  forget_finished();
  const auto own = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) {
    return entry.second->about.person_id == person_id && !entry.second->finished;
  });
  if (own != entries_.end() && own->second->about.practice) {
    return base::Error{base::ErrorCode::conflict,
                       "You are practising; go back to it, or end the practice first."};
  }
  if (own != entries_.end() || reserved_.contains(person_id)) {
    return base::Error{base::ErrorCode::conflict,
                       "You have a trial running; go back to it, or end it first."};
  }
  const auto running = std::count_if(entries_.begin(), entries_.end(),
                                     [](const auto& entry) { return !entry.second->finished; });
  if (stopped_ || running + static_cast<std::ptrdiff_t>(reserved_.size()) >= limit_) {
    return base::Error{base::ErrorCode::unavailable,
                       "As many trials are running as this server takes; try again in a minute."};
  }
  reserved_.insert(person_id);
  return base::Done{};
}

void LiveTrials::release(const std::string& person_id) {
  const std::lock_guard lock(mutex_);
  reserved_.erase(person_id);
}

base::Status LiveTrials::start(const RunningTrial& trial, LiveTrialSetup setup,
                               std::function<void(const LiveResult&)> on_finished) {
  const std::lock_guard lock(mutex_);
  if (stopped_) {
    return base::Error{base::ErrorCode::unavailable, "The server is stopping; try again later."};
  }
  // shared: the seats keep it until the last browser has left
  auto entry = std::make_shared<Entry>(trial, std::move(setup), std::move(on_finished));
  entry->pump = std::thread([&running = *entry, patience = patience_] { running.run(patience); });
  entries_.emplace(trial.trial_id, std::move(entry));
  return base::Done{};
}

std::optional<RunningTrial> LiveTrials::of_person(const std::string& person_id) {
  const std::lock_guard lock(mutex_);
  for (const auto& [id, entry] : entries_) {
    if (entry->about.person_id == person_id && !entry->finished) return entry->about;
  }
  return std::nullopt;
}

std::optional<RunningTrial> LiveTrials::find(const std::string& trial_id) {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(trial_id);
  if (found == entries_.end()) return std::nullopt;
  return found->second->about;
}

std::vector<LiveTrials::Running> LiveTrials::running() {
  const std::lock_guard lock(mutex_);
  std::vector<Running> list;
  // by id, which is by the time of their beginning
  for (const auto& [id, entry] : entries_) {
    if (entry->finished || entry->about.practice) continue;
    list.push_back({entry->about, entry->trial.paused()});
  }
  return list;
}

bool LiveTrials::runs(const std::string& trial_id) {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(trial_id);
  return found != entries_.end() && !found->second->gone;
}

base::Result<std::unique_ptr<LiveTrials::Seat>> LiveTrials::sit(const std::string& trial_id,
                                                                bool may_steer,
                                                                LiveListener listener) {
  std::shared_ptr<Entry> entry;
  {
    const std::lock_guard lock(mutex_);
    const auto found = entries_.find(trial_id);
    if (found != entries_.end() && !found->second->gone) entry = found->second;
  }
  if (!entry) {
    return base::Error{base::ErrorCode::not_found,
                       "This trial is not running any more; open its debrief."};
  }
  const std::lock_guard lock(entry->mutex);
  const std::size_t number = entry->next_seat++;
  if (entry->finished) {
    listener.finished(entry->about.practice);
  } else {
    // the newest picture at once: a paused trial makes no new one
    std::uint64_t none = 0;
    if (const Frame frame = entry->trial.frame(none)) listener.frame(frame);
  }
  entry->listeners.emplace(number, std::move(listener));
  return std::make_unique<Seat>(entry, number, may_steer);
}

void LiveTrials::stop() {
  std::map<std::string, std::shared_ptr<Entry>> closing;
  {
    const std::lock_guard lock(mutex_);
    stopped_ = true;
    closing.swap(entries_);
  }
  for (const auto& [id, entry] : closing) entry->closing = true;
  for (const auto& [id, entry] : closing) entry->pump.join();
}

void LiveTrials::forget_finished() {
  std::erase_if(entries_, [](const auto& item) {
    if (!item.second->gone) return false;
    item.second->pump.join();
    return true;
  });
}

}  // namespace app
