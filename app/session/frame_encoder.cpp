#include "app/session/frame_encoder.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <type_traits>

#include "app/wire/frame_layout.h"

namespace app {
namespace {

constexpr double kDegreesPerRadian = 180.0 / std::numbers::pi;

template <typename T>
void put(std::vector<std::byte>& out, std::size_t at, T value) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::memcpy(out.data() + at, &value, sizeof(T));
}

void put_single(std::vector<std::byte>& out, std::size_t at, double value) {
  put(out, at, static_cast<float>(value));
}

std::uint16_t code_of(assessment::EndReason reason) {
  switch (reason) {
    case assessment::EndReason::completed:
      return wire::kEndReasonCompleted;
    case assessment::EndReason::timeout:
      return wire::kEndReasonTimeout;
    case assessment::EndReason::limit:
      return wire::kEndReasonLimit;
    case assessment::EndReason::diverged:
      return wire::kEndReasonDiverged;
    default:
      return wire::kEndReasonAborted;
  }
}

void put_header(std::vector<std::byte>& out, const TrialRun& run, const GaugePeaks& peaks,
                const FrameContext& context) {
  namespace at = wire::frame_header;
  const sim::Observation& seen = run.world().observation();
  const TaskState& task = run.monitor().task();

  std::uint16_t flags = 0;
  if (context.paused) flags |= wire::kFlagPaused;
  if (run.ended()) flags |= wire::kFlagEnded;
  if (context.filed) flags |= wire::kFlagFiled;
  if (task.started) flags |= wire::kFlagStarted;

  // a rotate step is measured in degrees on the wire, everything else as it is
  const auto& steps = run.monitor().descriptions();
  const auto index = std::min(static_cast<std::size_t>(task.step_index), steps.size() - 1);
  const bool turning = steps[index].kind == curricula::Step::Kind::rotate;
  const double scale = turning ? kDegreesPerRadian : 1.0;

  put(out, at::kMagicAt, wire::kFrameMagic);
  put(out, at::kVersionAt, wire::kFrameVersion);
  put(out, at::kFlagsAt, flags);
  put(out, at::kFrameAt, context.frame);
  put(out, at::kStepAt, static_cast<std::uint32_t>(seen.step));
  put(out, at::kTimeSAt, static_cast<double>(seen.step) * sim::kStepLength);
  put(out, at::kElapsedSAt, task.elapsed);
  put(out, at::kPausedSAt, context.paused_for);
  put_single(out, at::kSlowedSAt, context.slowed_for);
  put_single(out, at::kHandleAxialMmAt, seen.handle_axial);
  put_single(out, at::kHandleRotationDegAt, seen.handle_rotation * kDegreesPerRadian);
  put_single(out, at::kInsertedMmAt, seen.inserted_length);
  put_single(out, at::kHandleForceNAt, seen.handle_force);
  put_single(out, at::kHandleForcePeakNAt, peaks.handle_force);
  put_single(out, at::kHandleTorqueNMmAt, seen.handle_torque);
  put_single(out, at::kHandleTorquePeakNMmAt, peaks.handle_torque);
  put_single(out, at::kContactForceNAt, seen.contact_force);
  put_single(out, at::kContactForcePeakNAt, peaks.contact_force);
  put_single(out, at::kStepValueAt, task.step_value * scale);
  put_single(out, at::kStepStartAt, task.step_start * scale);
  put_single(out, at::kHeldSAt, task.held);
  put(out, at::kStepIndexAt, static_cast<std::uint16_t>(task.step_index));
  put(out, at::kEndReasonAt, code_of(task.end_reason));
  put(out, at::kContactCountAt, static_cast<std::uint16_t>(seen.contact_count));
}

}  // namespace

void GaugePeaks::take(const sim::Observation& seen) {
  handle_force = std::max(handle_force, std::abs(seen.handle_force));
  handle_torque = std::max(handle_torque, std::abs(seen.handle_torque));
  contact_force = std::max(contact_force, seen.contact_force);
}

std::vector<std::byte> encode_frame(const TrialRun& run, const GaugePeaks& peaks,
                                    const FrameContext& context) {
  const auto& limits = run.monitor().limits();
  const auto nodes = run.world().nodes();
  const auto forces = run.world().node_forces();
  std::vector<std::byte> out(wire::frame_size(limits.size(), nodes.size()));

  put_header(out, run, peaks, context);
  put(out, wire::frame_header::kLimitCountAt, static_cast<std::uint16_t>(limits.size()));
  put(out, wire::frame_header::kNodeCountAt, static_cast<std::uint16_t>(nodes.size()));

  std::size_t at = wire::frame_header::kSize;
  for (const LimitState& limit : limits) {
    put_single(out, at + wire::frame_limit::kValueAt, limit.value);
    put(out, at + wire::frame_limit::kBreachedAt, std::uint32_t{limit.breached ? 1u : 0u});
    at += wire::frame_limit::kSize;
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    put_single(out, at + wire::frame_node::kXMmAt, nodes[i].x());
    put_single(out, at + wire::frame_node::kYMmAt, nodes[i].y());
    put_single(out, at + wire::frame_node::kZMmAt, nodes[i].z());
    put_single(out, at + wire::frame_node::kForceNAt, forces[i].norm());
    at += wire::frame_node::kSize;
  }
  return out;
}

}  // namespace app
