// SPDX-License-Identifier: MIT
#include "revisit_slam/ros/messages/density_message.h"

#include <algorithm>

namespace revisit_slam {
namespace {

constexpr int kZoom = 2;
constexpr int kHalfSquare = 3;  // pixels of the message

class Canvas {
 public:
  Canvas(int width, int height) : width_(width), height_(height) {
    message_.width = static_cast<std::uint32_t>(width);
    message_.height = static_cast<std::uint32_t>(height);
    message_.encoding = "bgr8";
    message_.step = 3 * message_.width;
    message_.data.resize(static_cast<std::size_t>(message_.step) * message_.height);
  }

  /// y counts upwards; what is outside is left out.
  void set(int x, int y, std::uint8_t b, std::uint8_t g, std::uint8_t r) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    const std::size_t row = static_cast<std::size_t>(height_ - 1 - y);
    std::uint8_t* pixel = &message_.data[row * message_.step + 3 * static_cast<std::size_t>(x)];
    pixel[0] = b;
    pixel[1] = g;
    pixel[2] = r;
  }

  sensor_msgs::Image take() { return std::move(message_); }

 private:
  int width_, height_;
  sensor_msgs::Image message_;
};

/// Sparse pixels are to be seen too.
std::uint8_t greyOf(std::uint8_t density) {
  return density == 0 ? 0 : static_cast<std::uint8_t>(110 + density * 145 / 255);
}

}  // namespace

sensor_msgs::Image toDensityMessage(const PlaceView& view) {
  const DensityImage& image = view.image;
  Canvas canvas(kZoom * image.width, kZoom * image.height);
  for (int y = 0; y < kZoom * image.height; ++y)
    for (int x = 0; x < kZoom * image.width; ++x) {
      const std::uint8_t grey = greyOf(image.at(x / kZoom, y / kZoom));
      canvas.set(x, y, grey, grey, grey);
    }
  for (const Keypoint& keypoint : view.features.keypoints) {
    const int x = kZoom * (keypoint.i - image.origin.x()) + kZoom / 2;
    const int y = kZoom * (keypoint.j - image.origin.y()) + kZoom / 2;
    for (int i = -kHalfSquare; i <= kHalfSquare; ++i)
      for (const int edge : {-kHalfSquare, kHalfSquare}) {
        canvas.set(x + i, y + edge, 80, 255, 60);
        canvas.set(x + edge, y + i, 80, 255, 60);
      }
  }
  return canvas.take();
}

}  // namespace revisit_slam
