#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <charconv>

#include "document/data_file.h"
#include "document/file_output.h"

namespace poinsot::document {
namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 20;

// A field of the file, in quotes if it contains a character that would end it.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

class CsvFile : public DataFile {
 public:
  CsvFile(const std::string& path, const DataHead& head)
      : path_(path), file_(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
    if (file_.number() < 0) cannot_write(path, errno);
    for (const RecordingHead::Column& column : head.recording.columns) {
      text_ += (factors_.empty() ? "" : ",") +
               field(column.unit.empty() ? column.name : column.name + " [" + column.unit + "]");
      factors_.push_back(column.factor);
    }
    text_ += "\r\n";
    if (head.complete) return;
    last_line_ = fmt::format("# incomplete: {} rows", head.rows);
    if (head.recording.rows) last_line_ += fmt::format(" of {}", *head.recording.rows);
    last_line_ += "\r\n";
  }

  void add(std::span<const double> values) override {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::size_t column = i % factors_.size();
      char number[40];
      const auto end = std::to_chars(number, number + sizeof number, values[i] / factors_[column]).ptr;
      text_.append(number, end);
      text_ += column + 1 < factors_.size() ? "," : "\r\n";
      if (text_.size() >= buffer_bytes) flush();
    }
  }

  void finish() override {
    text_ += last_line_;
    flush();
    sync_file(file_.number(), path_);
  }

 private:
  void flush() {
    if (const int error = write_all(file_.number(), text_)) cannot_write(path_, error);
    text_.clear();
  }

  std::string path_;
  Descriptor file_;
  std::vector<double> factors_;
  std::string text_, last_line_;
};

}  // namespace

std::unique_ptr<DataFile> make_csv_file(const std::string& path, const DataHead& head) {
  return std::make_unique<CsvFile>(path, head);
}

}  // namespace poinsot::document
