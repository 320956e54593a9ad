#include "services/mark-detector/learning/picture_assembly.hpp"

#include <stdexcept>

namespace markservo::mark_detector {

void PictureAssembly::add(std::size_t offset, const std::vector<std::uint8_t>& piece) {
  if (piece.size() > bytes_.size() || offset > bytes_.size() - piece.size()) {
    throw std::out_of_range("PictureAssembly: a piece reaches out of the picture");
  }
  for (std::size_t i = 0; i < piece.size(); ++i) {
    bytes_[offset + i] = piece[i];
    if (has_[offset + i]) continue;
    has_[offset + i] = true;
    --missing_;
  }
}

}  // namespace markservo::mark_detector
