// Straight-line programs as functions in C and C++.
#include <algorithm>
#include <cctype>

#include "engine/math/trace/straight_line_writer.h"

namespace poinsot {
namespace {

bool mentions(const std::string& line, const std::string& word) {
  for (std::size_t at = line.find(word); at != std::string::npos; at = line.find(word, at + 1))
    if (at == 0 || !(std::isalnum(static_cast<unsigned char>(line[at - 1])) || line[at - 1] == '_')) return true;
  return false;
}

}  // namespace

std::string c_text(ProgramWriter& writer) {
  const bool cpp = writer.form() == TextForm::cpp;
  const std::string star = cpp ? "double* " : "double *";
  std::string all;
  const auto comment = [&](const std::string& line) -> std::string {
    if (cpp) return "// " + line + "\n";
    return "/* " + line + " */\n";
  };
  for (const std::string& line : writer.text().remarks) all += comment(line);
  for (const std::string& line : writer.legend()) all += comment(line);
  if (writer.uses_functions()) all += cpp ? "#include <cmath>\n\n" : "#include <math.h>\n\n";
  const std::string head = std::string(cpp ? "inline " : "") + "void " + writer.text().function + "(";
  std::string parameters;
  for (const std::string& array : writer.text().arrays) parameters += "const " + star + array + ", ";
  parameters += star + "out";
  if (!cpp) all += head + parameters + ");\n\n";
  all += head + parameters + ") {\n";
  const auto rows = writer.named();
  std::vector<std::string> body;
  body.reserve(rows.size() + writer.program().outputs().size());
  for (const auto& [name, value] : rows) body.push_back("const double " + name + " = " + value + ";");
  for (std::size_t i = 0; i < writer.program().outputs().size(); ++i)
    body.push_back("out[" + std::to_string(i) + "] = " + writer.output(i) + ";");
  for (const std::string& array : writer.text().arrays)
    if (std::none_of(body.begin(), body.end(), [&](const std::string& line) { return mentions(line, array + "["); }))
      all += "  (void)" + array + ";\n";
  for (const std::string& line : body) all += "  " + line + "\n";
  return all + "}\n";
}

}  // namespace poinsot
