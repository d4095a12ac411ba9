// SPDX-License-Identifier: MIT
// Times of points in fields of any type and name, sweep after sweep.
#include <cstring>

#include "readers.h"
#include "revisit_slam/input/point_reader.h"

namespace revisit_slam::fuzz {
namespace {

constexpr std::size_t kPoints = 32;  // of a sweep

/// Two bytes choose the parameters and the field, eight are the stamp of the header; then times.
class Sweeps {
 public:
  explicit Sweeps(const std::string& bytes) : bytes_(bytes) {
    const char* names[] = {"t", "time", "timestamp", "offset_time", "time_us", "x"};
    const char* units[] = {"auto", "s", "ms", "us", "ns"};
    const char* origins[] = {"auto", "absolute", "relative"};
    const char* instants[] = {"auto", "first", "middle", "last"};
    const unsigned a = byte(), b = byte();
    field_ = {names[a % 6], static_cast<NumberType>(1 + a / 6 % 8), 12, 1};
    config_.time_unit = units[b % 5];
    config_.time_origin = origins[b / 5 % 3];
    config_.header_stamp = instants[b / 15 % 4];
    if (a / 48 % 4 == 3) config_.time_field = "azimuth";
    std::uint64_t stamp = 0;
    for (int i = 0; i < 8; ++i) stamp = stamp << 8 | byte();
    header_.nanoseconds = static_cast<std::int64_t>(stamp);
  }

  void read() {
    PointReader reader(config_);
    for (int sweep = 0; sweep < 4; ++sweep) {
      const std::vector<std::uint8_t> data = nextSweep();
      PointView view{data.data(), data.size(), kPoints, 1, 12 + sizeOf(field_.type),
                     data.size(), false,       {}};
      view.fields = {{"x", NumberType::float32, 0, 1},
                     {"y", NumberType::float32, 4, 1},
                     {"z", NumberType::float32, 8, 1},
                     field_};
      reader.read(view, {header_, "header", {}});
      header_.nanoseconds =
          static_cast<std::int64_t>(static_cast<std::uint64_t>(header_.nanoseconds) + 100'000'000);
    }
  }

 private:
  unsigned byte() {
    return next_ < bytes_.size() ? static_cast<unsigned char>(bytes_[next_++]) : 0;
  }

  std::vector<std::uint8_t> nextSweep() {
    const std::size_t step = 12 + sizeOf(field_.type);
    std::vector<std::uint8_t> data(kPoints * step);
    for (std::size_t i = 0; i < kPoints; ++i) {
      const float xyz[] = {1.f + static_cast<float>(i), 2.f, 3.f};
      std::memcpy(&data[i * step], xyz, sizeof(xyz));
      for (std::size_t k = 12; k < step; ++k)
        data[i * step + k] = static_cast<std::uint8_t>(byte());
    }
    return data;
  }

  const std::string& bytes_;
  std::size_t next_ = 0;
  ScanInputConfig config_;
  PointField field_;
  Stamp header_;
};

template <typename Number>
void append(std::string& bytes, Number number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

}  // namespace

void readPointTimes(const std::string& bytes) {
  Sweeps(bytes).read();
}

Seeds seedsOfPointTimes() {
  const std::string stamp = {0x17, '\x97', '\x9c', '\xfe', 0x36, 0x2a, 0, 0};  // 1.7e18
  std::string nanoseconds = std::string(1, 5 * 6) + std::string(1, 0) + stamp;
  std::string seconds = std::string(1, 7 * 6 + 2) + std::string(1, 0) + stamp;
  for (std::size_t i = 0; i < 4 * kPoints; ++i) {
    append(nanoseconds, static_cast<std::uint32_t>(i % kPoints * 3'000'000));
    append(seconds, 1.7e9 + static_cast<double>(i) * 3e-3);
  }
  return {nanoseconds, seconds};
}

}  // namespace revisit_slam::fuzz
