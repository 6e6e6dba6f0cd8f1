#include <fcntl.h>
#include <hdf5.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "document/data_file.h"
#include "document/file_output.h"
#include "document/recording.h"

namespace poinsot::document {
namespace {

// An object of the HDF5 library that is closed with this one.
class Handle {
 public:
  Handle(hid_t id, herr_t (*closer)(hid_t)) : id_(id), close_(closer) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  hid_t operator*() const { return id_; }
  // Returns false if something could not be written.
  [[nodiscard]] bool close() { return close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

herr_t note_deepest(unsigned depth, const H5E_error2_t* error, void* text) {
  if (depth == 0 && error->desc) *static_cast<std::string*>(text) = error->desc;
  return 0;
}

class Hdf5File : public DataFile {
 public:
  Hdf5File(const std::string& path, const DataHead& head) : path_(path), rows_(head.rows), file_(create(path)) {
    write_text(*file_, "title", head.recording.title);
    write_text(*file_, "program", head.recording.program);
    write_text(*file_, "problem_crc64", problem_hash(head.recording));
    std::string settings, notes;
    for (const auto& [name, value] : head.recording.sets)
      settings += (settings.empty() ? "" : "\n") + name + "=" + value;
    for (const std::string& note : head.notes) notes += (notes.empty() ? "" : "\n") + note;
    write_text(*file_, "settings", settings);
    write_text(*file_, "notes", notes);
    write_scalar(*file_, "complete", H5T_STD_I8LE, H5T_NATIVE_INT, head.complete ? 1 : 0);
    write_scalar(*file_, "check_momentum", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, head.checks.momentum);
    write_scalar(*file_, "check_energy", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, head.checks.energy);
    write_scalar(*file_, "check_newton_euler", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, head.checks.newton_euler);
    write_scalar(*file_, "check_energy_drift", H5T_IEEE_F64LE, H5T_NATIVE_DOUBLE, head.checks.energy_drift);

    // Data sets do not record when they were made, so that equal recordings are equal files.
    const Handle properties = checked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    check(H5Pset_obj_track_times(*properties, 0));
    const hsize_t size = rows_;
    const Handle space = checked(H5Screate_simple(1, &size, nullptr), H5Sclose);
    for (const RecordingHead::Column& column : head.recording.columns) {
      sets_.push_back(checked(
          H5Dcreate2(*file_, column.name.c_str(), H5T_IEEE_F64LE, *space, H5P_DEFAULT, *properties, H5P_DEFAULT),
          H5Dclose));
      write_text(*sets_.back(), "unit", column.unit);
      factors_.push_back(column.factor);
    }
  }

  void add(std::span<const double> values) override {
    const hsize_t count = values.size() / factors_.size();
    if (count == 0) return;
    const Handle here = checked(H5Screate_simple(1, &count, nullptr), H5Sclose);
    std::vector<double> numbers(count);
    for (std::size_t column = 0; column < factors_.size(); ++column) {
      for (std::size_t row = 0; row < count; ++row)
        numbers[row] = values[row * factors_.size() + column] / factors_[column];
      const Handle there = checked(H5Dget_space(*sets_[column]), H5Sclose);
      check(H5Sselect_hyperslab(*there, H5S_SELECT_SET, &written_, nullptr, &count, nullptr));
      check(H5Dwrite(*sets_[column], H5T_NATIVE_DOUBLE, *here, *there, H5P_DEFAULT, numbers.data()));
    }
    written_ += count;
  }

  void finish() override {
    for (Handle& set : sets_) check(set.close() ? 0 : -1);
    check(file_.close() ? 0 : -1);
    const Descriptor file(open(path_.c_str(), O_RDWR | O_CLOEXEC));
    if (file.number() < 0) cannot_write(path_, errno);
    sync_file(file.number(), path_);
  }

 private:
  Handle create(const std::string& path) {
    // Errors are reported by this program and not by the library, which must not try again at exit to close a file
    // either.
    H5dont_atexit();
    H5open();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    const Handle properties = checked(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    check(H5Pset_obj_track_times(*properties, 0));
    check(H5Pset_link_creation_order(*properties, H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED));
    return checked(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, *properties, H5P_DEFAULT), H5Fclose);
  }

  void check(herr_t outcome) const {
    if (outcome >= 0) return;
    const int error = errno;
    if (error == ENOSPC || error == EDQUOT || error == EFBIG || error == EIO || error == EACCES)
      cannot_write(path_, error);
    std::string reason = "the HDF5 library gives no reason";
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, note_deepest, &reason);
    throw RecordingError(RecordingError::Fault::machine, "cannot write " + path_ + ": " + reason);
  }
  Handle checked(hid_t id, herr_t (*close)(hid_t)) const {
    check(id >= 0 ? 0 : -1);
    return {id, close};
  }

  void write_text(hid_t owner, const char* name, const std::string& text) const {
    const Handle type = checked(H5Tcopy(H5T_C_S1), H5Tclose);
    check(H5Tset_cset(*type, H5T_CSET_UTF8));
    check(H5Tset_strpad(*type, H5T_STR_NULLPAD));
    // An attribute holds less than 64 kB, and a text has at least one byte.
    constexpr std::size_t most = 60'000;
    std::string padded = text.substr(0, most);
    if (padded.empty()) padded.push_back('\0');
    check(H5Tset_size(*type, padded.size()));
    write_attribute(owner, name, *type, *type, padded.data());
  }
  template <class Number>
  void write_scalar(hid_t owner, const char* name, hid_t stored, hid_t given, Number number) const {
    write_attribute(owner, name, stored, given, &number);
  }
  void write_attribute(hid_t owner, const char* name, hid_t stored, hid_t given, const void* value) const {
    const Handle space = checked(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle attribute = checked(H5Acreate2(owner, name, stored, *space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    check(H5Awrite(*attribute, given, value));
  }

  std::string path_;
  hsize_t rows_;
  hsize_t written_ = 0;
  Handle file_;
  std::vector<Handle> sets_;
  std::vector<double> factors_;
};

}  // namespace

std::unique_ptr<DataFile> make_hdf5_file(const std::string& path, const DataHead& head) {
  return std::make_unique<Hdf5File>(path, head);
}

}  // namespace poinsot::document
