// Kernels compiled twice: for every machine, and for those with AVX2 and FMA.
//
// Both give the same bits: contraction is off, and std::fma rounds once whether the hardware or the
// library does it. Without the second one std::fma is a library call, and the fused forms would
// look three times dearer than they are.
#ifndef RASTERPROOF_REFERENCE_MACHINE_H_
#define RASTERPROOF_REFERENCE_MACHINE_H_

namespace rasterproof::reference {

// Sanitized builds check the one copy that every machine has: the other one is the same source, and
// instrumenting both takes a compiler twice as long.
#if defined(__SANITIZE_ADDRESS__)
#define RASTERPROOF_ONE_KERNEL_COPY
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RASTERPROOF_ONE_KERNEL_COPY
#endif
#endif

#if defined(__x86_64__) && !defined(RASTERPROOF_ONE_KERNEL_COPY)

/// Calls kernel() with everything it calls compiled for AVX2 and FMA.
template <class Kernel>
[[gnu::target("avx2,fma"), gnu::flatten]] void RunForAvx2(const Kernel& kernel) {
  kernel();
}

/// Calls kernel(), compiled for the machine at hand.
template <class Kernel>
void RunForThisMachine(const Kernel& kernel) {
  static const bool has_avx2 =
      __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
  if (has_avx2) {
    RunForAvx2(kernel);
  } else {
    kernel();
  }
}

#else

template <class Kernel>
void RunForThisMachine(const Kernel& kernel) {
  kernel();
}

#endif

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_MACHINE_H_
