// Straight-line programs as functions in Python and as expressions of SymPy.
#include "engine/math/trace/straight_line_writer.h"

namespace poinsot {

std::string python_text(ProgramWriter& writer) {
  std::string all;
  for (const std::string& line : writer.text().remarks) all += "# " + line + "\n";
  for (const std::string& line : writer.legend()) all += "# " + line + "\n";
  if (writer.uses_functions()) all += "from math import acos, asin, atan, atan2, cos, fabs, sin, sqrt\n";
  all += "\n\ndef " + writer.text().function + "(";
  for (std::size_t i = 0; i < writer.text().arrays.size(); ++i) all += (i == 0 ? "" : ", ") + writer.text().arrays[i];
  all += "):\n    \"\"\"The numbers of out, in a list.\"\"\"\n";
  for (const auto& [name, value] : writer.named()) all += "    " + name + " = " + value + "\n";
  all += "    return [\n";
  for (std::size_t i = 0; i < writer.program().outputs().size(); ++i) all += "        " + writer.output(i) + ",\n";
  return all + "    ]\n";
}

std::string sympy_text(ProgramWriter& writer) {
  std::string all;
  for (const std::string& line : writer.text().remarks) all += "# " + line + "\n";
  for (const TextInput& input : writer.text().inputs)
    all += "# " + writer.shown_name(input) + (input.meaning.empty() ? "" : ": " + input.meaning) + "\n";
  for (const TextBlock& block : writer.text().blocks)
    all += "# " + block.name + ", " + ProgramWriter::shape(block) + ": " + block.meaning + "\n";
  all += "from sympy import Abs, Matrix, Rational, Symbol, acos, asin, atan, atan2, cos, sin, sqrt\n\n";
  for (const TextInput& input : writer.text().inputs)
    all += writer.shown_name(input) + " = Symbol('" + writer.shown_name(input) + "', " +
           (input.positive ? "positive=True" : "real=True") + ")\n";
  all += "\n";
  for (const auto& [name, value] : writer.named()) all += name + " = " + value + "\n";
  std::size_t at = 0;
  for (const TextBlock& block : writer.text().blocks) {
    all += block.name + " = Matrix([\n";
    for (std::size_t i = 0; i < block.rows; ++i) {
      all += "    [";
      for (std::size_t j = 0; j < block.columns; ++j) all += (j == 0 ? "" : ", ") + writer.output(at++);
      all += "],\n";
    }
    all += "])\n";
  }
  return all;
}

}  // namespace poinsot
