// How a trial's trace is written as bytes, one simulated second at a time, and read again.
//
//   inputs/1    per change of the hand: u32 step, f64 feed mm/s, f64 turn rad/s. Lossless. `step`
//               is the number of the first step it took part in.
//   observed/1  per 10 ms: u32 step, i32 contacts, f64 handle axial mm, f64 rotation rad, then 13
//               f32: tip (mm), tip direction, inserted mm, handle force N, torque N mm, contact
//               force N, its peak since the sample before, contact load N, peak |handle force| N.
//   hashes/1    per second and at the end: u32 step, then BLAKE2b-256 of the full state, of the
//               second's inputs and of its observed bytes.
//
// All little endian, packed. Second k holds the steps 1000 k + 1 ... 1000 (k + 1).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "assessment/trial.h"
#include "sim/base/result.h"
#include "sim/dynamics/world.h"

namespace app {

inline constexpr int kStepsPerSecond = 1000;
inline constexpr int kStepsPerSample = 10;
inline constexpr const char* kInputsCodec = "inputs/1";
inline constexpr const char* kObservedCodec = "observed/1";
inline constexpr const char* kHashesCodec = "hashes/1";

using Hash = std::array<std::byte, 32>;
Hash hash_of(std::span<const std::byte> bytes);
std::string hex(std::span<const std::byte> bytes);
std::string sha256_hex(std::span<const std::byte> bytes);

struct InputChange {
  std::uint32_t step = 0;
  sim::HandleInput input;
};

struct SecondHashes {
  std::uint32_t step = 0;
  Hash state{}, inputs{}, observed{};
};

void write_input(std::vector<std::byte>& out, const InputChange& change);
void write_sample(std::vector<std::byte>& out, std::uint32_t step,
                  const assessment::Sample& sample);
void write_hashes(std::vector<std::byte>& out, const SecondHashes& hashes);

// The sample as it reads back from the record: what every metric is computed from, so that the
// same value comes out today and from the stored trace.
assessment::Sample as_recorded(const assessment::Sample& sample);

// Fail with corrupt_data when the bytes are not whole records in rising order of steps.
base::Result<std::vector<InputChange>> read_inputs(std::span<const std::byte> bytes);
base::Result<std::vector<assessment::Sample>> read_samples(std::span<const std::byte> bytes);
base::Result<std::vector<SecondHashes>> read_hashes(std::span<const std::byte> bytes);

}  // namespace app
