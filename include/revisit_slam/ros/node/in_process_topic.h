// SPDX-License-Identifier: MIT
#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>

#include <boost/shared_ptr.hpp>
#include <memory>
#include <stdexcept>

namespace revisit_slam {

/// The core holds what it is given in std::shared_ptr; ROS 1 hands out boost::shared_ptr. The
/// pointer returned shares the ownership, nothing is copied.
template <typename T>
std::shared_ptr<const T> toStdPointer(const boost::shared_ptr<const T>& pointer) {
  return {pointer.get(), [pointer](const T*) {}};
}

/// The other way round.
template <typename T>
boost::shared_ptr<const T> toBoostPointer(const std::shared_ptr<const T>& pointer) {
  return {pointer.get(), [pointer](const T*) {}};
}

}  // namespace revisit_slam

/// C++ types as topics within one process: the boost::shared_ptr<const T> that a nodelet publishes
/// is the one that the others receive. Such a topic does not leave the process: a subscriber in
/// another one is told so by an exception that roscpp logs, and gets no message. Never latch them:
/// latching keeps the serialised form, which is empty.
#define REVISIT_SLAM_IN_PROCESS_TOPIC(Type, Name, Md5)                                       \
  namespace ros {                                                                            \
  namespace message_traits {                                                                 \
  template <>                                                                                \
  struct IsMessage<Type> : TrueType {};                                                      \
  template <>                                                                                \
  struct IsMessage<const Type> : TrueType {};                                                \
  template <>                                                                                \
  struct MD5Sum<Type> {                                                                      \
    static const char* value() { return Md5; }                                               \
    static const char* value(const Type&) { return value(); }                                \
  };                                                                                         \
  template <>                                                                                \
  struct DataType<Type> {                                                                    \
    static const char* value() { return Name; }                                              \
    static const char* value(const Type&) { return value(); }                                \
  };                                                                                         \
  template <>                                                                                \
  struct Definition<Type> {                                                                  \
    static const char* value() { return "# " Name " does not leave the nodelet manager\n"; } \
    static const char* value(const Type&) { return value(); }                                \
  };                                                                                         \
  }                                                                                          \
  namespace serialization {                                                                  \
  template <>                                                                                \
  struct Serializer<Type> {                                                                  \
    template <typename Stream>                                                               \
    static void write(Stream&, const Type&) {}                                               \
    template <typename Stream>                                                               \
    static void read(Stream&, Type&) {                                                       \
      throw std::runtime_error(Name                                                          \
                               " does not leave the nodelet manager: run this subscriber "   \
                               "as a nodelet in the same manager");                          \
    }                                                                                        \
    static uint32_t serializedLength(const Type&) { return 0; }                              \
  };                                                                                         \
  }                                                                                          \
  }
