#include "services/mmi/pictures/picture_maker.hpp"

#include <fmt/core.h>

#include <cstring>
#include <stdexcept>

#include "common/reflection/message_json.hpp"
#include "common/reflection/type_catalog.hpp"

namespace markservo::mmi {
namespace {

constexpr std::size_t kBytesShown = 8192;  // a mask of 256 x 256; the patches' pixels are in the pictures

// As StereoFrame.lcm numbers encodings.
constexpr std::int64_t kBgr8 = 0;
constexpr std::int64_t kJpeg = 1;

std::string part_json(const Bytes& part) {
  if (!part) return "null";
  const auto message = reflection::decode(reflection::TypeCatalog::ours(), part->data(), part->size());
  if (!message.error.empty()) return "null";
  return reflection::json_text(reflection::json_of(message.fields, reflection::JsonForm::kExact, kBytesShown), -1);
}

const reflection::Bytes* bytes_in(const reflection::Fields& fields, const std::string& name) {
  const reflection::Value* value = fields.find(name);
  return value == nullptr ? nullptr : std::get_if<reflection::Bytes>(&value->content);
}

std::string text_of(const reflection::Bytes& bytes) {
  return std::string(reinterpret_cast<const char*>(bytes.data), bytes.size);
}

}  // namespace

bool is_picture(const reflection::Fields& frame) {
  constexpr std::int64_t kMostPixels = 65500;  // along an axis, of a JPEG
  const reflection::Bytes* left = bytes_in(frame, "left");
  const reflection::Bytes* right = bytes_in(frame, "right");
  const std::int64_t width = reflection::integer_in(frame, "width", 0);
  const std::int64_t height = reflection::integer_in(frame, "height", 0);
  if (left == nullptr || right == nullptr || width < 1 || height < 1 || width > kMostPixels || height > kMostPixels) {
    return false;
  }
  const std::int64_t encoding = reflection::integer_in(frame, "encoding", -1);
  if (encoding == kJpeg) return left->size > 0 && right->size > 0;
  const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3;
  return encoding == kBgr8 && left->size == pixels && right->size == pixels;
}

std::shared_ptr<const JpegPair> PictureMaker::jpegs(const std::shared_ptr<const Frame>& frame) {
  if (encoded_frame_ == frame) return encoded_;
  encoded_frame_ = frame;
  encoded_ = nullptr;
  const auto message = reflection::decode(reflection::TypeCatalog::ours(), frame->bytes->data(), frame->bytes->size());
  if (!message.error.empty()) return nullptr;
  if (!is_picture(message.fields)) return nullptr;
  const reflection::Bytes& left = *bytes_in(message.fields, "left");
  const reflection::Bytes& right = *bytes_in(message.fields, "right");
  auto pair = std::make_shared<JpegPair>();
  pair->width = static_cast<int>(reflection::integer_in(message.fields, "width", 0));
  pair->height = static_cast<int>(reflection::integer_in(message.fields, "height", 0));
  if (reflection::integer_in(message.fields, "encoding", -1) == kJpeg) {
    pair->left = text_of(left);
    pair->right = text_of(right);
  } else {
    try {
      pair->left = encoder_.encode(left.data, pair->width, pair->height);
      pair->right = encoder_.encode(right.data, pair->width, pair->height);
    } catch (const std::runtime_error&) {
      return nullptr;  // it is shown as one that cannot be, and the next one is tried
    }
  }
  encoded_ = std::move(pair);
  return encoded_;
}

std::shared_ptr<const PictureMaker::Made> PictureMaker::made(const std::shared_ptr<const Frame>& frame) {
  if (made_frame_ == frame && made_parts_ == frame->parts) return made_;
  made_frame_ = frame;
  made_parts_ = frame->parts;
  made_ = nullptr;
  const auto pair = jpegs(frame);
  if (!pair) return nullptr;
  auto made = std::make_shared<Made>();
  made->pair = pair;
  made->header = fmt::format(
      "\"frame_session\":\"{}\",\"frame_seq\":\"{}\",\"utime\":\"{}\",\"at\":\"{}\",\"width\":{},\"height\":{},"
      "\"left_size\":{},\"right_size\":{},\"detection\":{},\"matches\":{},\"pose\":{},\"servo\":{}}}",
      frame->session, frame->seq, frame->utime, frame->at, pair->width, pair->height, pair->left.size(),
      pair->right.size(), part_json(frame->part(FramePart::kDetection)), part_json(frame->part(FramePart::kMatches)),
      part_json(frame->part(FramePart::kPose)), part_json(frame->part(FramePart::kServo)));
  made_ = std::move(made);
  return made_;
}

std::string picture_message(const PictureMaker::Made& made, std::int64_t number) {
  const std::string header = fmt::format("{{\"number\":{},", number) + made.header;
  const auto length = static_cast<std::uint32_t>(header.size());
  std::string message;
  message.reserve(sizeof length + header.size() + made.pair->left.size() + made.pair->right.size());
  for (unsigned shift = 0; shift < 32; shift += 8) message += static_cast<char>(length >> shift & 0xffU);
  message += header;
  message += made.pair->left;
  message += made.pair->right;
  return message;
}

}  // namespace markservo::mmi
