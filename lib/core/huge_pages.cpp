#include "core/huge_pages.hpp"

#include <malloc.h>
#include <sys/mman.h>

#include <algorithm>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

#include "core/memory.hpp"

namespace superstep {
namespace {

struct KeptPages {
  void* memory;
  std::size_t bytes;
};

/// Of all threads. It lives as long as the program, so that whoever ends last can still give back.
struct HugePagePool {
  std::mutex mutex;
  std::vector<KeptPages> kept;
  std::size_t bytes = 0;
};

HugePagePool& huge_page_pool() {
  static auto* const pool = new HugePagePool;
  return *pool;
}

void free_huge_pages(void* memory) noexcept {
  ::operator delete (memory, std::align_val_t{huge_page});
}

}  // namespace

void* take_huge_pages(std::size_t bytes) {
  HugePagePool& pool = huge_page_pool();
  {
    const std::lock_guard lock(pool.mutex);
    const auto found = std::find_if(pool.kept.begin(), pool.kept.end(),
                                    [&](const KeptPages& one) { return one.bytes == bytes; });
    if (found != pool.kept.end()) {
      void* const memory = found->memory;
      pool.kept.erase(found);
      pool.bytes -= bytes;
      return memory;
    }
  }
  void* const memory = ::operator new (bytes, std::align_val_t{huge_page});
#ifdef MADV_HUGEPAGE
  (void)::madvise(memory, bytes, MADV_HUGEPAGE);  // advice: without it all is the same, but slower
#endif
  return memory;
}

void give_huge_pages_back(void* memory, std::size_t bytes) noexcept {
  if (memory == nullptr) return;
  HugePagePool& pool = huge_page_pool();
  try {
    const std::lock_guard lock(pool.mutex);
    if (pool.bytes + bytes <= huge_pages_kept) {
      pool.kept.push_back({memory, bytes});
      pool.bytes += bytes;
      return;
    }
  } catch (const std::bad_alloc&) {  // no room for the note: it is freed
  }
  free_huge_pages(memory);
}

std::size_t kept_huge_pages() noexcept {
  HugePagePool& pool = huge_page_pool();
  const std::lock_guard lock(pool.mutex);
  return pool.bytes;
}

void give_back_memory() noexcept {
  HugePagePool& pool = huge_page_pool();
  {
    const std::lock_guard lock(pool.mutex);
    for (const KeptPages& one : std::exchange(pool.kept, {})) free_huge_pages(one.memory);
    pool.bytes = 0;
  }
  (void)::malloc_trim(0);
}

}  // namespace superstep
