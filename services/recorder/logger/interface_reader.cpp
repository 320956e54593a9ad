#include "services/recorder/logger/interface_reader.hpp"

#include <arpa/inet.h>
#include <linux/rtnetlink.h>
#include <net/if.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace markservo::recorder {
namespace {

// "Which way to `to`?", as rtnetlink(7) has it.
struct RouteQuestion {
  nlmsghdr header;
  rtmsg route;
  rtattr attribute;
  in_addr to;
};

RouteQuestion question_of(in_addr to) {
  RouteQuestion question{};
  question.header.nlmsg_len = sizeof question;
  question.header.nlmsg_type = RTM_GETROUTE;
  question.header.nlmsg_flags = NLM_F_REQUEST;
  question.route.rtm_family = AF_INET;
  question.route.rtm_dst_len = 32;  // bits
  question.attribute.rta_type = RTA_DST;
  question.attribute.rta_len = sizeof question.attribute + sizeof to;
  question.to = to;
  return question;
}

// The interface in the kernel's answer, of which `size` bytes came: headers as above, then attributes of any number,
// each at a multiple of four bytes.
std::optional<int> interface_in(const char* answer, std::size_t size) {
  nlmsghdr header{};
  if (size < sizeof header + sizeof(rtmsg)) return std::nullopt;
  std::memcpy(&header, answer, sizeof header);
  if (header.nlmsg_type != RTM_NEWROUTE) return std::nullopt;
  rtattr attribute{};
  for (std::size_t at = sizeof header + sizeof(rtmsg); at + sizeof attribute <= size;) {
    std::memcpy(&attribute, answer + at, sizeof attribute);
    if (attribute.rta_len < sizeof attribute || attribute.rta_len > size - at) return std::nullopt;
    if (attribute.rta_type == RTA_OIF && attribute.rta_len == sizeof attribute + sizeof(int)) {
      int number = 0;
      std::memcpy(&number, answer + at + sizeof attribute, sizeof number);
      return number;
    }
    at += RTA_ALIGN(attribute.rta_len);
  }
  return std::nullopt;
}

}  // namespace

std::optional<int> interface_towards(const std::string& group) {
  in_addr to{};
  if (inet_pton(AF_INET, group.c_str(), &to) != 1) return std::nullopt;
  const int descriptor = socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC, NETLINK_ROUTE);
  if (descriptor < 0) return std::nullopt;
  const RouteQuestion question = question_of(to);
  std::array<char, 4096> answer{};
  std::optional<int> found;
  if (send(descriptor, &question, sizeof question, 0) == sizeof question) {
    const ssize_t size = recv(descriptor, answer.data(), answer.size(), 0);
    if (size > 0) found = interface_in(answer.data(), static_cast<std::size_t>(size));
  }
  close(descriptor);
  return found;
}

bool interface_exists(int number) {
  char name[IF_NAMESIZE] = {};
  // Any other fault than these says nothing of it: that there are no descriptors left, for instance.
  return if_indextoname(static_cast<unsigned>(number), name) != nullptr || (errno != ENXIO && errno != ENODEV);
}

}  // namespace markservo::recorder
