#include "services/mark-detector/views/unseen_reason.hpp"

namespace markservo::mark_detector {
namespace {

// Why one image shows no blob of the mark.
std::string why_not(const BlobList& blobs, std::int64_t min_area, const char* where) {
  if (blobs.largest_area == 0) return std::string("no pixel of its colour in ") + where;
  return std::string("largest blob in ") + where + " has " + std::to_string(blobs.largest_area) + " px, fewer than " +
         std::to_string(min_area);
}

}  // namespace

std::string why_unseen(const Finding& finding, std::int64_t min_area, bool single) {
  const bool left = !finding.left_blobs.blobs.empty();
  const bool right = !finding.right_blobs.blobs.empty();
  if (single) return left ? "" : why_not(finding.left_blobs, min_area, "the image");
  if (left && !right)
    return "seen in the left image only: " + why_not(finding.right_blobs, min_area, "the right image");
  if (right && !left) return "seen in the right image only: " + why_not(finding.left_blobs, min_area, "the left image");
  if (finding.left_blobs.largest_area == 0 && finding.right_blobs.largest_area == 0) {
    return "no pixel of its colour in either image";
  }
  return why_not(finding.left_blobs, min_area, "the left image") + "; " +
         why_not(finding.right_blobs, min_area, "the right image");
}

}  // namespace markservo::mark_detector
