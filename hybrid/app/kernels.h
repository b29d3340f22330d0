// Which kernels of OpenBLAS the process computes with.
#pragma once

namespace vasorod {

/// OpenBLAS takes its oldest kernels, those for SSE3, on a processor that is newer than itself:
/// factorisations take half as long again. Where that is so and the processor has AVX2, begins the
/// program anew with the kernels for AVX2, which OpenBLAS only takes from its environment, and does
/// not return. A user's OPENBLAS_CORETYPE is obeyed. `argv`: that of main(). Call first of all.
void choose_blas_kernels(char** argv);

}  // namespace vasorod
