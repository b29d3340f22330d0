#include "planner/result_shelf.h"
#include "planner/small_scene.h"

namespace vasorod::planner {
namespace {

std::string put_one(ResultShelf& shelf) {
  const std::string id = shelf.next_id();
  shelf.put(std::make_shared<StoredResult>(id, Result(), std::nullopt, "{}"));
  return id;
}

TEST(ResultShelf, TheOldestGoes) {
  ResultShelf shelf;
  const std::string first = put_one(shelf), second = put_one(shelf);
  EXPECT_NE(first, second);
  for (std::size_t k = 2; k < ResultShelf::most; ++k) put_one(shelf);
  EXPECT_EQ(shelf.find(first)->id, first);
  put_one(shelf);
  EXPECT_EQ(refusal_of([&] { shelf.find(first); }).status, 404);
  EXPECT_EQ(shelf.find(second)->id, second);
}

TEST(ResultShelf, AHeldResultStays) {
  ResultShelf shelf;
  const std::string held = put_one(shelf);
  shelf.hold(held, true);
  shelf.hold(held, true);
  for (std::size_t k = 0; k < 2 * ResultShelf::most; ++k) put_one(shelf);
  EXPECT_EQ(shelf.find(held)->id, held);
  shelf.hold(held, false);
  shelf.hold(held, false);
  EXPECT_EQ(shelf.find(held)->id, held);  // the newest now
  for (std::size_t k = 0; k < ResultShelf::most; ++k) put_one(shelf);
  EXPECT_EQ(refusal_of([&] { shelf.hold(held, true); }).status, 404);
  for (std::size_t k = 0; k < ResultShelf::most; ++k) shelf.hold(put_one(shelf), true);
  const std::string one_more = put_one(shelf);
  EXPECT_EQ(refusal_of([&] { shelf.hold(one_more, true); }).status, 409);
}

}  // namespace
}  // namespace vasorod::planner
