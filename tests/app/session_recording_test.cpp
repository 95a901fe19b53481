// The bytes of a trace: what is written reads back, and bytes that nobody wrote are refused.
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "app/session/recording.h"

namespace app {
namespace {

// Sizes from the format's description in recording.h.
constexpr std::size_t kInputBytes = 20, kSampleBytes = 76, kHashesBytes = 100;

std::vector<std::byte> three_inputs() {
  std::vector<std::byte> bytes;
  write_input(bytes, {1, {0.1, -0.3}});
  write_input(bytes, {7, {1.0 / 3.0, 0.0}});
  write_input(bytes, {4'000'000'000u, {-150.0, 1e-300}});
  return bytes;
}

assessment::Sample odd_sample() {
  assessment::Sample sample;
  sample.time = 0.02;
  sample.tip = {1.25, -2.5, 350.125};
  sample.tip_direction = {0.0, 0.6, 0.8};
  sample.handle_axial = 1.0 / 3.0;
  sample.handle_rotation = -1.0 / 7.0;
  sample.inserted_length = 20.5;
  sample.handle_force = -0.75;
  sample.handle_torque = 3.5;
  sample.contact_force = 0.1;
  sample.contact_force_peak = 0.2;
  sample.contact_load = 0.3;
  sample.handle_force_peak = 0.4;
  sample.contact_count = -2;
  return sample;
}

TEST(Recording, InputsComeBackBitForBit) {
  const std::vector<std::byte> bytes = three_inputs();
  ASSERT_EQ(bytes.size(), 3 * kInputBytes);
  const auto read = read_inputs(bytes);
  ASSERT_TRUE(read);
  ASSERT_EQ(read->size(), 3u);
  EXPECT_EQ((*read)[0].step, 1u);
  EXPECT_EQ((*read)[0].input.feed, 0.1);
  EXPECT_EQ((*read)[0].input.turn, -0.3);
  EXPECT_EQ((*read)[1].input.feed, 1.0 / 3.0);
  EXPECT_EQ((*read)[2].step, 4'000'000'000u);
  EXPECT_EQ((*read)[2].input.turn, 1e-300);
}

TEST(Recording, AnInputIsLittleEndianAndPacked) {
  std::vector<std::byte> bytes;
  write_input(bytes, {0x01020304u, {1.0, -2.0}});
  // 1.0 is 3ff0000000000000, -2.0 is c000000000000000 (IEEE 754)
  EXPECT_EQ(hex(bytes),
            "04030201"
            "000000000000f03f"
            "00000000000000c0");
}

TEST(Recording, TheHandleIsKeptInDoubleAndTheRestInSinglePrecision) {
  const assessment::Sample sample = odd_sample();
  std::vector<std::byte> bytes;
  write_sample(bytes, 20, sample);
  ASSERT_EQ(bytes.size(), kSampleBytes);
  const auto read = read_samples(bytes);
  ASSERT_TRUE(read);
  const assessment::Sample& back = read->front();
  EXPECT_DOUBLE_EQ(back.time, 0.020);
  EXPECT_EQ(back.handle_axial, 1.0 / 3.0);
  EXPECT_EQ(back.handle_rotation, -1.0 / 7.0);
  EXPECT_EQ(back.contact_count, -2);
  EXPECT_EQ(back.tip, (std::array<double, 3>{1.25, -2.5, 350.125}));  // exact in single precision
  EXPECT_EQ(back.tip_direction[2], double{0.8f});
  EXPECT_EQ(back.inserted_length, 20.5);
  EXPECT_EQ(back.handle_force, -0.75);
  EXPECT_EQ(back.handle_torque, 3.5);
  EXPECT_EQ(back.contact_force, double{0.1f});
  EXPECT_EQ(back.contact_force_peak, double{0.2f});
  EXPECT_EQ(back.contact_load, double{0.3f});
  EXPECT_EQ(back.handle_force_peak, double{0.4f});
}

TEST(Recording, AsRecordedIsWhatReadsBack) {
  std::vector<std::byte> bytes;
  write_sample(bytes, 20, odd_sample());
  std::vector<std::byte> again;
  write_sample(again, 20, as_recorded(odd_sample()));
  EXPECT_EQ(again, bytes);
  const assessment::Sample here = as_recorded(odd_sample());
  const auto there = read_samples(bytes);
  ASSERT_TRUE(there);
  EXPECT_EQ(here.contact_force, there->front().contact_force);
  EXPECT_EQ(here.contact_force_peak, there->front().contact_force_peak);
  EXPECT_EQ(here.contact_load, there->front().contact_load);
  EXPECT_EQ(here.handle_force_peak, there->front().handle_force_peak);
  EXPECT_EQ(here.tip_direction, there->front().tip_direction);
  EXPECT_EQ(here.handle_axial, there->front().handle_axial);
}

TEST(Recording, HashesComeBack) {
  SecondHashes hashes;
  hashes.step = 1000;
  hashes.state[0] = std::byte{1};
  hashes.inputs[31] = std::byte{2};
  hashes.observed[5] = std::byte{3};
  std::vector<std::byte> bytes;
  write_hashes(bytes, hashes);
  ASSERT_EQ(bytes.size(), kHashesBytes);
  const auto read = read_hashes(bytes);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->front().step, 1000u);
  EXPECT_EQ(read->front().state, hashes.state);
  EXPECT_EQ(read->front().inputs, hashes.inputs);
  EXPECT_EQ(read->front().observed, hashes.observed);
}

// RFC 7693 has BLAKE2b-512 only; this is `b2sum -l 256` of "abc". SHA-256 from FIPS 180-2.
TEST(Recording, TheHashesAreTheOnesTheyAreCalled) {
  const std::string abc = "abc";
  EXPECT_EQ(hex(hash_of(std::as_bytes(std::span(abc)))),
            "bddd813c634239723171ef3fee98579b94964e3bb1cb3e427262c8c068d52319");
  EXPECT_EQ(sha256_hex(std::as_bytes(std::span(abc))),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(Recording, NothingReadsAsNothing) {
  EXPECT_TRUE(read_inputs({}) && read_inputs({})->empty());
  EXPECT_TRUE(read_samples({}) && read_samples({})->empty());
  EXPECT_TRUE(read_hashes({}) && read_hashes({})->empty());
}

TEST(Recording, EveryTruncationIsRefused) {
  std::vector<std::byte> samples, hashes;
  write_sample(samples, 10, odd_sample());
  write_sample(samples, 20, odd_sample());
  write_hashes(hashes, {});
  const std::vector<std::byte> inputs = three_inputs();
  for (std::size_t n = 1; n < samples.size(); ++n) {
    const std::span<const std::byte> cut(samples.data(), n);
    EXPECT_EQ(static_cast<bool>(read_samples(cut)), n % kSampleBytes == 0) << n;
    if (n < inputs.size()) {
      EXPECT_EQ(static_cast<bool>(read_inputs({inputs.data(), n})), n % kInputBytes == 0) << n;
    }
    if (n < hashes.size()) {
      const auto read = read_hashes({hashes.data(), n});
      ASSERT_FALSE(read) << n;
      EXPECT_EQ(read.error().code, base::ErrorCode::corrupt_data);
    }
  }
}

TEST(Recording, StepsThatDoNotRiseAreRefused) {
  for (const std::uint32_t second : {5u, 4u}) {
    std::vector<std::byte> inputs, samples;
    write_input(inputs, {5, {}});
    write_input(inputs, {second, {}});
    write_sample(samples, 5, {});
    write_sample(samples, second, {});
    const auto read = read_inputs(inputs);
    ASSERT_FALSE(read) << second;
    EXPECT_EQ(read.error().code, base::ErrorCode::corrupt_data);
    EXPECT_NE(read.error().message.find("inputs"), std::string::npos);
    EXPECT_FALSE(read_samples(samples)) << second;
  }
}

TEST(Recording, AHandThatIsNoNumberIsRefused) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    std::vector<std::byte> feed, turn;
    write_input(feed, {1, {bad, 0.0}});
    write_input(turn, {1, {0.0, bad}});
    EXPECT_FALSE(read_inputs(feed));
    EXPECT_FALSE(read_inputs(turn));
  }
}

// Whatever the bytes: an error or whole records in order, never more than the bytes can hold.
TEST(Recording, RandomBytesNeverGetThrough) {
  std::mt19937 random(2024);
  std::vector<std::byte> good_samples;
  for (std::uint32_t k = 0; k < 4; ++k) write_sample(good_samples, 10 * k, odd_sample());
  const std::vector<std::byte> good_inputs = three_inputs();
  for (int round = 0; round < 20'000; ++round) {
    std::vector<std::byte> bytes;
    if (round % 3 == 0) {
      bytes.resize(random() % 400);
      for (std::byte& b : bytes) b = static_cast<std::byte>(random() & 255);
    } else {  // nearly right: a few bytes changed, some cut off
      bytes = round % 3 == 1 ? good_samples : good_inputs;
      for (unsigned k = 0; k < 1 + random() % 4; ++k) {
        bytes[random() % bytes.size()] = static_cast<std::byte>(random() & 255);
      }
      if (random() % 4 == 0) bytes.resize(random() % bytes.size());
    }
    if (const auto inputs = read_inputs(bytes)) {
      ASSERT_EQ(inputs->size() * kInputBytes, bytes.size());
      for (std::size_t k = 0; k < inputs->size(); ++k) {
        ASSERT_TRUE(std::isfinite((*inputs)[k].input.feed));
        ASSERT_TRUE(std::isfinite((*inputs)[k].input.turn));
        ASSERT_TRUE(k == 0 || (*inputs)[k].step > (*inputs)[k - 1].step);
      }
    }
    if (const auto samples = read_samples(bytes)) {
      ASSERT_EQ(samples->size() * kSampleBytes, bytes.size());
      for (std::size_t k = 1; k < samples->size(); ++k) {
        ASSERT_GT((*samples)[k].time, (*samples)[k - 1].time);
      }
    }
    if (const auto hashes = read_hashes(bytes)) {
      ASSERT_EQ(hashes->size() * kHashesBytes, bytes.size());
    }
  }
}

}  // namespace
}  // namespace app
