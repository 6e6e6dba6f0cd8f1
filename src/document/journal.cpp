#include "document/journal.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cerrno>
#include <cstring>
#include <stdexcept>

#include "document/bytes.h"
#include "document/recording.h"

namespace poinsot::document {
namespace {

constexpr std::string_view magic = "poinsot journal\n";
constexpr std::size_t length_bytes = 4, checksum_bytes = 4;

std::uint32_t crc32(std::string_view bytes) {
  boost::crc_32_type sum;
  sum.process_bytes(bytes.data(), bytes.size());
  return sum.checksum();
}

std::string framed(std::string_view payload) {
  if (payload.size() > Journal::most_bytes) throw std::length_error("a record of a journal is too long");
  ByteWriter length;
  length.u32(static_cast<std::uint32_t>(payload.size()));
  std::string record = length.bytes();
  record += payload;
  ByteWriter checksum;
  checksum.u32(crc32(record));
  return record + checksum.bytes();
}

// Reads up to `count` bytes, or as many as there are.
std::string read_at(int file, std::uint64_t offset, std::uint64_t count, const std::string& path) {
  std::string bytes(count, '\0');
  std::size_t have = 0;
  while (have < count) {
    const ssize_t got = pread(file, bytes.data() + have, count - have, static_cast<off_t>(offset + have));
    if (got == 0) break;
    if (got > 0)
      have += static_cast<std::size_t>(got);
    else if (errno != EINTR)
      throw RecordingError(RecordingError::Fault::machine, "cannot read " + path + ": " + std::strerror(errno));
  }
  bytes.resize(have);
  return bytes;
}

Descriptor open_journal(const std::string& path) {
  const auto refuse = [&](const std::string& why) {
    throw RecordingError(RecordingError::Fault::caller, "cannot record to " + path + ": " + why);
  };
  Descriptor file(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666));
  if (file.number() < 0) refuse(std::strerror(errno));
  struct stat status {};
  if (fstat(file.number(), &status) != 0 || !S_ISREG(status.st_mode)) refuse("it is no file");
  if (flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) refuse("another run is recording to it");
  return file;
}

}  // namespace

Journal::Journal(const std::string& path) : path_(path), file_(open_journal(path)) {}

std::uint64_t Journal::size() const {
  struct stat status {};
  if (fstat(file_.number(), &status) != 0) cannot_write(path_, errno);
  return static_cast<std::uint64_t>(status.st_size);
}

std::optional<std::string> Journal::record_at(std::uint64_t offset) const {
  const std::string length = read_at(file_.number(), offset, length_bytes, path_);
  if (length.size() < length_bytes) return std::nullopt;
  const std::uint64_t payload = ByteReader(length).u32();
  const std::uint64_t whole = length_bytes + payload + checksum_bytes;
  if (payload > most_bytes || offset + whole > size()) return std::nullopt;
  std::string record = read_at(file_.number(), offset, whole, path_);
  if (record.size() < whole) return std::nullopt;
  const std::string_view seen(record);
  if (ByteReader(seen.substr(length_bytes + payload)).u32() != crc32(seen.substr(0, length_bytes + payload)))
    return std::nullopt;
  return record.substr(length_bytes, payload);
}

std::optional<std::string> Journal::head() const {
  if (read_at(file_.number(), 0, magic.size(), path_) != magic) return std::nullopt;
  return record_at(magic.size());
}

bool Journal::is_torn_beginning_of(std::string_view head) const {
  const std::string whole = std::string(magic) + framed(head);
  const std::string found = read_at(file_.number(), 0, whole.size() + 1, path_);
  if (found.size() > whole.size()) return false;
  const auto differs = std::mismatch(found.begin(), found.end(), whole.begin()).first;
  return std::all_of(differs, found.end(), [](char c) { return c == '\0'; });
}

void Journal::begin(std::string_view head) {
  if (ftruncate(file_.number(), 0) != 0) cannot_write(path_, errno);
  const std::string beginning = std::string(magic) + framed(head);
  lseek(file_.number(), 0, SEEK_SET);
  if (const int error = write_all(file_.number(), beginning)) cannot_write(path_, error);
  end_ = beginning.size();
  sync_file(file_.number(), path_);
  sync_folder_of(path_);
}

void Journal::read(const std::function<void(std::string_view payload)>& visit) {
  const std::optional<std::string> first = head();
  if (!first) return;
  end_ = magic.size() + length_bytes + first->size() + checksum_bytes;
  while (const std::optional<std::string> payload = record_at(end_)) {
    visit(*payload);
    end_ += length_bytes + payload->size() + checksum_bytes;
  }
}

std::uint64_t Journal::cut_torn_end() {
  const std::uint64_t all = size();
  if (all == end_) return 0;
  if (ftruncate(file_.number(), static_cast<off_t>(end_)) != 0) cannot_write(path_, errno);
  return all - end_;
}

void Journal::append(std::string_view payload) {
  const std::string record = framed(payload);
  lseek(file_.number(), static_cast<off_t>(end_), SEEK_SET);
  if (const int error = write_all(file_.number(), record)) {
    // The next run would cut off an incomplete record. It is cut off at once.
    [[maybe_unused]] const int ignored = ftruncate(file_.number(), static_cast<off_t>(end_));
    cannot_write(path_, error);
  }
  end_ += record.size();
}

void Journal::sync() {
  while (fdatasync(file_.number()) != 0)
    if (errno != EINTR) cannot_write(path_, errno);
}

}  // namespace poinsot::document
