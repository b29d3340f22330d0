#include <gtest/gtest.h>
#include <set>

#include <vasorod/status.h>

namespace vasorod {
namespace {

// From good to bad, as the enumeration has them.
constexpr Status all[] = {
    Status::converged,  Status::equilibrium_only,  Status::unstable,        Status::buckled,
    Status::not_unique, Status::self_intersecting, Status::iteration_limit, Status::interrupted};

TEST(Status, NamesReadBackAndDiffer) {
  std::set<std::string> names;
  for (const Status status : all) {
    const std::string name = to_string(status);
    EXPECT_FALSE(name.empty());
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_EQ(status_named(name), status) << name;
  }
  EXPECT_EQ(to_string(Status::equilibrium_only), "equilibrium_only");
}

TEST(Status, OtherNamesAreNone) {
  for (const char* name : {"", "Converged", "converged ", "equilibrium only", "failed"})
    EXPECT_FALSE(status_named(name)) << name;
}

TEST(Status, AWholeIsAsGoodAsItsWorstPart) {
  for (std::size_t i = 0; i < std::size(all); ++i)
    for (std::size_t j = 0; j < std::size(all); ++j)
      EXPECT_EQ(worse(all[i], all[j]), all[std::max(i, j)]);
}

}  // namespace
}  // namespace vasorod
