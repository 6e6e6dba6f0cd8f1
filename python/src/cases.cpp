#include "cases.h"

#include <memory>

namespace nb = nanobind;

namespace poinsot::python {

CaseShape case_shape(const std::vector<CaseInput>& inputs) {
  CaseShape cases;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto& [name, array, rows] = inputs[i];
    const auto refuse = [&](const std::string& why) { throw nb::value_error((std::string(name) + " " + why).c_str()); };
    if (array.ndim() != 1 && array.ndim() != 2)
      refuse("is an array of " + std::to_string(array.ndim()) +
             " dimensions: expected one number for each coordinate, "
             "or a row for each with a column for each case");
    if (array.shape(0) != static_cast<std::size_t>(rows))
      refuse("has " + std::to_string(array.shape(0)) + " rows, the model needs " + std::to_string(rows));
    const bool single = array.ndim() == 1;
    const std::size_t count = single ? 1 : array.shape(1);
    if (i > 0 && (single != cases.single || count != cases.count))
      refuse("is of " + std::to_string(count) + " cases, " + inputs[0].name + " of " + std::to_string(cases.count));
    cases = {count, single};
  }
  return cases;
}

ResultArray new_result(std::vector<std::size_t> shape, const CaseShape& cases) {
  if (!cases.single) shape.push_back(cases.count);
  std::size_t size = 1;
  for (const std::size_t part : shape) size *= part;
  auto numbers = std::make_unique<double[]>(size);
  double* const data = numbers.release();
  const nb::capsule owner(data, [](void* pointer) noexcept { delete[] static_cast<double*>(pointer); });
  return ResultArray(data, shape.size(), shape.data(), owner);
}

}  // namespace poinsot::python
