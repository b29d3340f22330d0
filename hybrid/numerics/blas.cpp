#include "numerics/blas.h"

#include <algorithm>
#include <mutex>
#include <new>
#include <omp.h>
#include <sys/mman.h>

// Declared here instead of including OpenBLAS's cblas.h, because other BLAS packages install a
// header of the same name.
extern "C" {
char* openblas_get_config(void);
int openblas_get_num_threads(void);
void openblas_set_num_threads(int);
// What OpenBLAS itself does before a fork. Not in a library without threads.
int blas_thread_shutdown_(void) __attribute__((weak));
void dpotrf_(const char* side, const int* n, double* matrix, const int* stride, int* info);
}

namespace vasorod {
namespace {

std::once_flag threads_chosen, buffer_made;

// OpenBLAS maps one buffer for the calling thread and one for each thread of its own, at the first
// call that needs one, and keeps it. If the mapping fails it retries without end. So it is made
// here, after a test whether it fits. 128 MB each on x86-64 (32 << 22 bytes), and some slack.
constexpr std::size_t buffer_bytes = std::size_t{136} << 20;

void require_buffers(int count) {
  const std::size_t bytes = buffer_bytes * static_cast<std::size_t>(count);
  void* trial = mmap(nullptr, bytes, PROT_READ | PROT_WRITE,
                     MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (trial == MAP_FAILED) throw std::bad_alloc();
  munmap(trial, bytes);
}

void make_buffer() {
  std::call_once(buffer_made, [] {
    // OpenBLAS's threads may not have mapped theirs yet.
    require_buffers(std::max(openblas_get_num_threads(), 1));
    double one = 1;
    const int size = 1;
    int info = 0;
    dpotrf_("L", &size, &one, &size, &info);
  });
}

}  // namespace

std::string blas_name() {
  const std::string name = openblas_get_config();
  return name.rfind("OpenBLAS", 0) == 0 ? name : "OpenBLAS " + name;
}

void set_blas_threads(int threads) {
  make_buffer();
  std::call_once(threads_chosen, [] {});
  if (threads > openblas_get_num_threads()) require_buffers(threads - openblas_get_num_threads());
  openblas_set_num_threads(std::max(threads, 1));
}

void end_blas_threads() {
  std::call_once(threads_chosen, [] {});
  openblas_set_num_threads(1);  // before: it begins threads where there are none
  if (blas_thread_shutdown_) blas_thread_shutdown_();
}

void require_blas_buffers(int threads) {
  make_buffer();
  if (threads > 1) require_buffers(threads - 1);
}

OneCholmodThread::OneCholmodThread() : before_(omp_get_max_active_levels()) {
  make_buffer();
  std::call_once(threads_chosen, [] { openblas_set_num_threads(1); });
  omp_set_max_active_levels(0);
}

OneCholmodThread::~OneCholmodThread() {
  omp_set_max_active_levels(before_);
}

}  // namespace vasorod
