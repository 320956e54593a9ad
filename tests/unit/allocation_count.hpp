#pragma once

// How much memory code takes: link allocation_count.cpp, which puts counters into operator new and delete. What C
// libraries and Highway take by malloc is not counted.

#include <cstddef>
#include <functional>

namespace markservo::test {

// The most bytes that `work` held at any time beyond what was held before it. One thread.
std::size_t peak_bytes(const std::function<void()>& work);

}  // namespace markservo::test
