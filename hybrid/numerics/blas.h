// The BLAS behind the sparse factorisations: its name and its number of threads.
#pragma once

#include <string>

namespace vasorod {

/// The BLAS's own description, for example "OpenBLAS 0.3.21 NO_LAPACKE DYNAMIC_ARCH NO_AFFINITY
/// SkylakeX MAX_THREADS=64".
std::string blas_name();

/// Sets the number of threads of the BLAS itself (at least 1). The default is one thread, because
/// the supernodes of a tube are too small to share (threads.h shares the tree instead). Throws
/// std::bad_alloc where the BLAS's buffers do not fit into the memory.
void set_blas_threads(int threads);

/// Back to one thread, and the BLAS's own threads end. OpenBLAS begins one for each processor when
/// it is loaded, and each looks for work for a while before it sleeps, which a short solve would
/// pay for. To be called at the beginning of a program.
void end_blas_threads();

/// Throws std::bad_alloc where the memory does not suffice for calls from so many threads at once.
void require_blas_buffers(int threads);

/// While an object of this class exists, CHOLMOD's own parallel regions run on the calling thread
/// only. CHOLMOD 3.0 as built by Debian 12 opens four threads whatever OMP_NUM_THREADS says, which
/// slows a vessel down by a factor of two to five. The constructor throws std::bad_alloc as
/// set_blas_threads() does.
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
