// FLINT, Arb and GMP, loaded where one of their functions is first called. To bind their many symbols takes half of the
// program's start, and only formulas need them.
//
// Each function that poinsot calls stands here under its own name and jumps to where its slot points: at first to
// code that loads the libraries and fills all slots, then to the function itself. flint_functions.inc lists the
// functions and the libraries; cmake/functions_used.cmake writes it.
#include <dlfcn.h>

#include <array>
#include <atomic>
#include <cstdlib>
#include <iterator>
#include <string>

#include "exit_codes.h"
#include "streams.h"

namespace {

constexpr const char* names[] = {
#define FUNCTION(name) #name,
#define LIBRARY(file)
#include "flint_functions.inc"
#undef FUNCTION
#undef LIBRARY
};
constexpr const char* libraries[] = {
#define FUNCTION(name)
#define LIBRARY(file) file,
#include "flint_functions.inc"
#undef FUNCTION
#undef LIBRARY
};

[[noreturn]] void give_up() {
  const char* reason = dlerror();
  write_message(std::string("poinsot: formulas need FLINT and Arb, which cannot be loaded: ") + (reason ? reason : "") +
                "\nInstall them again, as they were when poinsot was built.");
  std::_Exit(exit_internal);
}

}  // namespace

// Known to the code below by these names.
extern "C" {
[[gnu::visibility("hidden")]] void poinsot_load_flint() noexcept;
[[gnu::visibility("hidden")]] extern std::atomic<void*> poinsot_flint_slots[];
}

// Threads that come here together fill the slots with the same addresses.
void poinsot_load_flint() noexcept {
  std::array<void*, std::size(libraries)> handles;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    handles[i] = dlopen(libraries[i], RTLD_NOW | RTLD_LOCAL);
    if (!handles[i]) give_up();
  }
  for (std::size_t k = 0; k < std::size(names); ++k) {
    void* function = nullptr;
    for (std::size_t i = 0; i < handles.size() && !function; ++i) function = dlsym(handles[i], names[k]);
    if (!function) give_up();
    poinsot_flint_slots[k].store(function, std::memory_order_release);
  }
}

// Every argument is kept for the function that was meant (System V ABI, AMD64: six integers, eight vectors, the number
// of vectors in rax); r11, which belongs to nobody between functions, tells its slot.
asm(R"(
  .pushsection .text
  .hidden poinsot_first_flint_call
  .type poinsot_first_flint_call, @function
poinsot_first_flint_call:
  endbr64
  pushq %rbp
  movq %rsp, %rbp
  pushq %rdi
  pushq %rsi
  pushq %rdx
  pushq %rcx
  pushq %r8
  pushq %r9
  pushq %rax
  pushq %r11
  subq $128, %rsp
  movups %xmm0, (%rsp)
  movups %xmm1, 16(%rsp)
  movups %xmm2, 32(%rsp)
  movups %xmm3, 48(%rsp)
  movups %xmm4, 64(%rsp)
  movups %xmm5, 80(%rsp)
  movups %xmm6, 96(%rsp)
  movups %xmm7, 112(%rsp)
  call poinsot_load_flint
  movups (%rsp), %xmm0
  movups 16(%rsp), %xmm1
  movups 32(%rsp), %xmm2
  movups 48(%rsp), %xmm3
  movups 64(%rsp), %xmm4
  movups 80(%rsp), %xmm5
  movups 96(%rsp), %xmm6
  movups 112(%rsp), %xmm7
  addq $128, %rsp
  popq %r11
  popq %rax
  popq %r9
  popq %r8
  popq %rcx
  popq %rdx
  popq %rsi
  popq %rdi
  popq %rbp
  jmpq *(%r11)
  .size poinsot_first_flint_call, . - poinsot_first_flint_call

  .pushsection .data
  .balign 8
  .hidden poinsot_flint_slots
poinsot_flint_slots:
  .popsection
  .macro poinsot_flint_function name
  .pushsection .data
.Lslot_\name:
  .quad poinsot_first_flint_call
  .popsection
  .globl \name
  .hidden \name
  .type \name, @function
\name:
  endbr64
  leaq .Lslot_\name(%rip), %r11
  jmpq *(%r11)
  .size \name, . - \name
  .endm
)"
#define FUNCTION(name) "  poinsot_flint_function " #name "\n"
#define LIBRARY(file)
#include "flint_functions.inc"
#undef FUNCTION
#undef LIBRARY
    "  .popsection\n");
