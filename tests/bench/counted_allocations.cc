#include "tests/bench/counted_allocations.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> count{0};
thread_local std::size_t asked_for = 0;

void count_one(std::size_t bytes) noexcept {
  count.fetch_add(1, std::memory_order_relaxed);
  asked_for += bytes;
}

}  // namespace

void* operator new(std::size_t bytes) {
  count_one(bytes);
  if (void* const memory = std::malloc(bytes > 0 ? bytes : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  count_one(bytes);
  return std::malloc(bytes > 0 ? bytes : 1);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

namespace slackwater::bench {

std::size_t allocations() noexcept { return count.load(std::memory_order_relaxed); }
std::size_t allocated_bytes() noexcept { return asked_for; }

}  // namespace slackwater::bench
