#include "app/session/live_trial.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <iterator>
#include <mutex>
#include <thread>
#include <utility>

#include "app/session/frame_encoder.h"
#include "sim/base/units.h"

namespace app {
namespace {

using namespace base::units;
using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr auto kStep = std::chrono::milliseconds(1);
constexpr auto kFrame = std::chrono::microseconds(16'667);
constexpr auto kIdleFrame = std::chrono::milliseconds(250);
constexpr int kStepsPerLook = 4;    // steps between two looks into the mailbox
constexpr int kMaxBehind = 100;     // steps; beyond that simulated time slows down, and says so
constexpr double kMaxFeed = 200.0;  // mm/s, as fast as a handle is moved
constexpr double kMaxTurn = 1080.0_deg;  // rad/s
constexpr int kMoveSteps = 16;           // steps over which a single move is spread

// A displacement of the hand that is still to be made.
struct PendingMove {
  double left = 0.0;   // mm or rad
  double speed = 0.0;  // per s

  void add(double amount) { left += amount; }
  void plan(double limit) {
    speed = std::clamp(left / (kMoveSteps * sim::kStepLength), -limit, limit);
  }
  double take() {
    left -= speed * sim::kStepLength;
    return speed;
  }
};

}  // namespace

struct LiveTrial::Parts {
  explicit Parts(LiveTrialSetup its_setup)
      : setup(std::move(its_setup)), run(setup.scene, setup.exercise, setup.keeper->recording()) {
    publish();
  }

  // --- simulation thread -----------------------------------------------------------------------

  void simulate() {
    Clock::time_point origin = Clock::now();  // wall time of step 0, moved along by pauses
    Clock::time_point next_frame = origin;
    bool was_paused = true;
    Clock::time_point paused_at = origin;
    while (!run.ended()) {
      const bool pause_now = take_commands();
      const Clock::time_point now = Clock::now();
      if (abort_wanted.load()) {
        if (was_paused && ever_resumed) note_pause(now - paused_at);
        run.abort();
        break;
      }
      if (pause_now) {
        if (!was_paused) {
          paused_at = now;
          run.note_event("paused");
        }
        was_paused = true;
        publish_every(next_frame, now, kIdleFrame);
        wait_for_command();
        continue;
      }
      const std::int64_t done = run.world().observation().step;
      if (was_paused) {
        if (ever_resumed) {
          note_pause(now - paused_at);
          run.note_event("resumed");
        }
        ever_resumed = true;
        was_paused = false;
        origin = now - done * kStep;
      }
      step_until_due(origin, now, done);
      publish_every(next_frame, now, kFrame);
      hand_over();
      std::this_thread::sleep_until(
          std::min(next_frame, origin + (run.world().observation().step + kStepsPerLook) * kStep));
    }
    publish();
    hand_over();
    simulated.store(true);
    queue_changed.notify_all();
  }

  void step_until_due(Clock::time_point& origin, Clock::time_point now, std::int64_t done) {
    std::int64_t due = (now - origin) / kStep - done;
    if (due > kMaxBehind) {  // too slow for the wall clock: let simulated time fall back
      const auto late = (due - kMaxBehind) * kStep;
      origin += late;
      wall.slowed += Seconds(late).count();
      due = kMaxBehind;
    }
    for (std::int64_t i = 0; i < std::min<std::int64_t>(due, kStepsPerLook * 4); ++i) {
      if (run.world().observation().step % kMoveSteps == 0) {
        move.plan(kMaxFeed);
        rotate.plan(kMaxTurn);
      }
      run.step({std::clamp(hand.feed + move.take(), -kMaxFeed, kMaxFeed),
                std::clamp(hand.turn + rotate.take(), -kMaxTurn, kMaxTurn)});
      peaks.take(run.world().observation());
      if (run.ended()) return;
    }
  }

  // The newest command; true while the trial is paused.
  bool take_commands() {
    const std::lock_guard lock(mailbox_mutex);
    hand.feed = mailbox.feed;
    hand.turn = mailbox.turn;
    move.add(std::exchange(mailbox.move, 0.0));
    rotate.add(std::exchange(mailbox.rotate, 0.0));
    if (paused_wanted) move = rotate = {};  // nor does a movement begun before go on afterwards
    return paused_wanted;
  }

  void wait_for_command() {
    std::unique_lock lock(mailbox_mutex);
    mailbox_changed.wait_for(lock, std::chrono::milliseconds(50),
                             [this] { return !paused_wanted || abort_wanted.load(); });
  }

  void note_pause(Clock::duration length) {
    const double seconds = Seconds(length).count();
    wall.paused += seconds;
    wall.longest_pause = std::max(wall.longest_pause, seconds);
  }

  void publish_every(Clock::time_point& next, Clock::time_point now, Clock::duration period) {
    if (now < next) return;
    publish();
    next = std::max(next + period, now);
  }

  void publish() {
    bool paused;
    {
      const std::lock_guard lock(mailbox_mutex);
      paused = paused_wanted;
    }
    const std::lock_guard lock(frame_mutex);
    frame_context.paused = paused;
    frame_context.filed = finished.load() && setup.keeper->recording() == Recording::written;
    frame_context.paused_for = wall.paused;
    frame_context.slowed_for = wall.slowed;
    ++frame_context.frame;
    newest =
        std::make_shared<const std::vector<std::byte>>(encode_frame(run, peaks, frame_context));
    frame_changed.notify_all();
  }

  void hand_over() {
    std::vector<RecordedSecond> seconds = run.take_recorded();
    if (seconds.empty()) return;
    const std::lock_guard lock(queue_mutex);
    for (RecordedSecond& second : seconds) queue.push_back(std::move(second));
    queue_changed.notify_all();
  }

  // --- writer thread ---------------------------------------------------------------------------

  void write() {
    const base::Status opened = setup.keeper->open();
    if (!opened) fail(opened.error().message);
    std::vector<RecordedSecond> unwritten;
    while (true) {
      {
        std::unique_lock lock(queue_mutex);
        queue_changed.wait_for(lock, std::chrono::milliseconds(500),
                               [this] { return !queue.empty() || simulated.load(); });
        std::move(queue.begin(), queue.end(), std::back_inserter(unwritten));
        queue.clear();
        if (simulated.load() && queue.empty() && (unwritten.empty() || !opened)) break;
      }
      if (!opened || unwritten.empty()) continue;
      const base::Status written = setup.keeper->append(unwritten);
      if (!written) {
        fail(written.error().message);
        if (simulated.load()) break;
        continue;  // tried again with the next second
      }
      unwritten.clear();
    }
    if (opened && unwritten.empty()) judge_run();
    if (failure_text().empty()) finished.store(true);
    publish();
  }

  void judge_run() {
    auto judged = setup.keeper->finish(run, setup.exercise, wall);
    if (!judged) return fail(judged.error().message);
    result.end_reason = run.monitor().task().end_reason;
    result.judgement = *std::move(judged);
    result.interrupted = is_interrupted(
        wall, static_cast<double>(run.world().observation().step) * sim::kStepLength);
  }

  // A trial that cannot be stored must not go on as if it counted.
  void fail(const std::string& why) {
    {
      const std::lock_guard lock(failure_mutex);
      failure = why;
    }
    abort_wanted.store(true);
    mailbox_changed.notify_all();
  }

  std::string failure_text() const {
    const std::lock_guard lock(failure_mutex);
    return failure;
  }

  LiveTrialSetup setup;
  TrialRun run;  // simulation thread until `simulated`, then the writer
  GaugePeaks peaks;
  WallTime wall;
  bool ever_resumed = false;
  LiveCommand hand;
  PendingMove move, rotate;

  std::mutex mailbox_mutex;
  std::condition_variable mailbox_changed;
  LiveCommand mailbox;
  bool paused_wanted = true;
  std::atomic<bool> abort_wanted{false};

  mutable std::mutex frame_mutex;
  mutable std::condition_variable frame_changed;
  FrameContext frame_context;
  std::shared_ptr<const std::vector<std::byte>> newest;  // shared: with the sockets that send it

  std::mutex queue_mutex;
  std::condition_variable queue_changed;
  std::vector<RecordedSecond> queue;
  std::atomic<bool> simulated{false};
  LiveResult result;  // the writer's until `finished`, then constant
  std::atomic<bool> finished{false};

  mutable std::mutex failure_mutex;
  std::string failure;

  std::thread simulation, writer;  // last: they use everything above
};

LiveTrial::LiveTrial(LiveTrialSetup setup) : parts_(std::make_unique<Parts>(std::move(setup))) {
  parts_->simulation = std::thread([p = parts_.get()] { p->simulate(); });
  parts_->writer = std::thread([p = parts_.get()] { p->write(); });
}

LiveTrial::~LiveTrial() {
  abort();
  parts_->simulation.join();
  parts_->writer.join();
}

void LiveTrial::command(const LiveCommand& command) {
  const std::lock_guard lock(parts_->mailbox_mutex);
  parts_->mailbox.feed = command.feed;
  parts_->mailbox.turn = command.turn;
  parts_->mailbox.move += command.move;
  parts_->mailbox.rotate += command.rotate;
}

void LiveTrial::pause() {
  const std::lock_guard lock(parts_->mailbox_mutex);
  parts_->paused_wanted = true;
  parts_->mailbox = {};  // nobody holds the handle
}

void LiveTrial::resume() {
  {
    const std::lock_guard lock(parts_->mailbox_mutex);
    parts_->paused_wanted = false;
  }
  parts_->mailbox_changed.notify_all();
}

void LiveTrial::abort() {
  parts_->abort_wanted.store(true);
  parts_->mailbox_changed.notify_all();
}

std::shared_ptr<const std::vector<std::byte>> LiveTrial::frame(std::uint64_t& last) const {
  const std::lock_guard lock(parts_->frame_mutex);
  if (parts_->frame_context.frame == last) return nullptr;
  last = parts_->frame_context.frame;
  return parts_->newest;
}

bool LiveTrial::wait_frame(std::uint64_t last, int timeout_ms) const {
  std::unique_lock lock(parts_->frame_mutex);
  return parts_->frame_changed.wait_for(lock, std::chrono::milliseconds(timeout_ms),
                                        [&] { return parts_->frame_context.frame != last; });
}

bool LiveTrial::paused() const {
  const std::lock_guard lock(parts_->mailbox_mutex);
  return parts_->paused_wanted;
}

bool LiveTrial::ended() const { return parts_->simulated.load(); }
bool LiveTrial::finished() const { return parts_->finished.load(); }
std::string LiveTrial::failure() const { return parts_->failure_text(); }
const LiveResult& LiveTrial::result() const { return parts_->result; }
const std::string& LiveTrial::trial_id() const { return parts_->setup.trial_id; }
const std::string& LiveTrial::person_id() const { return parts_->setup.person_id; }

}  // namespace app
