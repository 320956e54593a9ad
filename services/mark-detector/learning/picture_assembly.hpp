#pragma once

// A picture that comes in pieces.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace markservo::mark_detector {

class PictureAssembly {
 public:
  // Of `size` bytes, none of which has come.
  explicit PictureAssembly(std::size_t size) : bytes_(size), has_(size, false), missing_(size) {}

  std::size_t size() const { return bytes_.size(); }

  // Puts a piece to its place, where it may have come before. Throws std::out_of_range if it reaches out of the
  // picture.
  void add(std::size_t offset, const std::vector<std::uint8_t>& piece);

  bool complete() const { return missing_ == 0; }
  // All of it, which is gone then.
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  std::vector<std::uint8_t> bytes_;
  std::vector<bool> has_;
  std::size_t missing_;
};

}  // namespace markservo::mark_detector
