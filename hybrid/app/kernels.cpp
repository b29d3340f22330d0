#include "app/kernels.h"

#include <cstdlib>
#include <string>
#include <unistd.h>

#include "numerics/blas.h"

namespace vasorod {
namespace {

constexpr char variable[] = "OPENBLAS_CORETYPE";

bool has_avx2() {
#ifdef __x86_64__
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

}  // namespace

void choose_blas_kernels(char** argv) {
  if (std::getenv(variable) != nullptr || !has_avx2()) return;
  if (blas_name().find(" Prescott ") == std::string::npos) return;
  setenv(variable, "Haswell", 1);
  execv("/proc/self/exe", argv);
  unsetenv(variable);  // it could not begin anew: slower, but right
}

}  // namespace vasorod
