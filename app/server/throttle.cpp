#include "app/server/throttle.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace app {
namespace {

constexpr double kFirstWait = 15.0, kLongestWait = 900.0, kForgetAfter = 3600.0;  // s
constexpr std::size_t kManyKeys = 10'000;  // when to look for those to forget
constexpr double kBurst = 10.0;            // s worth of requests

}  // namespace

FailureThrottle::FailureThrottle(int free_failures) : free_failures_(free_failures) {}

double FailureThrottle::wait_after(const Record& record, double now) const {
  if (record.failures < free_failures_) return 0.0;
  const int extra = std::min(record.failures - free_failures_, 16);
  const double pause = std::min(kLongestWait, std::ldexp(kFirstWait, extra));
  return std::max(0.0, record.last + pause - now);
}

double FailureThrottle::wait(const std::string& key, double now) const {
  const std::lock_guard lock(mutex_);
  const auto found = records_.find(key);
  return found == records_.end() ? 0.0 : wait_after(found->second, now);
}

void FailureThrottle::failed(const std::string& key, double now) {
  const std::lock_guard lock(mutex_);
  if (records_.size() >= kManyKeys) forget_old(now);
  Record& record = records_[key];
  if (now - record.last > kForgetAfter) record.failures = 0;
  ++record.failures;
  record.last = now;
}

void FailureThrottle::succeeded(const std::string& key) {
  const std::lock_guard lock(mutex_);
  records_.erase(key);
}

void FailureThrottle::forget_old(double now) {
  std::erase_if(records_, [&](const auto& entry) {
    return now - entry.second.last > kForgetAfter || wait_after(entry.second, now) <= 0.0;
  });
}

RequestThrottle::RequestThrottle(double rate) : rate_(rate) {}

bool RequestThrottle::admit(const std::string& client, double now) {
  const std::lock_guard lock(mutex_);
  const double full = rate_ * kBurst;
  if (buckets_.size() >= kManyKeys) {
    std::erase_if(buckets_, [&](const auto& entry) { return now - entry.second.last > kBurst; });
  }
  Bucket& bucket = buckets_.try_emplace(client, Bucket{full, now}).first->second;
  bucket.tokens = std::min(full, bucket.tokens + (now - bucket.last) * rate_);
  bucket.last = now;
  if (bucket.tokens < 1.0) return false;
  bucket.tokens -= 1.0;
  return true;
}

double steady_seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

}  // namespace app
