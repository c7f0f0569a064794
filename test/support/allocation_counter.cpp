#include "support/allocation_counter.hpp"

#include <cerrno>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define MALLOC_IS_TAKEN
#endif
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MALLOC_IS_TAKEN
#endif

namespace {

thread_local std::size_t allocations = 0;

}  // namespace

namespace polygonal_perception::test {

AllocationCounter::AllocationCounter() : start_(allocations) {}

std::size_t AllocationCounter::count() const
{
  return allocations - start_;
}

bool AllocationCounter::available()
{
#ifdef MALLOC_IS_TAKEN
  return false;
#else
  return true;
#endif
}

}  // namespace polygonal_perception::test

#ifndef MALLOC_IS_TAKEN

// What glibc calls its own functions, for those who stand in front of them.
extern "C" {
void* __libc_malloc(std::size_t size);                           // NOLINT(bugprone-reserved-identifier)
void* __libc_calloc(std::size_t count, std::size_t size);        // NOLINT(bugprone-reserved-identifier)
void* __libc_realloc(void* memory, std::size_t size);            // NOLINT(bugprone-reserved-identifier)
void* __libc_memalign(std::size_t alignment, std::size_t size);  // NOLINT(bugprone-reserved-identifier)

void* malloc(std::size_t size)
{
  ++allocations;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size)
{
  ++allocations;
  return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size)
{
  ++allocations;
  return __libc_realloc(memory, size);
}

void* memalign(std::size_t alignment, std::size_t size)
{
  ++allocations;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size)
{
  return memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size)
{
  *memory = memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}
}

#endif
