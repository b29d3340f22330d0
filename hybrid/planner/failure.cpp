#include "planner/failure.h"

#include <new>
#include <stdexcept>
#include <system_error>

#include <vasorod/error.h>
#include <vasorod/predict.h>

#include "data/sentence.h"
#include "planner/body.h"
#include "predict/memory_need.h"

namespace vasorod::planner {

Failure failure_now() {
  const std::string no_memory =
      "found no memory left, expected a scene that fits into it: fewer triangles";
  try {
    throw;
  } catch (const Refusal& error) {
    return {error.status, one_line(error.what())};
  } catch (const InputError& error) {
    return {400, one_line(error.what())};
  } catch (const FileError& error) {
    return {500, one_line(error.what())};
  } catch (const StoppedEarly& error) {
    return {500, one_line(error.what())};
  } catch (const TooLarge& error) {
    return {500, one_line(error.what())};
  } catch (const std::bad_alloc&) {
    return {500, no_memory};
  } catch (const std::length_error&) {  // thrown by containers for sizes beyond any memory
    return {500, no_memory};
  } catch (const std::exception& error) {
    return {500, "unexpected: " + one_line(error.what())};
  } catch (...) {
    return {500, "unexpected: an exception without words"};
  }
}

}  // namespace vasorod::planner
