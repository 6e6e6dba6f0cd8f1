// poinsot report FOLDER: an index and a page for each problem file, with script and style beside them.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>

#include "exit_codes.h"
#include "output_file.h"
#include "poinsot/pictures.h"
#include "progress_line.h"
#include "report.h"
#include "streams.h"

namespace {

namespace fs = std::filesystem;
using poinsot::Document;
using poinsot::GalleryEntry;

// The file system refuses.
struct WriteFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void write_or_fail(const fs::path& path, std::string_view text) {
  if (!write_file(path.string(), text))
    throw WriteFailure(fmt::format("cannot write {}: {}", path.string(), std::strerror(errno)));
}

// The name of a file as a gallery shows it: its path below the folder that was named, and with the folder where there
// are several.
std::string shown_name(const std::string& file, const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    const fs::path below = fs::path(file).lexically_relative(path);
    if (below.empty() || below == "." || *below.begin() == "..") continue;
    const fs::path folder = fs::path(path).lexically_normal();
    const fs::path name = folder.has_filename() ? folder.filename() : folder.parent_path().filename();
    return (paths.size() > 1 ? name / below : below).generic_string();
  }
  return fs::path(file).filename().generic_string();
}

// FOLDER/NAME.yaml has the page FOLDER-NAME.html.
std::string page_name(const std::string& shown) {
  std::string name = fs::path(shown).replace_extension(".html").generic_string();
  std::ranges::replace(name, '/', '-');
  return name;
}

// An address may hold any name of a file.
std::string address(const std::string& name) {
  std::string result;
  for (const char letter : name) {
    const auto byte = static_cast<unsigned char>(letter);
    const bool plain = byte < 128 && (std::isalnum(byte) != 0 || letter == '.' || letter == '-' || letter == '_');
    result += plain ? std::string(1, letter) : fmt::format("%{:02X}", byte);
  }
  return result;
}

// Makes the pages, by as many threads as there are processors.
class Gallery {
 public:
  explicit Gallery(const ReportArguments& arguments)
      : arguments_(arguments),
        folder_(arguments.output),
        files_(problem_files(arguments.paths)),
        entries_(files_.size()) {
    std::vector<std::string> names;
    for (const std::string& file : files_) {
      std::string name = page_name(shown_name(file, arguments.paths));
      while (std::ranges::find(names, name) != names.end() || name == "index.html") name.insert(0, "_");
      names.push_back(name);
    }
    names_ = std::move(names);
  }

  bool empty() const { return files_.empty(); }

  void make() {
    fs::create_directories(folder_);
    for (const poinsot::PageFile& file : poinsot::shared_page_files())
      write_or_fail(folder_ / file.name, file.contents);
    const unsigned count = std::max(1U, std::thread::hardware_concurrency());
    {
      std::vector<std::jthread> workers;
      for (unsigned i = 0; i < count; ++i) workers.emplace_back([this] { work(); });
    }
    if (shows_progress()) write_on_terminal("\r" + std::string(70, ' ') + "\r");
    write_index();
    if (failure_) throw WriteFailure(*failure_);
  }

  std::size_t made() const {
    return static_cast<std::size_t>(std::ranges::count_if(
        entries_, [](const std::optional<GalleryEntry>& entry) { return entry && !entry->page.empty(); }));
  }
  std::size_t size() const { return files_.size(); }

 private:
  static bool shows_progress() { return isatty(STDERR_FILENO) == 1; }

  void work() {
    for (std::size_t i = next_++; i < files_.size() && !interrupted(); i = next_++) {
      GalleryEntry entry = page_of(files_[i], names_[i]);
      const std::scoped_lock lock(guard_);
      entries_[i] = std::move(entry);
      ++done_;
      if (shows_progress()) write_on_terminal(fmt::format("\r{:70.70}", progress(files_[i])));
    }
  }

  std::string progress(const std::string& file) const {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    const double part = static_cast<double>(done_) / static_cast<double>(files_.size());
    return fmt::format("{} of {}{}  {}", done_, files_.size(), seconds < 1 ? "" : time_left(seconds, part), file);
  }

  GalleryEntry page_of(const std::string& file, const std::string& name) {
    GalleryEntry entry{.page = "", .figure = "", .title = "", .file = shown_name(file, arguments_.paths)};
    try {
      const ReadProblem read = read_problem(file);
      entry.title = read.problem.title();
      const Document document =
          read.problem.illustrate(arguments_.sets, poinsot::Budget().end_when(&interrupt_flag()), true);
      if (document.ended) {
        entry.note = "interrupted";
        return entry;
      }
      entry.kinds = poinsot::kinds_of(read.text, document);
      write_or_fail(folder_ / name,
                    to_html(read.problem, read.text, document, {.shared = "./", .gallery = "index.html"}));
      entry.page = address(name);
      if (!document.solutions.empty() && !poinsot::figures(document, 0).empty()) {
        const std::string picture = fs::path(name).replace_extension(".svg").string();
        write_or_fail(folder_ / picture, to_svg(document, 0));
        entry.figure = address(picture);
      }
    } catch (const WriteFailure& failure) {
      const std::scoped_lock lock(guard_);
      failure_ = failure.what();
      next_ = files_.size();
    } catch (const std::exception& error) {
      const std::string message = error.what();
      entry.note = message.substr(0, message.find('\n'));
    }
    return entry;
  }

  void write_index() {
    std::vector<GalleryEntry> shown;
    for (const std::optional<GalleryEntry>& entry : entries_)
      if (entry) shown.push_back(*entry);
    std::string title = "Problems";
    for (std::size_t i = 0; i < arguments_.paths.size(); ++i) {
      const fs::path path = fs::path(arguments_.paths[i]).lexically_normal();
      const fs::path name = path.has_filename() ? path.filename() : path.parent_path().filename();
      title += (i > 0 ? ", " : ": ") + name.string();
    }
    write_or_fail(folder_ / "index.html", poinsot::gallery_html(title, shown));
  }

  const ReportArguments& arguments_;
  fs::path folder_;
  std::vector<std::string> files_, names_;
  std::vector<std::optional<GalleryEntry>> entries_;
  std::atomic<std::size_t> next_{0};
  std::mutex guard_;
  std::size_t done_ = 0;
  const std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  std::optional<std::string> failure_;
};

}  // namespace

int gallery(const ReportArguments& arguments) {
  const auto refused = [](const std::string& reason) {
    write_message("poinsot: " + reason);
    return exit_wrong_input;
  };
  const fs::path folder(arguments.output);
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
    return refused(
        fmt::format("{} should be a folder: a gallery is an index and a page for each file", arguments.output));
  if (!arguments.force && fs::exists(folder, error) && !fs::is_empty(folder, error))
    return refused(fmt::format("{} is not empty, and nothing in it is overwritten: add --force, or name another folder",
                               arguments.output));
  for (const std::string& path : arguments.paths)
    if (!fs::exists(path, error)) return refused(fmt::format("{} does not exist", path));
  try {
    const InterruptCatcher catcher;
    Gallery pages(arguments);
    if (pages.empty()) return refused("there is no file *.yaml in the folders named");
    pages.make();
    const std::string index = (folder / "index.html").string();
    static_cast<void>(write_answer(fmt::format("{}: {} of {} pages\n", index, pages.made(), pages.size())));
    if (interrupted()) {
      write_message("poinsot: interrupted; the gallery has the pages made until then");
      return exit_interrupted;
    }
    return pages.made() == pages.size() ? exit_answered : exit_unanswered;
  } catch (const WriteFailure& failure) {
    write_message(fmt::format("poinsot: {}", failure.what()));
    return exit_internal;
  } catch (const fs::filesystem_error& failure) {
    write_message(fmt::format("poinsot: cannot write {}: {}", arguments.output, failure.code().message()));
    return exit_internal;
  }
}
