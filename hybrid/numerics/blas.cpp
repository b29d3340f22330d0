#include "numerics/blas.h"

#include <algorithm>
#include <mutex>
#include <omp.h>

// Declared here instead of including OpenBLAS's cblas.h, because other BLAS packages install a
// header of the same name.
extern "C" {
char* openblas_get_config(void);
void openblas_set_num_threads(int);
}

namespace vasorod {
namespace {

std::once_flag threads_chosen;

}  // namespace

std::string blas_name() {
  const std::string name = openblas_get_config();
  return name.rfind("OpenBLAS", 0) == 0 ? name : "OpenBLAS " + name;
}

void set_blas_threads(int threads) {
  std::call_once(threads_chosen, [] {});
  openblas_set_num_threads(std::max(threads, 1));
}

OneCholmodThread::OneCholmodThread() : before_(omp_get_max_active_levels()) {
  std::call_once(threads_chosen, [] { openblas_set_num_threads(1); });
  omp_set_max_active_levels(0);
}

OneCholmodThread::~OneCholmodThread() {
  omp_set_max_active_levels(before_);
}

}  // namespace vasorod
