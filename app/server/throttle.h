// Slows down whoever tries often: guessed passwords per name and per client, requests per client.
// May be used from several threads. Times are seconds on any clock that only goes forward.
#pragma once

#include <map>
#include <mutex>
#include <string>

namespace app {

// After `free_failures` each further failure doubles the wait, from 15 s up to 15 min. A key
// without a failure for an hour is forgotten.
class FailureThrottle {
 public:
  explicit FailureThrottle(int free_failures);

  // Seconds to wait before the next try, 0 when it may go ahead.
  double wait(const std::string& key, double now) const;
  void failed(const std::string& key, double now);
  void succeeded(const std::string& key);

 private:
  struct Record {
    int failures = 0;
    double last = 0.0;
  };
  double wait_after(const Record& record, double now) const;
  void forget_old(double now);

  const int free_failures_;
  mutable std::mutex mutex_;
  std::map<std::string, Record> records_;
};

// A bucket per client: `rate` requests per second, in bursts of ten seconds' worth.
class RequestThrottle {
 public:
  explicit RequestThrottle(double rate);
  bool admit(const std::string& client, double now);

 private:
  struct Bucket {
    double tokens = 0.0;
    double last = 0.0;
  };
  const double rate_;
  std::mutex mutex_;
  std::map<std::string, Bucket> buckets_;
};

double steady_seconds();  // of the machine's monotonic clock

}  // namespace app
