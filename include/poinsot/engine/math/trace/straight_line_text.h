// Straight-line programs as code and as formulas: plain text, TeX, C (C99), C++, Python and SymPy.
//
// A result that is used more than once gets a name: z1, z2, ... All others are written where they are used, as long
// as lines stay short.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "poinsot/engine/math/trace/straight_line.h"

namespace poinsot {

enum class TextForm { plain, tex, c, cpp, python, sympy };

// An input: element `index` of the array `array` in code, `name` in formulas ("theta", "theta'" for a rate, "M_2").
struct TextInput {
  std::string array;
  int index = 0;
  std::string name;
  std::string meaning;    // "rad: angle of hinge 'A'"
  bool positive = false;  // whether it is known to be positive, as a mass or a length
};

// A number, vector or matrix among the outputs. Its numbers follow one another in rows, and blocks follow in their
// order.
struct TextBlock {
  std::string name;
  std::string meaning;
  std::size_t rows = 1, columns = 1;
  bool symmetric = false;  // plain text and TeX then show the lower triangle
};

struct ProgramText {
  std::string function;              // its name in code
  std::vector<std::string> arrays;   // parameters of the function before the result, in order
  std::vector<TextInput> inputs;     // in the order of the program's
  std::vector<TextBlock> blocks;     // all outputs
  std::vector<std::string> remarks;  // lines that stand first, as comments
};

// The program as text. Throws std::invalid_argument if inputs or blocks do not fit the program, or if the name of the
// function is not possible in C.
std::string write_program(const StraightLine& program, const ProgramText& text, TextForm form);

// The first output as one line of plain text.
std::string formula_text(const StraightLine& program, const std::vector<TextInput>& inputs);

// Whether a word can be the name of a function: letters, digits and _, not beginning with a digit, and no word of C,
// C++ or Python.
bool is_code_name(std::string_view word);

}  // namespace poinsot
