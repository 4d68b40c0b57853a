# SPDX-License-Identifier: GPL-3.0-or-later
# Fused multiply-add in hardware makes double-double arithmetic several times
# faster. It changes no result: contraction is off, and std::fma is the same
# number wherever it is computed.
option(TRUELUX_THIS_PROCESSOR
  "Use the AVX2 and FMA instructions if the building machine has them; off for binaries that other machines run"
  ${PROJECT_IS_TOP_LEVEL})

if(TRUELUX_THIS_PROCESSOR AND NOT CMAKE_CROSSCOMPILING)
  include(CheckCXXSourceRuns)
  set(CMAKE_REQUIRED_FLAGS "-march=x86-64-v3 -O2")
  check_cxx_source_runs([[
    #include <cmath>
    int main(int argc, char**) {
      __builtin_cpu_init();
      if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
        return 1;
      }
      return std::fma(double(argc), 2.0, 1.0) > 0 ? 0 : 1;
    }]] TRUELUX_HAS_X86_64_V3)
  unset(CMAKE_REQUIRED_FLAGS)
  if(TRUELUX_HAS_X86_64_V3)
    target_compile_options(truelux_flags INTERFACE -march=x86-64-v3)
  endif()
endif()
