// Straight-line programs as formulas to read: plain text and TeX.
#include <algorithm>

#include "engine/math/trace/straight_line_writer.h"

namespace poinsot {
namespace {

// Calls row(left, right) for each line of the formulas of a block.
template <class Row>
void block_rows(const ProgramWriter& writer, const TextBlock& block, std::size_t at, Row row) {
  for (std::size_t i = 0; i < block.rows; ++i)
    for (std::size_t j = 0; j < block.columns; ++j) {
      if (block.symmetric && j > i) continue;
      std::string index;
      if (block.rows * block.columns > 1) index = std::to_string(i + 1);
      if (block.columns > 1) index += (writer.form() == TextForm::tex ? "," : ", ") + std::to_string(j + 1);
      row(index, writer.output(at + i * block.columns + j));
    }
}

}  // namespace

std::string plain_text(ProgramWriter& writer) {
  std::string all;
  for (const std::string& line : writer.text().remarks) all += line + "\n";
  std::size_t widest = 0;
  for (const TextInput& input : writer.text().inputs) widest = std::max(widest, input.name.size());
  all += "\n";
  for (const TextInput& input : writer.text().inputs)
    all += "  " + input.name + std::string(widest - input.name.size() + 2, ' ') + input.meaning + "\n";
  const auto rows = writer.named();
  if (!rows.empty()) all += "\nwith\n";
  for (const auto& [name, value] : rows) all += "  " + name + " = " + value + "\n";
  std::size_t at = 0;
  for (const TextBlock& block : writer.text().blocks) {
    if (block.rows * block.columns == 0) continue;
    all += "\n" + block.name + ": " + block.meaning + (block.symmetric ? " (symmetric)" : "") + "\n";
    block_rows(writer, block, at, [&](const std::string& index, const std::string& value) {
      all += "  " + block.name + (index.empty() ? "" : "[" + index + "]") + " = " + value + "\n";
    });
    at += block.rows * block.columns;
  }
  return all;
}

std::string tex_text(ProgramWriter& writer) {
  std::string all;
  for (const std::string& line : writer.text().remarks) all += "% " + line + "\n";
  for (const TextInput& input : writer.text().inputs)
    all += "% $" + writer.shown_name(input) + "$: " + input.meaning + "\n";
  all += "\\begin{align*}\n";
  for (const auto& [name, value] : writer.named()) all += "  " + name + " &= " + value + " \\\\\n";
  std::size_t at = 0;
  for (const TextBlock& block : writer.text().blocks) {
    block_rows(writer, block, at, [&](const std::string& index, const std::string& value) {
      all += "  " + tex_name(block.name) + (index.empty() ? "" : "_{" + index + "}") + " &= " + value + " \\\\\n";
    });
    at += block.rows * block.columns;
  }
  return all + "\\end{align*}\n";
}

}  // namespace poinsot
