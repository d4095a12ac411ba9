// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "revisit_slam/types/ids.h"

namespace revisit_slam {

/// Where the things of several sessions are in one list: session after session, in each session by
/// number from 0 without gaps.
template <typename Id>
class SessionOffsets {
 public:
  /// The list has grown by this. @throws std::invalid_argument for what cannot come next.
  void append(Id id) {
    const bool begins = order_.empty() || order_.back() != id.session;
    if (id.value != (begins ? 0 : size_ - begin_.at(id.session)) ||
        (begins && begin_.count(id.session) > 0))
      throw std::invalid_argument("number " + std::to_string(id.value) + " of session " +
                                  std::to_string(id.session.value) + " cannot come next");
    if (begins) {
      begin_[id.session] = size_;
      order_.push_back(id.session);
    }
    ++size_;
  }

  std::size_t size() const { return size_; }
  bool contains(Id id) const {
    const auto found = begin_.find(id.session);
    return found != begin_.end() && found->second + id.value < end(id.session);
  }
  /// @throws std::out_of_range for a session that is not in the list.
  std::size_t operator[](Id id) const { return begin_.at(id.session) + id.value; }

  /// In the order of the list.
  const std::vector<SessionId>& sessions() const { return order_; }
  std::size_t begin(SessionId session) const { return begin_.at(session); }
  std::size_t end(SessionId session) const {
    std::size_t end = size_;
    for (const auto& other : begin_)
      if (other.second > begin_.at(session) && other.second < end) end = other.second;
    return end;
  }

 private:
  std::map<SessionId, std::size_t> begin_;
  std::vector<SessionId> order_;
  std::size_t size_ = 0;
};

}  // namespace revisit_slam
