#include "python/errors.h"

#include <new>
#include <pybind11/pybind11.h>
#include <stdexcept>
#include <system_error>

#include <vasorod/error.h>
#include <vasorod/predict.h>

#include "predict/memory_need.h"

namespace vasorod::python {
namespace {

void say_no_memory() {
  PyErr_SetString(PyExc_MemoryError,
                  "found no memory left, expected a scene that fits into it: fewer triangles or "
                  "elements");
}

}  // namespace

void translate_errors() {
  // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 calls it by value
  pybind11::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const InputError& input) {
      PyErr_SetString(PyExc_ValueError, input.what());
    } catch (const FileError& file) {
      PyErr_SetString(PyExc_OSError, file.what());
    } catch (const StoppedEarly& stopped) {
      PyErr_SetString(PyExc_TimeoutError, stopped.what());
    } catch (const TooLarge& large) {
      PyErr_SetString(PyExc_MemoryError, large.what());
    } catch (const std::bad_alloc&) {
      say_no_memory();
    } catch (const std::length_error&) {  // thrown by containers for sizes beyond any memory
      say_no_memory();
    } catch (const std::system_error& system) {
      // A thread could not be started because there is no memory for its stack.
      if (system.code() != std::errc::resource_unavailable_try_again) throw;
      say_no_memory();
    }
  });
}

}  // namespace vasorod::python
