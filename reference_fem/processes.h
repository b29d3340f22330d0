// The processes that solve together: one by default, all of an MPI launch for problems beyond one
// machine. State and mesh nodes are the same on every process; cells, and with them assembly and
// factor, are distributed.
#pragma once

#include <cstddef>

namespace vasorod::fem {

/// A group of processes.
class Processes {
 public:
  Processes() = default;  ///< this process alone
  /// All processes of the MPI launch. MPI must be initialised.
  static Processes world();

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool first() const { return rank_ == 0; }

  /// Sums over the processes; every process gets the result in place.
  void sum(double* values, std::size_t count) const;
  /// Whether `here` is true on any process.
  bool any(bool here) const;

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace vasorod::fem
