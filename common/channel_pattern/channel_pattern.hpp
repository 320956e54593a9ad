#pragma once

#include <memory>
#include <set>
#include <string>

struct _GRegex;  // NOLINT(bugprone-reserved-identifier): what GLib calls its GRegex

namespace markservo {

// A person's pattern for channels, the one kind that all tools take: a Perl-compatible regular expression, as liblcm's
// own tools have it (it subscribes by GLib's), of the whole name: 'CAM\d' takes CAM1, and neither CAM10 nor r1/CAM1.
//
// A text that is a channel's name is that channel alone, whatever characters are in it: a name is no pattern.
class ChannelPattern {
 public:
  // `names`: the channels there are, as far as they are known. Throws std::invalid_argument for a text that is no
  // regular expression and none of them.
  explicit ChannelPattern(const std::string& text, const std::set<std::string>& names = {});

  // False for a name with a zero byte in it, which no bus carries. Throws std::invalid_argument for a pattern that
  // takes too long: ([ab]+)+[^ab], on a name of fifty a.
  bool matches(const std::string& name) const;

  // It names nothing in particular: '.*', '\w+', or everything but some. Found out by names that no channel has.
  // Throws as matches() does.
  bool takes_any_name() const;

 private:
  std::string text_;
  std::shared_ptr<_GRegex> regex_;  // null: a name
};

}  // namespace markservo
