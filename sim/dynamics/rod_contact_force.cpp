#include "sim/dynamics/rod_contact_force.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sim {

// Between two events (an end of the window meeting a cell's boundary) the sum changes linearly
// with the window's place, so its norm is convex there and largest at an event. Hence it is enough
// to slide the window from event to event.
double largest_contact_force(std::span<const Vec3> forces, std::span<const double> cells) {
  assert(forces.size() == cells.size());
  const std::size_t count = forces.size();
  std::size_t head = 0;  // cell that the window's front end is about to enter
  std::size_t tail = 0;  // cell that its rear end lies in
  double head_left = count > 0 ? cells[0] : 0.0;  // mm of it still ahead
  double tail_left = head_left;
  double room = kContactWindow;  // mm the window still lacks in length, at the start
  Vec3 sum = Vec3::Zero();
  double largest = 0.0;
  while (head < count) {
    const double advance = room > 0.0 ? std::min(room, head_left) : std::min(head_left, tail_left);
    sum += advance / cells[head] * forces[head];
    head_left -= advance;
    if (room > 0.0) {
      room -= advance;
    } else {
      sum -= advance / cells[tail] * forces[tail];
      tail_left -= advance;
      if (tail_left <= 0.0 && ++tail < count) tail_left = cells[tail];
    }
    if (head_left <= 0.0 && ++head < count) head_left = cells[head];
    largest = std::max(largest, sum.squaredNorm());
  }
  return std::sqrt(largest);
}

}  // namespace sim
