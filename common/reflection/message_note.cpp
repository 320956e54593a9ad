#include "common/reflection/message_note.hpp"

#include "common/reflection/message_value.hpp"

namespace markservo::reflection {

MessageNote note_of(const TypeCatalog& catalog, const void* data, std::size_t size) {
  MessageNote note;
  note.bytes = size;
  std::uint64_t fingerprint = 0;
  if (!read_fingerprint(data, size, &fingerprint)) {
    note.decodes = false;
    return note;
  }
  note.fingerprint = fingerprint;
  const MessageType* type = catalog.find(fingerprint);
  if (type == nullptr) return note;
  note.type = shown_name(*type);
  const DecodedMessage message = decode(catalog, data, size);
  note.decodes = message.error.empty();
  if (!note.decodes) return note;
  note.session = integer_in(message.fields, "session", 0);
  note.seq = integer_in(message.fields, "seq", -1);
  return note;
}

}  // namespace markservo::reflection
