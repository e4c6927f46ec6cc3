#include "web/engine/throwing.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <typeinfo>

namespace {

std::array<char, 4096> message{};
alignas(16) std::array<char, 4096> thrown{};

// What the compiler writes for a class with one base, which lies at its beginning.
struct TypeWithBase {
  const void* table;
  const char* name;
  const TypeWithBase* base;
};

const TypeWithBase* AsWithBase(const std::type_info& type) {
  return reinterpret_cast<const TypeWithBase*>(&type);
}

bool IsAnException(const std::type_info& thrown_type) {
  const TypeWithBase* type = AsWithBase(thrown_type);
  const void* const with_base = AsWithBase(typeid(std::runtime_error))->table;
  while (type->name != AsWithBase(typeid(std::exception))->name) {
    if (type->table != with_base) return false;
    type = type->base;
  }
  return true;
}

[[noreturn]] void EndWith(const char* what) {
  std::strncpy(message.data(), what, message.size() - 1);
  __builtin_trap();
}

}  // namespace

const char* rasterproof::web::LastMessage() { return message.data(); }

extern "C" {

// The compiler's own functions are compiled with guards of the stack.
std::uintptr_t __stack_chk_guard = 0x5afe57ac;
[[noreturn]] void __stack_chk_fail() { EndWith("the stack is damaged"); }

void* __cxa_allocate_exception(std::size_t size) noexcept {
  return size <= thrown.size() ? thrown.data() : nullptr;
}
void __cxa_free_exception(void* /*exception*/) noexcept {}
[[noreturn]] void __cxa_throw(void* exception, std::type_info* type, void (* /*destroy*/)(void*)) {
  if (!IsAnException(*type)) EndWith(type->name());
  EndWith(static_cast<const std::exception*>(exception)->what());
}
[[noreturn]] void __cxa_rethrow() { EndWith("thrown again"); }
void* __cxa_begin_catch(void* exception) noexcept { return exception; }
void __cxa_end_catch() {}

}  // extern "C"
