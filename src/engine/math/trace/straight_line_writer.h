// Writes the steps of a straight-line program as expressions of a language: what the writers of all languages share.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "poinsot/engine/math/trace/straight_line_text.h"

namespace poinsot {

// How tight an expression holds together: brackets stand around what is looser than its place.
enum class Binding { sum, product, quotient, power, atom };

struct Piece {
  std::string text;
  Binding binding = Binding::atom;
};

class ProgramWriter {
 public:
  // All arguments must outlive it. Throws std::invalid_argument for names that do not fit the program.
  ProgramWriter(const StraightLine& program, const ProgramText& text, TextForm form);

  const StraightLine& program() const { return program_; }
  const ProgramText& text() const { return text_; }
  TextForm form() const { return form_; }

  // Nothing gets a name of its own.
  void keep_in_one_line();
  // Each named subexpression with what it stands for; then all outputs are known.
  std::vector<std::pair<std::string, std::string>> named();
  std::string output(std::size_t i) const { return of(program_.outputs()[i]).text; }

  std::string shown_name(const TextInput& input) const;
  // What goes in and comes out, a line each.
  std::vector<std::string> legend() const;
  static std::string shape(const TextBlock& block);
  bool uses_functions() const;

 private:
  void check() const;
  bool writes_powers() const;
  void count_uses();
  std::vector<StraightLine::Operand> shown_outputs() const;
  Piece constant(const StraightLine::Step& step) const;
  Piece of(const StraightLine::Operand& x) const;
  std::string function_name(TracedOperation op) const;
  Piece operation(const StraightLine::Step& step) const;

  const StraightLine& program_;
  const ProgramText& text_;
  TextForm form_;
  std::vector<std::size_t> uses_;
  std::vector<Piece> pieces_;
  std::set<std::string> taken_;
  std::string prefix_ = "z";
  std::size_t longest_inline_;
};

// Greek letters stand for themselves; digits at the end and what follows a _ become an index.
std::string tex_name(std::string name);

// The whole text in the language of the writer.
std::string c_text(ProgramWriter& writer);  // C and C++
std::string python_text(ProgramWriter& writer);
std::string sympy_text(ProgramWriter& writer);
std::string plain_text(ProgramWriter& writer);
std::string tex_text(ProgramWriter& writer);

}  // namespace poinsot
