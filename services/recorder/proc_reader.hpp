#pragma once

// What the kernel tells of processes and memory, in /proc.

#include <sys/types.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace markservo::recorder {

// The child of `parent` that runs the program `name`.
std::optional<pid_t> child_named(pid_t parent, const std::string& name);

// The program's name, 15 characters of it; empty where there is no such process.
std::string program_of(pid_t process);

// A process's threads, the oldest first; none where there is no such process.
std::vector<pid_t> threads_of(pid_t process);

// In which of the kernel's functions a thread waits: "0" where it runs, or where the kernel does not tell; "gone" where
// there is no such thread.
std::string waits_in(pid_t process, pid_t thread);

// Memory that programs can still have, KiB; 0 where it is not told.
std::int64_t available_memory_kib();

// The largest receive buffer that the kernel grants, bytes. Nothing in a network of its own, which hides it.
std::optional<std::int64_t> largest_receive_buffer();

}  // namespace markservo::recorder
