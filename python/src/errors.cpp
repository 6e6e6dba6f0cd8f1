// Errors of poinsot as exceptions of Python, which poinsot/errors.py declares.
#include <exception>
#include <tuple>
#include <vector>

#include "bindings.h"
#include "poinsot/pictures.h"
#include "poinsot/problem.h"

namespace nb = nanobind;

namespace poinsot::python {
namespace {

void raise(const char* name, const nb::object& argument) {
  const nb::object type = nb::module_::import_("poinsot.errors").attr(name);
  PyErr_SetObject(type.ptr(), argument.ptr());
}

void raise(const char* name, const std::exception& error) { raise(name, nb::str(error.what())); }

nb::object diagnostics(const StatementError& error) {
  nb::list list;
  for (const Diagnostic& one : error.diagnostics())
    list.append(nb::make_tuple(nb::str(one.file.data(), one.file.size()), one.line, one.column,
                               nb::str(one.message.data(), one.message.size()),
                               nb::str(one.hint.data(), one.hint.size())));
  return nb::make_tuple(nb::str(error.what()), list);
}

void translate(const std::exception_ptr& thrown, void*) {
  try {
    std::rethrow_exception(thrown);
  } catch (const StatementError& error) {
    raise("StatementError", diagnostics(error));
  } catch (const NoEquations& error) {
    raise("NoEquations", error);
  } catch (const NoMotion& error) {
    raise("NoAnswer", error);
  } catch (const FigureError& error) {
    raise("FigureError", error);
  } catch (const NoPages& error) {
    raise("NoPages", error);
  } catch (const RecordingError& error) {
    raise("RecordingError", error);
  } catch (const BudgetEnded& ended) {
    raise(ended.end == BudgetEnd::deadline ? "TimedOut" : "Interrupted", nb::str("ended before there was a result"));
  }
}

}  // namespace

void bind_errors(nb::module_&) { nb::register_exception_translator(translate); }

}  // namespace poinsot::python
