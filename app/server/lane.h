// A few threads that answer requests, each with its own connection to the database, behind a
// queue of bounded length.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "database/store.h"
#include "sim/base/result.h"

namespace app {

class Lane {
 public:
  // A job must not throw.
  using Job = std::function<void(database::Store&)>;

  ~Lane();  // stops
  // Opens the connections and starts the threads. Fails as Store::open does.
  base::Status start(const std::string& database_url, int threads, std::size_t queue_limit);
  // False when too many wait already, or the lane has stopped: the caller says "busy".
  bool post(Job job);
  // Finishes the jobs that run, drops those that wait, joins.
  void stop();

 private:
  void work(database::Store& store);

  std::mutex mutex_;
  std::condition_variable work_waits_;
  std::deque<Job> queue_;
  std::size_t queue_limit_ = 0;
  bool running_ = false;
  std::vector<std::unique_ptr<database::Store>> stores_;
  std::vector<std::thread> threads_;
};

}  // namespace app
