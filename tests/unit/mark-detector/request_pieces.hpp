#pragma once

// A picture in as many LEARN_REQUESTs as it takes.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <markservo/LearnRequest.hpp>
#include <utility>
#include <vector>

namespace markservo::mark_detector::test {

inline constexpr std::size_t kPieceMost = 60'000;  // bytes: with the rest of the message one packet

// `request` with the left picture of its frame in pieces; the frame's own pictures are left out. One, at least.
inline std::vector<LearnRequest> pieces_of(LearnRequest request) {
  const std::vector<std::uint8_t> left = std::move(request.frame.left);
  request.frame.left.clear();
  request.frame.right.clear();
  request.frame.left_size = request.frame.right_size = 0;
  request.left_size = static_cast<std::int32_t>(left.size());
  std::vector<LearnRequest> pieces;
  for (std::size_t offset = 0; offset == 0 || offset < left.size(); offset += kPieceMost) {
    const std::size_t end = std::min(left.size(), offset + kPieceMost);
    request.offset = static_cast<std::int32_t>(offset);
    request.piece.assign(left.begin() + static_cast<std::ptrdiff_t>(offset),
                         left.begin() + static_cast<std::ptrdiff_t>(end));
    request.piece_size = static_cast<std::int32_t>(request.piece.size());
    pieces.push_back(request);
  }
  return pieces;
}

}  // namespace markservo::mark_detector::test
