#include "common/channel_pattern/channel_pattern.hpp"

#include <glib.h>

#include <stdexcept>

namespace markservo {
namespace {

constexpr const char* kAllowed =
    "; allowed: a channel's name, or a Perl-compatible regular expression of the whole name";

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
  const bool does = g_regex_match_full(regex_.get(), name.data(), static_cast<gssize>(name.size()), 0,
                                       static_cast<GRegexMatchFlags>(0), nullptr, &error) != 0;
  if (error != nullptr) complain(text_, error);
  return does;
}

bool ChannelPattern::takes_any_name() const {
  return matches("\x01 no channel is called so \x02");
}

}  // namespace markservo
