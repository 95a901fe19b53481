#include "app/session/recording.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <type_traits>

#include <sodium.h>

namespace app {
namespace {

static_assert(std::endian::native == std::endian::little, "the codecs write native bytes");

constexpr std::size_t kInputBytes = 4 + 2 * 8;
constexpr std::size_t kSampleBytes = 4 + 4 + 2 * 8 + 13 * 4;
constexpr std::size_t kHashesBytes = 4 + 3 * 32;

template <typename T>
void put(std::vector<std::byte>& out, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto* bytes = reinterpret_cast<const std::byte*>(&value);
  out.insert(out.end(), bytes, bytes + sizeof(T));
}

template <typename T>
T take(std::span<const std::byte>& in) {
  T value;
  std::memcpy(&value, in.data(), sizeof(T));
  in = in.subspan(sizeof(T));
  return value;
}

// The single-precision fields of a sample, in the order of the record.
std::array<double*, 13> single_fields(assessment::Sample& s) {
  return {&s.tip[0],
          &s.tip[1],
          &s.tip[2],
          &s.tip_direction[0],
          &s.tip_direction[1],
          &s.tip_direction[2],
          &s.inserted_length,
          &s.handle_force,
          &s.handle_torque,
          &s.contact_force,
          &s.contact_force_peak,
          &s.contact_load,
          &s.handle_force_peak};
}

struct NumberedSample {
  std::uint32_t step = 0;
  assessment::Sample sample;
};

NumberedSample take_sample(std::span<const std::byte>& in) {
  NumberedSample taken;
  assessment::Sample& sample = taken.sample;
  taken.step = take<std::uint32_t>(in);
  sample.time = taken.step * sim::kStepLength;
  sample.contact_count = take<std::int32_t>(in);
  sample.handle_axial = take<double>(in);
  sample.handle_rotation = take<double>(in);
  for (double* field : single_fields(sample)) *field = static_cast<double>(take<float>(in));
  return taken;
}

base::Error broken(const char* what) {
  return {base::ErrorCode::corrupt_data, std::string("the ") + what +
                                             " of this trial are damaged: the bytes are not whole "
                                             "records in rising order"};
}

}  // namespace

Hash hash_of(std::span<const std::byte> bytes) {
  Hash hash;
  crypto_generichash(reinterpret_cast<unsigned char*>(hash.data()), hash.size(),
                     reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), nullptr,
                     0);
  return hash;
}

std::string hex(std::span<const std::byte> bytes) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const std::byte b : bytes) {
    text += kDigits[std::to_integer<unsigned>(b) >> 4];
    text += kDigits[std::to_integer<unsigned>(b) & 15];
  }
  return text;
}

std::string sha256_hex(std::span<const std::byte> bytes) {
  Hash hash;
  crypto_hash_sha256(reinterpret_cast<unsigned char*>(hash.data()),
                     reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  return hex(hash);
}

void write_input(std::vector<std::byte>& out, const InputChange& change) {
  put(out, change.step);
  put(out, change.input.feed);
  put(out, change.input.turn);
}

void write_sample(std::vector<std::byte>& out, std::uint32_t step,
                  const assessment::Sample& sample) {
  assessment::Sample copy = sample;
  put(out, step);
  put(out, sample.contact_count);
  put(out, sample.handle_axial);
  put(out, sample.handle_rotation);
  for (const double* field : single_fields(copy)) put(out, static_cast<float>(*field));
}

void write_hashes(std::vector<std::byte>& out, const SecondHashes& hashes) {
  put(out, hashes.step);
  put(out, hashes.state);
  put(out, hashes.inputs);
  put(out, hashes.observed);
}

// Through the very bytes, so that it cannot differ from what is read later. (Rounding the fields in
// place is not enough: g++ 12 at -O3 leaves some of them as they were.)
assessment::Sample as_recorded(const assessment::Sample& sample) {
  std::vector<std::byte> bytes;
  bytes.reserve(kSampleBytes);
  write_sample(bytes, 0, sample);
  std::span<const std::byte> in = bytes;
  assessment::Sample copy = take_sample(in).sample;
  copy.time = sample.time;
  return copy;
}

base::Result<std::vector<InputChange>> read_inputs(std::span<const std::byte> bytes) {
  if (bytes.size() % kInputBytes != 0) return broken("inputs");
  std::vector<InputChange> changes;
  while (!bytes.empty()) {
    InputChange change;
    change.step = take<std::uint32_t>(bytes);
    change.input.feed = take<double>(bytes);
    change.input.turn = take<double>(bytes);
    const bool rising = changes.empty() || change.step > changes.back().step;
    if (!rising || !std::isfinite(change.input.feed) || !std::isfinite(change.input.turn)) {
      return broken("inputs");
    }
    changes.push_back(change);
  }
  return changes;
}

base::Result<std::vector<assessment::Sample>> read_samples(std::span<const std::byte> bytes) {
  if (bytes.size() % kSampleBytes != 0) return broken("observations");
  std::vector<assessment::Sample> samples;
  std::int64_t last_step = -1;
  while (!bytes.empty()) {
    const auto [step, sample] = take_sample(bytes);
    if (step <= last_step) return broken("observations");
    last_step = step;
    samples.push_back(sample);
  }
  return samples;
}

base::Result<std::vector<SecondHashes>> read_hashes(std::span<const std::byte> bytes) {
  if (bytes.size() % kHashesBytes != 0) return broken("hashes");
  std::vector<SecondHashes> all;
  while (!bytes.empty()) {
    SecondHashes hashes;
    hashes.step = take<std::uint32_t>(bytes);
    hashes.state = take<Hash>(bytes);
    hashes.inputs = take<Hash>(bytes);
    hashes.observed = take<Hash>(bytes);
    all.push_back(hashes);
  }
  return all;
}

}  // namespace app
