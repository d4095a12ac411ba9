// SPDX-License-Identifier: MIT
// Every target on its seeds, on what was once a finding, and on seeds that are damaged at random:
// the same inputs at every run, in every build. scripts/fuzz looks farther.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <random>

#include "scratch.h"
#include "target.h"

namespace {

std::atomic<std::size_t> largest_allocation{0};

}  // namespace

// Not inlined, so that compilers do not take one for the other of another pair.
[[gnu::noinline]] void* operator new(std::size_t size) {
  std::size_t largest = largest_allocation;
  while (size > largest && !largest_allocation.compare_exchange_weak(largest, size)) {
  }
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace revisit_slam::fuzz {
namespace {

/// Far more than any of the inputs is worth.
constexpr std::size_t kMostMemory = std::size_t{64} << 20;
constexpr int kInputs = 5000;  // of each target

using Seeds = std::vector<std::string>;

class Damage {
 public:
  explicit Damage(const Seeds& seeds) : seeds_(seeds) {}

  std::string next() {
    std::string bytes = any(seeds_);
    for (std::size_t times = 1 + below(6); times > 0; --times) damage(bytes);
    return bytes;
  }

 private:
  std::size_t below(std::size_t end) { return end == 0 ? 0 : random_() % end; }
  const std::string& any(const Seeds& of) { return of[below(of.size())]; }

  void damage(std::string& bytes) {
    const std::size_t place = below(bytes.size()), length = 1 + below(16);
    static const Seeds kNumbers{std::string(4, '\xff'),
                                std::string(4, '\0'),
                                {'\xff', '\xff', '\xff', '\x7f'},
                                {0, 0, 0, '\x80'},
                                {0, '\x28', '\x6b', '\xee'},  // 4e9
                                std::string(8, '\xff'),
                                {0, 0, 0, 0, 0, 0, '\xf0', '\x7f'},  // infinite
                                {'\xff', '\xff', '\xff', '\xff', '\xff', '\xff', '\xef', '\x7f'},
                                "-1",
                                "nan",
                                "1e308",
                                "99999999999999999999"};
    switch (below(7)) {
      case 0:
        if (!bytes.empty()) bytes[place] = static_cast<char>(random_());
        return;
      case 1:
        if (!bytes.empty()) bytes[place] = static_cast<char>(bytes[place] ^ 1 << below(8));
        return;
      case 2:
        bytes.erase(place, length);
        return;
      case 3:
        bytes.insert(place, bytes.substr(below(bytes.size()), length));
        return;
      case 4:
        bytes.resize(place);
        return;
      case 5:
        bytes.replace(place, below(9), any(kNumbers));
        return;
      default:
        bytes.replace(place, length, any(seeds_).substr(0, length));
    }
  }

  const Seeds& seeds_;
  std::mt19937 random_{1};
};

class Fuzz : public testing::TestWithParam<Target> {
 protected:
  static void answerModestly(const std::string& bytes) {
    largest_allocation = 0;
    answer(GetParam(), bytes);
    ASSERT_LT(largest_allocation, kMostMemory) << bytes.size() << " bytes";
  }
};

TEST_P(Fuzz, SeedsAreRead) {
  for (const std::string& seed : GetParam().seeds()) {
    ASSERT_FALSE(seed.empty());
    answerModestly(seed);
  }
}

TEST_P(Fuzz, WhatWasOnceAFindingIsAnswered) {
  const std::string folder =
      REVISIT_SLAM_SOURCE_FOLDER "/fuzz/findings/" + std::string(GetParam().name);
  if (!std::filesystem::exists(folder)) return;  // none so far
  for (const auto& file : std::filesystem::directory_iterator(folder))
    answerModestly(bytesOfFile(file.path().string()));
}

TEST_P(Fuzz, DamagedSeedsAreAnswered) {
  const std::vector<std::string> seeds = GetParam().seeds();
  Damage damage(seeds);
  for (int i = 0; i < kInputs && !HasFatalFailure(); ++i) answerModestly(damage.next());
}

INSTANTIATE_TEST_SUITE_P(All, Fuzz, testing::ValuesIn(targets()),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace revisit_slam::fuzz
