// Which BLAS the sparse factorisations use, and how many threads it may take.
#pragma once

#include <string>

namespace vasorod {

/// For example "OpenBLAS 0.3.21 NO_LAPACKE DYNAMIC_ARCH NO_AFFINITY SkylakeX MAX_THREADS=64".
std::string blas_name();

/// Threads of the BLAS (at least 1). Until this is called the factorisations use one: a tube's
/// supernodes are too small to share.
void set_blas_threads(int threads);

/// While alive, CHOLMOD's own parallel regions run on the calling thread. CHOLMOD 3.0 as Debian 12
/// builds it opens four threads whatever OMP_NUM_THREADS says, which costs a factor of two to five
/// on a vessel.
class OneCholmodThread {
 public:
  OneCholmodThread();
  ~OneCholmodThread();
  OneCholmodThread(const OneCholmodThread&) = delete;
  OneCholmodThread& operator=(const OneCholmodThread&) = delete;

 private:
  int before_;
};

}  // namespace vasorod
