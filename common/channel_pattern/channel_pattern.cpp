#include "common/channel_pattern/channel_pattern.hpp"

#include <glib.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace markservo {
namespace {

constexpr const char* kAllowed =
    "; allowed: a channel's name, or a Perl-compatible regular expression of the whole name";

// No channel is called so; of different characters, first letters and lengths, as channels' names are.
constexpr std::array<const char*, 7> kNobodysNames = {
    "\x01 no channel is called so \x02", "ZQX_NO_CHANNEL", "zqx9", "r1/ZQX", "QXJ7", "Xqz-no.channel", "qxjzqxjzqxj"};

[[noreturn]] void complain(const std::string& text, GError* error) {
  const std::string message = error->message;
  g_error_free(error);
  // GLib says the expression again, between quotation marks that are no ASCII: the reason is behind that.
  const std::size_t reason = message.rfind(": ");
  const std::string why = reason == std::string::npos ? message : message.substr(reason + 2);
  throw std::invalid_argument("channel pattern '" + text + "': " + why + kAllowed);
}

// G_REGEX_RAW: names come from elsewhere, and need not be UTF-8.
std::shared_ptr<GRegex> compiled(const std::string& text, const std::string& expression) {
  GError* error = nullptr;
  GRegex* regex = g_regex_new(expression.c_str(), G_REGEX_RAW, static_cast<GRegexMatchFlags>(0), &error);
  if (regex == nullptr) complain(text, error);
  return {regex, g_regex_unref};
}

}  // namespace

ChannelPattern::ChannelPattern(const std::string& text, const std::set<std::string>& names) : text_(text) {
  if (names.count(text) > 0) return;
  if (text.find('\0') != std::string::npos)
    throw std::invalid_argument("channel pattern with a zero byte" + std::string(kAllowed));
  // Alone first: "A)|(B" must not fit into what is put around it.
  compiled(text, text);
  regex_ = compiled(text, "\\A(?:" + text + "\\E)\\z");  // \E ends a \Q that does not end itself
}

bool ChannelPattern::matches(const std::string& name) const {
  if (name.find('\0') != std::string::npos) return false;
  if (regex_ == nullptr) return name == text_;
  GError* error = nullptr;
  GMatchInfo* info = nullptr;
  g_regex_match_full(regex_.get(), name.data(), static_cast<gssize>(name.size()), 0, static_cast<GRegexMatchFlags>(0),
                     &info, &error);
  const std::unique_ptr<GMatchInfo, decltype(&g_match_info_unref)> match(info, g_match_info_unref);
  if (error != nullptr) complain(text_, error);
  // Verbs such as (*ACCEPT) end a match before the \z that is put behind the pattern, \K begins it late.
  gint begin = -1;
  gint end = -1;
  return g_match_info_fetch_pos(info, 0, &begin, &end) != 0 && begin == 0 &&
         static_cast<std::size_t>(end) == name.size();
}

bool ChannelPattern::takes_any_name() const {
  if (regex_ == nullptr) return false;
  return std::any_of(kNobodysNames.begin(), kNobodysNames.end(), [this](const char* name) { return matches(name); });
}

}  // namespace markservo
