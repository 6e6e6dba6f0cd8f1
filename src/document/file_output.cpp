#include "document/file_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "document/recording.h"

namespace poinsot::document {

void cannot_write(const std::string& path, int error) {
  throw RecordingError(RecordingError::Fault::machine, "cannot write " + path + ": " + std::strerror(error));
}

Descriptor::Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(number_, other.number_);
  return *this;
}

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

int write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = write(descriptor, bytes.data(), bytes.size());
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      return errno;
  }
  return 0;
}

void sync_file(int descriptor, const std::string& path) {
  while (fsync(descriptor) != 0)
    if (errno != EINTR) cannot_write(path, errno);
}

void sync_folder_of(const std::string& path) {
  const std::filesystem::path parent = std::filesystem::path(path).parent_path();
  const std::string folder = parent.empty() ? "." : parent.string();
  const Descriptor opened(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  // Some file systems cannot sync folders and report this.
  if (opened.number() < 0 || (fsync(opened.number()) != 0 && errno != EINVAL && errno != ENOTSUP && errno != EINTR))
    cannot_write(folder, errno);
}

void put_in_place(const std::string& temporary, const std::string& path) {
  if (std::rename(temporary.c_str(), path.c_str()) != 0) cannot_write(path, errno);
  sync_folder_of(path);
}

}  // namespace poinsot::document
