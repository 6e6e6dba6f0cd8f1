#include "document/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <set>

#include "document/data_file.h"
#include "document/file_output.h"
#include "document/journal.h"
#include "document/program_version.h"
#include "document/recording_records.h"
#include "poinsot/engine/work/budget.h"
#include "problem/answers/recorded_motion.h"
#include "problem/entries/read_meshes.h"

namespace poinsot::document {
namespace {

namespace fs = std::filesystem;
using problem::RecordedMotion;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t most_numbers = 1'000'000'000;  // 8 GB
constexpr std::chrono::milliseconds between_syncs{100};
constexpr std::size_t numbers_at_once = 65'536;  // written to the data file

[[noreturn]] void refuse(const std::string& message) { throw RecordingError(RecordingError::Fault::caller, message); }

bool is_hdf5(const std::string& output) { return output.ends_with(".h5") || output.ends_with(".hdf5"); }

void check_output(const std::string& output, bool replace) {
  if (!output.ends_with(".csv") && !is_hdf5(output))
    refuse("cannot record to '" + output + "': its name ends in neither .csv nor .h5, which tells the format");
  std::error_code error;
  if (fs::is_directory(output, error)) refuse("cannot record to " + output + ": it is a folder; name a file in it");
  const fs::path folder = fs::path(output).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error))
    refuse("cannot record to " + output + ": there is no folder " + folder.string());
  const std::string journal = output + ".journal";
  const bool has_journal = fs::is_regular_file(journal, error) && fs::file_size(journal, error) > 0;
  if (!replace && !has_journal && fs::is_regular_file(output, error))
    refuse(output +
           " is not overwritten: without a journal beside it, it is no recording of this program; move it "
           "away, record to another file, or add --force");
}

// The meshes of a statement, each file once, in the order of the statement.
std::vector<RecordingHead::Mesh> meshes_of(const problem::Statement& stated) {
  std::vector<RecordingHead::Mesh> meshes;
  std::set<std::string> known;
  for (const problem::Situation& situation : stated.situations)
    for (const problem::Body& body : situation.bodies)
      for (const std::vector<problem::Part>* parts : {&body.parts, &body.added})
        for (const problem::Part& part : *parts) {
          if (!part.shape.mesh || !known.insert(part.shape.file).second) continue;
          const std::string& bytes = *part.shape.mesh->bytes;
          meshes.push_back({fs::path(part.shape.file).filename().string(), bytes.size(), crc64(bytes)});
        }
  return meshes;
}

RecordingHead head_for(const problem::Statement& stated, const std::string& text, const RecordedMotion& motion,
                       const Settings& settings) {
  RecordingHead head;
  head.program = fmt::format("poinsot {}", program_version());
  head.title = stated.title;
  head.problem = text;
  const std::map<std::string, std::string> sets = [&] {
    std::map<std::string, std::string> last;
    for (const auto& [name, value] : settings) last[name] = value;
    return last;
  }();
  head.sets.assign(sets.begin(), sets.end());
  head.meshes = meshes_of(stated);
  head.every = motion.every();
  head.rows = motion.rows();
  head.block_rows = motion.block_rows();
  for (const problem::RecordedColumn& column : motion.columns())
    head.columns.push_back({column.name, column.unit.text, column.unit.factor});
  return head;
}

// One recording from its start, or from where its journal stops, to its end.
class Recorder {
 public:
  Recorder(RecordingHead head, RecordedMotion motion, const std::string& output)
      : head_(std::move(head)), motion_(std::move(motion)), journal_(output + ".journal"), next_(motion_.start()) {
    result_.data = output;
    result_.journal = journal_.path();
    result_.columns = head_.columns.size();
    check_size(head_.rows.value_or(0));
    take_up();
  }

  Recording go() {
    report();
    try {
      record_blocks();
      sync();
      report();
    } catch (...) {
      // What there is can be had all the same; what went wrong is told, whatever becomes of that.
      const BudgetRespite respite;
      try {
        write_data();
      } catch (const std::exception&) {
      }
      throw;
    }
    result_.complete = !next_;
    const BudgetRespite respite;
    write_data();
    return result_;
  }

 private:
  void check_size(std::uint64_t rows) const {
    if (rows > most_numbers / head_.columns.size())
      refuse(
          fmt::format("the recording would have more than {} numbers ({} columns): record for a shorter time, or less "
                      "often",
                      most_numbers, head_.columns.size()));
  }

  void take_up() {
    const std::string head = to_bytes(head_);
    const std::string advice = ": move it away, or record to another file";
    if (const std::optional<std::string> found = journal_.head()) {
      if (*found != head) refuse(journal_.path() + " is not overwritten, " + other(*found) + advice);
    } else if (journal_.is_torn_beginning_of(head)) {
      journal_.begin(head);
    } else {
      refuse(journal_.path() + " is not overwritten: it is no journal of a recording" + advice);
    }
    journal_.read([&](std::string_view bytes) {
      check_budget();
      count(damage_told(bytes));
    });
    result_.torn_bytes = journal_.cut_torn_end();
    safe_rows_ = result_.resumed_at = result_.rows;
  }

  std::string other(const std::string& head) const {
    try {
      return difference(head_of(head), head_);
    } catch (const std::out_of_range&) {
      return "it holds a recording by another version of poinsot";
    }
  }

  RecordingBlock damage_told(std::string_view bytes) const {
    try {
      RecordingBlock record = block_of(bytes);
      if (next_ && record.first_row == result_.rows && record.block.values.size() % result_.columns == 0) return record;
    } catch (const std::out_of_range&) {
    }
    refuse(journal_.path() + " is damaged behind row " + std::to_string(result_.rows) +
           ": move it away and record anew");
  }

  // A block that stands in the journal.
  void count(const RecordingBlock& record) {
    const problem::RecordedBlock& block = record.block;
    result_.rows += block.values.size() / result_.columns;
    result_.notes.insert(result_.notes.end(), block.notes.begin(), block.notes.end());
    checks_.momentum = std::max(checks_.momentum, block.checks.momentum);
    checks_.energy = std::max(checks_.energy, block.checks.energy);
    checks_.newton_euler = std::max(checks_.newton_euler, block.checks.newton_euler);
    checks_.energy_drift += block.checks.energy_drift;
    next_ = block.next;
  }

  // Until the end of the motion or of the budget; then a block that was begun is left out.
  void record_blocks() {
    try {
      while (next_) {
        check_budget();
        record_block();
      }
    } catch (const BudgetEnded&) {
    }
  }

  void record_block() {
    const RecordingBlock record{result_.rows, motion_.block(result_.rows, *next_)};
    check_size(result_.rows + record.block.values.size() / result_.columns);
    try {
      journal_.append(to_bytes(record));
    } catch (const RecordingError& error) {
      throw RecordingError(error.fault(), std::string(error.what()) + "; the same call goes on from what stands there");
    }
    count(record);
    if (Clock::now() - synced_ >= between_syncs) sync();
    report();
  }

  // What is reported is on the disk.
  void sync() {
    journal_.sync();
    synced_ = Clock::now();
    safe_rows_ = result_.rows;
  }

  void report() const {
    std::optional<double> part;
    if (head_.rows)
      part = static_cast<double>(safe_rows_) / static_cast<double>(std::max<std::uint64_t>(*head_.rows, 1));
    progress_.tell(part, safe_rows_);
  }

  void write_data() {
    if (result_.rows > 0) result_.end = head_.every * static_cast<double>(result_.rows - 1);
    const DataHead about{head_, result_.rows, result_.complete, checks_, result_.notes};
    const std::string temporary = result_.data + ".part";
    try {
      const std::unique_ptr<DataFile> file =
          is_hdf5(result_.data) ? make_hdf5_file(temporary, about) : make_csv_file(temporary, about);
      std::vector<double> values;
      journal_.read([&](std::string_view bytes) {
        const std::vector<double> more = block_of(bytes).block.values;
        values.insert(values.end(), more.begin(), more.end());
        if (values.size() < numbers_at_once) return;
        file->add(values);
        values.clear();
      });
      file->add(values);
      file->finish();
      put_in_place(temporary, result_.data);
    } catch (const RecordingError& error) {
      std::remove(temporary.c_str());
      throw RecordingError(error.fault(), std::string(error.what()) + "; the recording is safe in " + result_.journal +
                                              ", and the same call writes the data file from it");
    }
  }

  RecordingHead head_;
  RecordedMotion motion_;
  Journal journal_;
  std::optional<problem::RecordedState> next_;  // none once the journal holds all
  problem::RecordedChecks checks_;
  Clock::time_point synced_ = Clock::now();
  std::uint64_t safe_rows_ = 0;  // on the disk
  Recording result_;
  const ProgressTeller progress_{"recording"};
};

}  // namespace

Recording record_motion(const problem::Statement& stated, const std::string& text, const std::string& output,
                        const RecordOptions& options) {
  check_output(output, options.replace);
  try {
    RecordedMotion motion(stated, options.sets);
    RecordingHead head = head_for(stated, text, motion, options.sets);
    return Recorder(std::move(head), std::move(motion), output).go();
  } catch (const problem::UnansweredRecord& unanswered) {
    throw RecordingError(RecordingError::Fault::problem, unanswered.what());
  }
}

}  // namespace poinsot::document
