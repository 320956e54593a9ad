# Makes the code that lcm-gen 1.3.1 writes for one type safe against hostile and careless lengths.
# Usage: cmake -DHEADER=<generated .hpp> -P HardenGeneratedType.cmake
#
# As generated, decoding resizes a vector to whatever length the message claims before it looks at how many bytes there
# are (2 billion: gigabytes), takes a negative one for a huge one, and lets a string of length 0 throw; encoding trusts
# the length field even where it exceeds the vector. Each element is at least one byte on the wire, so a length above
# the bytes left is a lie; and 8 * length cannot overflow an int once it is below the message's size.
# A string must end with its only zero byte: one with a zero inside would be cut off where it is sent on.

cmake_minimum_required(VERSION 3.25)

file(READ "${HEADER}" code)

set(count "this->([A-Za-z_0-9]+)")
set(vector "this->([A-Za-z_0-9]+)")

# Decoding: bound every vector's length, then every string's.
string(REGEX REPLACE
  "(\n *)(${vector}\\.resize\\(${count}\\);)"
  "\\1if(this->\\4 < 0 || this->\\4 > maxlen - pos) return -1;\\1\\2"
  code "${code}")
string(REGEX REPLACE
  "if\\((__[A-Za-z_0-9]+_len__) > maxlen - pos\\) return -1;"
  "if(\\1 < 1 || \\1 > maxlen - pos || memchr((const char*)buf + offset + pos, 0, (size_t)\\1) != (const char*)buf + offset + pos + \\1 - 1) return -1;"
  code "${code}")

# Decoding into a message that held another: an array of length 0 is skipped, and would keep the other's elements.
string(REGEX REPLACE
  "(\n *)if\\(${count}\\) {(\n *if\\(${count} < 0[^\n]*\n *${vector}\\.resize\\()"
  "\\1if(this->\\2 == 0) this->\\5.clear();\\1if(this->\\2) {\\3"
  code "${code}")

# Encoding: a length field that disagrees with its vector is refused, and never read past.
string(REGEX REPLACE
  "(\n *)if\\(${count} > 0\\) {(\n *tlen = __[a-z0-9_]+_encode_array\\(buf, offset \\+ pos, maxlen - pos, &${vector}\\[0\\])"
  "\\1if(this->\\4.size() != static_cast<size_t>(this->\\2)) return -1;\\1if(this->\\2 > 0) {\\3"
  code "${code}")
string(REGEX REPLACE
  "(\n *)for \\(int a0 = 0; a0 < ${count}; a0\\+\\+\\) {(\n *tlen = ${vector}\\[a0\\]\\._encodeNoHash)"
  "\\1if(this->\\4.size() != static_cast<size_t>(this->\\2)) return -1;\\1for (int a0 = 0; a0 < this->\\2; a0++) {\\3"
  code "${code}")
string(REGEX REPLACE
  "(\n *)for \\(int a0 = 0; a0 < ${count}; a0\\+\\+\\) {(\n *enc_size \\+= ${vector}\\[a0\\])"
  "\\1for (int a0 = 0; a0 < this->\\2 && a0 < static_cast<int>(this->\\4.size()); a0++) {\\3"
  code "${code}")

# What is left unguarded would be a pattern this script does not know.
string(REGEX MATCHALL "\\.resize\\(" resizes "${code}")
string(REGEX MATCHALL "< 0 \\|\\| this->[A-Za-z_0-9]+ > maxlen - pos\\)" guards "${code}")
list(LENGTH resizes num_resizes)
list(LENGTH guards num_guards)
if(NOT num_resizes EQUAL num_guards)
  message(FATAL_ERROR "${HEADER}: ${num_resizes} vectors but ${num_guards} length checks; lcm-gen writes a form unknown to HardenGeneratedType.cmake")
endif()
string(REGEX MATCHALL "if\\(this->[A-Za-z_0-9]+\\) {" skips "${code}")
string(REGEX MATCHALL "\\.clear\\(\\)" clears "${code}")
list(LENGTH skips num_skips)
list(LENGTH clears num_clears)
if(NOT num_skips EQUAL num_clears)
  message(FATAL_ERROR "${HEADER}: ${num_skips} arrays that may be skipped but ${num_clears} cleared; lcm-gen writes a form unknown to HardenGeneratedType.cmake")
endif()
file(WRITE "${HEADER}" "${code}")
