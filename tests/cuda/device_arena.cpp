#include "cuda/device_arena.hpp"

#include <stdexcept>
#include <sys/mman.h>
#include <unistd.h>

namespace facet {
namespace {

constexpr std::size_t arena_bytes = std::size_t{1} << 30;

}  // namespace

DeviceArena& DeviceArena::instance() {
  static DeviceArena arena;
  return arena;
}

DeviceArena::DeviceArena() {
  void* mapped = ::mmap(nullptr, arena_bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (mapped == MAP_FAILED) throw std::runtime_error("the emulated device has no memory");
  base_ = static_cast<std::byte*>(mapped);
}

DeviceArena::Access::Access() {
  instance().protect(PROT_READ | PROT_WRITE);
}
DeviceArena::Access::~Access() {
  instance().protect(PROT_NONE);
}

void* DeviceArena::allocate(std::size_t bytes) {
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  const std::size_t rounded = (bytes + page - 1) / page * page;
  if (rounded > arena_bytes - used_) return nullptr;
  void* start = base_ + used_;
  used_ += rounded;
  return start;
}

void DeviceArena::protect(int rights) const {
  if (used_ > 0) ::mprotect(base_, used_, rights);
}

}  // namespace facet
