#include "app/kernels.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
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
  const std::string blas = blas_name();
  if (blas.find(" DYNAMIC_ARCH ") == std::string::npos ||
      blas.find(" Prescott ") == std::string::npos)
    return;
  // By its path, after which the process is named. That of the dynamic loader, where a user called
  // it with the program, could not take these arguments.
  std::error_code failed;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", failed);
  if (failed || program.filename().string().rfind("ld-", 0) == 0) return;
  if (setenv(variable, "Haswell", 1) != 0) return;
  execv(program.c_str(), argv);
  unsetenv(variable);  // it could not begin anew: slower, but right
}

}  // namespace vasorod
