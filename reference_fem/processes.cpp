#include "reference_fem/processes.h"

#include <mpi.h>

namespace vasorod::fem {

Processes Processes::world() {
  Processes processes;
  MPI_Comm_rank(MPI_COMM_WORLD, &processes.rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &processes.size_);
  return processes;
}

void Processes::sum(double* values, std::size_t count) const {
  if (size_ == 1) return;
  MPI_Allreduce(MPI_IN_PLACE, values, static_cast<int>(count), MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

bool Processes::any(bool here) const {
  double count = here ? 1 : 0;
  sum(&count, 1);
  return count > 0;
}

}  // namespace vasorod::fem
