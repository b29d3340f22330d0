#include "reference_fem/team.h"

#include <mpi.h>

namespace vasorod::fem {

Team Team::world() {
  Team team;
  MPI_Comm_rank(MPI_COMM_WORLD, &team.rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &team.size_);
  return team;
}

void Team::sum(double* values, std::size_t count) const {
  if (size_ == 1) return;
  MPI_Allreduce(MPI_IN_PLACE, values, static_cast<int>(count), MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
}

bool Team::any(bool here) const {
  double count = here ? 1 : 0;
  sum(&count, 1);
  return count > 0;
}

}  // namespace vasorod::fem
