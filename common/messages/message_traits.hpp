#pragma once

// What a message type carries, asked at compile time: messages have a utime, streams session and seq; answers echo
// their frame.

#include <cstdint>
#include <type_traits>

namespace markservo::messages {

template <class M, class = void>
struct has_utime : std::false_type {};
template <class M>
struct has_utime<M, std::void_t<decltype(M::utime)>> : std::true_type {};

template <class M, class = void>
struct has_seq : std::false_type {};
template <class M>
struct has_seq<M, std::void_t<decltype(M::session), decltype(M::seq)>> : std::true_type {};

template <class M, class = void>
struct answers_frame : std::false_type {};
template <class M>
struct answers_frame<M, std::void_t<decltype(M::frame_utime)>> : std::true_type {};

// Hands the identity of the frame on: from the frame itself or from another answer to it.
template <class Answer, class From>
void answer_frame(Answer& answer, const From& from) {
  answer.utime = from.frame_utime;
  answer.frame_session = from.frame_session;
  answer.frame_seq = from.frame_seq;
  answer.frame_utime = from.frame_utime;
}

}  // namespace markservo::messages
