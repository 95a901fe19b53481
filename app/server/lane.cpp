#include "app/server/lane.h"

#include <utility>

namespace app {

Lane::~Lane() { stop(); }

base::Status Lane::start(const std::string& database_url, int threads, std::size_t queue_limit) {
  for (int i = 0; i < threads; ++i) {
    auto store = database::Store::open(database_url);
    if (!store) return store.error();
    stores_.push_back(*std::move(store));
  }
  queue_limit_ = queue_limit;
  running_ = true;
  for (const auto& store : stores_) {
    threads_.emplace_back([this, &store = *store] { work(store); });
  }
  return base::Done{};
}

bool Lane::post(Job job) {
  {
    const std::lock_guard lock(mutex_);
    if (!running_ || queue_.size() >= queue_limit_) return false;
    queue_.push_back(std::move(job));
  }
  work_waits_.notify_one();
  return true;
}

void Lane::stop() {
  std::deque<Job> dropped;  // destroyed outside the lock: a job may own a connection
  {
    const std::lock_guard lock(mutex_);
    running_ = false;
    dropped.swap(queue_);
  }
  work_waits_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
  stores_.clear();
}

void Lane::work(database::Store& store) {
  for (;;) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      work_waits_.wait(lock, [this] { return !running_ || !queue_.empty(); });
      if (!running_) return;
      job = std::move(queue_.front());
      queue_.pop_front();
    }
    job(store);
  }
}

}  // namespace app
