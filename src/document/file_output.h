// Files that are written so that neither a kill nor a loss of power leaves half of one under its name.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace poinsot::document {

// Throws RecordingError (the machine's fault) "cannot write PATH: reason", for the error number given.
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

// Writes all of the bytes where the file stands. Returns 0, or the error number.
[[nodiscard]] int write_all(int descriptor, std::string_view bytes);

// Until what was written, and the entries of the folder that holds the path, lie on the disk. Throws as cannot_write.
void sync_file(int descriptor, const std::string& path);
void sync_folder_of(const std::string& path);

// Gives a file that is complete under `temporary` its name, for good.
void put_in_place(const std::string& temporary, const std::string& path);

}  // namespace poinsot::document
