#pragma once

// The byte layout of one binary frame of the live channel: little endian, packed, the header
// first, then limit_count limits, then node_count nodes from the access to the tip.
// Written by app/wire/generate.mjs from wire.schema.yaml. Change the schema, not this file.

#include <cstddef>
#include <cstdint>

namespace app::wire {

inline constexpr std::uint32_t kFrameMagic = 0x46544143u;
inline constexpr std::uint16_t kFrameVersion = 1;

// bits of the field flags
inline constexpr std::uint16_t kFlagPaused = 1;
inline constexpr std::uint16_t kFlagEnded = 2;
inline constexpr std::uint16_t kFlagFiled = 4;
inline constexpr std::uint16_t kFlagStarted = 8;

// values of the field end_reason
inline constexpr std::uint16_t kEndReasonCompleted = 0;
inline constexpr std::uint16_t kEndReasonTimeout = 1;
inline constexpr std::uint16_t kEndReasonLimit = 2;
inline constexpr std::uint16_t kEndReasonAborted = 3;
inline constexpr std::uint16_t kEndReasonDiverged = 4;

// header: byte offsets from its start
namespace frame_header {
inline constexpr std::size_t kMagicAt = 0;
inline constexpr std::size_t kVersionAt = 4;
inline constexpr std::size_t kFlagsAt = 6;
inline constexpr std::size_t kFrameAt = 8;
inline constexpr std::size_t kStepAt = 12;
inline constexpr std::size_t kTimeSAt = 16;
inline constexpr std::size_t kElapsedSAt = 24;
inline constexpr std::size_t kPausedSAt = 32;
inline constexpr std::size_t kSlowedSAt = 40;
inline constexpr std::size_t kHandleAxialMmAt = 44;
inline constexpr std::size_t kHandleRotationDegAt = 48;
inline constexpr std::size_t kInsertedMmAt = 52;
inline constexpr std::size_t kHandleForceNAt = 56;
inline constexpr std::size_t kHandleForcePeakNAt = 60;
inline constexpr std::size_t kHandleTorqueNMmAt = 64;
inline constexpr std::size_t kHandleTorquePeakNMmAt = 68;
inline constexpr std::size_t kContactForceNAt = 72;
inline constexpr std::size_t kContactForcePeakNAt = 76;
inline constexpr std::size_t kStepValueAt = 80;
inline constexpr std::size_t kStepStartAt = 84;
inline constexpr std::size_t kHeldSAt = 88;
inline constexpr std::size_t kStepIndexAt = 92;
inline constexpr std::size_t kEndReasonAt = 94;
inline constexpr std::size_t kContactCountAt = 96;
inline constexpr std::size_t kLimitCountAt = 98;
inline constexpr std::size_t kNodeCountAt = 100;
inline constexpr std::size_t kReservedAt = 102;
inline constexpr std::size_t kSize = 104;
}  // namespace frame_header

// limit: byte offsets from its start
namespace frame_limit {
inline constexpr std::size_t kValueAt = 0;
inline constexpr std::size_t kBreachedAt = 4;
inline constexpr std::size_t kSize = 8;
}  // namespace frame_limit

// node: byte offsets from its start
namespace frame_node {
inline constexpr std::size_t kXMmAt = 0;
inline constexpr std::size_t kYMmAt = 4;
inline constexpr std::size_t kZMmAt = 8;
inline constexpr std::size_t kForceNAt = 12;
inline constexpr std::size_t kSize = 16;
}  // namespace frame_node

constexpr std::size_t frame_size(std::size_t limit_count, std::size_t node_count) {
  return frame_header::kSize + limit_count * frame_limit::kSize + node_count * frame_node::kSize;
}

}  // namespace app::wire
