// The results that the page may still ask for.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "planner/stored_result.h"

namespace vasorod::planner {

/// Keeps the last 32 results, and up to as many that are held. May be used by several threads.
class ResultShelf {
 public:
  static constexpr std::size_t most = 32;

  /// A held result stays while others come. Throws Refusal: 404, or 409 where 32 are held.
  void hold(const std::string& id, bool hold);

  /// A name that no other result of this process has.
  std::string next_id();
  void put(std::shared_ptr<const StoredResult> result);
  /// Throws Refusal (404).
  std::shared_ptr<const StoredResult> find(const std::string& id) const;

 private:
  mutable std::mutex mutex_;
  std::deque<std::shared_ptr<const StoredResult>> results_, held_;
  long count_ = 0;
};

}  // namespace vasorod::planner
