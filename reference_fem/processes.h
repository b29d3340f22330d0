// The processes that solve together: one by default, all of an MPI launch for what outgrows one
// machine. The state and the mesh's nodes are the same on every process; cells, and with them
// assembly and the factor, are shared out.
#pragma once

#include <cstddef>

namespace vasorod::fem {

class Processes {
 public:
  Processes() = default;  ///< this process alone
  /// All processes of the MPI launch, which must have been initialised.
  static Processes world();

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool first() const { return rank_ == 0; }

  /// Sums over the processes, in place on every one.
  void sum(double* values, std::size_t count) const;
  /// Whether it is so on any process.
  bool any(bool here) const;

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace vasorod::fem
