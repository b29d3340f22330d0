#include <gtest/gtest.h>

#include "data/prestress_sentence.h"

namespace vasorod {
namespace {

TEST(PrestressSentence, ALargeLinearDisplacementIsNamed) {
  EXPECT_FALSE(large_prestress("svc", 0.1, {}));
  EXPECT_EQ(large_prestress("svc", 0.204, {})
                ->find("prestress of svc: it is that of a linear displacement of up to 20 % of the "
                       "radius"),
            0);
}

TEST(PrestressSentence, AShapeWithoutStressIsNamedWhetherFoundOrNot) {
  EXPECT_EQ(large_prestress("svc", 0.01, 0)
                ->find("prestress of svc: its shape without stress was not found"),
            0);
  // The linear displacement was longer.
  EXPECT_EQ(*large_prestress("svc", 0.09, 12),
            "prestress of svc: its shape without stress, which is up to 9 % of the radius away, "
            "was found in 12 steps, as a linear displacement would be rough");
}

}  // namespace
}  // namespace vasorod
