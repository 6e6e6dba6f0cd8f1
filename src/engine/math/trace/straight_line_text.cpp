#include "poinsot/engine/math/trace/straight_line_text.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "engine/math/trace/straight_line_writer.h"

namespace poinsot {
namespace {

// Words of others that stand in a comment must not end it or go on in the next line.
std::string comment_line(std::string line) {
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  for (const char* const mark : {"*/", "/*"})
    for (std::size_t at = line.find(mark); at != std::string::npos; at = line.find(mark, at + 1))
      line.insert(at + 1, " ");
  while (line.ends_with('\\') || line.ends_with(' ')) line.pop_back();
  return line;
}

}  // namespace

bool is_code_name(std::string_view word) {
  // clang-format off
  static const std::set<std::string, std::less<>> reserved{
      "and", "as", "asm", "assert", "async", "auto", "await", "bool", "break", "case", "catch", "char", "class",
      "const", "constexpr", "continue", "def", "default", "del", "delete", "do", "double", "elif", "else",
      "enum", "except", "explicit", "export", "extern", "false", "False", "finally", "float", "for", "friend",
      "from", "global", "goto", "if", "import", "in", "inline", "int", "is", "lambda", "long", "main",
      "mutable", "namespace", "new", "noexcept", "None", "nonlocal", "not", "nullptr", "operator", "or", "pass",
      "private", "protected", "public", "raise", "register", "requires", "restrict", "return", "short",
      "signed", "sizeof", "static", "struct", "switch", "template", "this", "throw", "true", "True", "try",
      "typedef", "typename", "union", "unsigned", "using", "virtual", "void", "volatile", "while", "with",
      "xor", "yield", "sin", "cos", "tan", "sqrt", "asin", "acos", "atan", "atan2", "fabs", "abs", "Abs",
      "Matrix", "Rational", "Symbol", "concept", "co_await", "co_return", "co_yield", "consteval", "constinit",
      "thread_local", "typeid", "decltype", "static_assert", "alignas", "alignof", "wchar_t", "char8_t",
      "char16_t", "char32_t", "bitand", "bitor", "compl", "and_eq", "or_eq", "xor_eq", "not_eq", "const_cast",
      "dynamic_cast", "reinterpret_cast", "static_cast",
  };
  // clang-format on
  if (word.empty() || std::isdigit(static_cast<unsigned char>(word[0]))) return false;
  return std::all_of(word.begin(), word.end(),
                     [](unsigned char c) { return c < 128 && (std::isalnum(c) || c == '_'); }) &&
         !reserved.contains(word);
}

std::string formula_text(const StraightLine& program, const std::vector<TextInput>& inputs) {
  const ProgramText text{"formula", {}, inputs, {{"formula", "", program.outputs().size(), 1, false}}, {}};
  ProgramWriter writer(program, text, TextForm::plain);
  writer.keep_in_one_line();
  writer.named();
  return writer.output(0);
}

std::string write_program(const StraightLine& program, const ProgramText& text, TextForm form) {
  ProgramText clean = text;
  for (std::string& line : clean.remarks) line = comment_line(line);
  for (TextInput& input : clean.inputs) input.meaning = comment_line(input.meaning);
  for (TextBlock& block : clean.blocks) block.meaning = comment_line(block.meaning);
  ProgramWriter writer(program, clean, form);
  switch (form) {
    case TextForm::c:
    case TextForm::cpp:
      return c_text(writer);
    case TextForm::python:
      return python_text(writer);
    case TextForm::sympy:
      return sympy_text(writer);
    case TextForm::plain:
      return plain_text(writer);
    case TextForm::tex:
      return tex_text(writer);
  }
  return {};
}

}  // namespace poinsot
