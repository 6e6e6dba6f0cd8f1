// Writes files such that neither a kill nor a loss of power leaves an incomplete one under its name.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace poinsot::document {

// Throws RecordingError with Fault::machine: "cannot write PATH: reason", for an error number.
[[noreturn]] void cannot_write(const std::string& path, int error);

// An open file that is closed with this object.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor();
  int number() const { return number_; }

 private:
  int number_;
};

// Writes all bytes at the current position of the file. Returns 0 or the error number.
[[nodiscard]] int write_all(int descriptor, std::string_view bytes);

// Wait until the data written, or the entries of the folder that contains the path, are on the disk. They throw as
// cannot_write does.
void sync_file(int descriptor, const std::string& path);
void sync_folder_of(const std::string& path);

// Renames a complete file from `temporary` to its name, permanently.
void put_in_place(const std::string& temporary, const std::string& path);

}  // namespace poinsot::document
