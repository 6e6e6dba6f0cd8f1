#include "streams.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <string>

#include "exit_codes.h"
#include "poinsot/rendering.h"

namespace {

extern "C" void on_interrupt(int /*signal*/) {
  constexpr std::string_view message = "\npoinsot: interrupted\n";
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, message.data(), message.size());
  _exit(exit_interrupted);
}

std::atomic<bool> interrupt_noted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set no other");

extern "C" void note_interrupt(int signal) {
  if (interrupt_noted.exchange(true)) on_interrupt(signal);
}

// A signal that the caller of the program has set to be ignored stays ignored.
void handle(int signal, void (*handler)(int)) {
  struct sigaction before {};
  if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) return;
  struct sigaction now {};
  now.sa_handler = handler;
  now.sa_flags = SA_RESTART;
  sigaction(signal, &now, nullptr);
}

// Writes everything; the error number if that fails.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written >= 0) {
      text.remove_prefix(static_cast<std::size_t>(written));
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

bool environment_has(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

// A line, with its end, in several lines that are no longer than the columns; what follows stands below the second of
// two columns of text, or set in.
std::string broken_line(const std::string& line, std::size_t columns, Lines lines) {
  constexpr std::size_t of_answers = 7, most_hanging = 32;
  const std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
  const bool deep = indent >= of_answers;
  if ((deep && lines == Lines::of_answers) || line.starts_with("To give values")) return line;
  std::size_t width = 0, hanging = deep ? indent : indent + 3, last_blank = 0, width_there = 0;
  bool told = false;
  std::string result;
  for (std::size_t i = 0; i < line.size(); ++i) {
    // Colors take no room, nor do the further bytes of a letter.
    if (line[i] == '\x1b') {
      const std::size_t end = std::min(line.find('m', i), line.size() - 1);
      result += line.substr(i, end + 1 - i);
      i = end;
      continue;
    }
    const bool letter = (static_cast<unsigned char>(line[i]) & 0xC0U) != 0x80U;
    if (!told && i > indent && line[i] != ' ' && line[i - 1] == ' ' && i > 1 && line[i - 2] == ' ' &&
        width <= most_hanging) {
      hanging = width;
      told = true;
    }
    if (letter && line[i] != '\n' && width >= columns && last_blank > 0) {
      std::size_t end = last_blank;
      while (end > 0 && result[end - 1] == ' ') --end;
      result.replace(end, last_blank + 1 - end, "\n" + std::string(hanging, ' '));
      width = width - width_there - 1 + hanging;
      last_blank = 0;
    }
    if (line[i] == ' ' && width > hanging) {
      last_blank = result.size();
      width_there = width;
    }
    result += line[i];
    width += letter ? 1 : 0;
  }
  return result;
}

}  // namespace

void prepare_streams() {
  // A place-holder is opened the wrong way round, so that using the closed stream still fails.
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) != -1 || errno != EBADF) continue;
    const int placed = open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    if (placed != -1 && placed != descriptor) close(placed);
  }
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  handle(SIGINT, on_interrupt);
}

InterruptCatcher::InterruptCatcher(Signals signals) : signals_(signals) {
  handle(SIGINT, note_interrupt);
  if (signals_ == Signals::interrupt) return;
  handle(SIGTERM, note_interrupt);
  handle(SIGHUP, note_interrupt);
}

InterruptCatcher::~InterruptCatcher() {
  handle(SIGINT, on_interrupt);
  if (signals_ == Signals::interrupt) return;
  handle(SIGTERM, SIG_DFL);
  handle(SIGHUP, SIG_DFL);
}

const std::atomic<bool>& interrupt_flag() { return interrupt_noted; }

bool write_answer(std::string_view text) {
  const int error = write_all(STDOUT_FILENO, text);
  if (error == EPIPE) return false;
  if (error != 0) throw OutputError(fmt::format("cannot write to standard output: {}", std::strerror(error)));
  return true;
}

void write_message(std::string_view text) {
  std::string lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines += poinsot::printable(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  // Nowhere is left to report that standard error fails.
  static_cast<void>(write_all(STDERR_FILENO, lines));
}

void write_on_terminal(std::string_view text) { static_cast<void>(write_all(STDERR_FILENO, text)); }

std::size_t terminal_columns(int descriptor) {
  struct winsize size {};
  return isatty(descriptor) == 1 && ioctl(descriptor, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
}

std::string fitted_to_terminal(const std::string& text, Lines lines) {
  const std::size_t columns = terminal_columns(STDOUT_FILENO);
  constexpr std::size_t least_columns = 40;
  if (columns < least_columns) return text;
  std::string fitted;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1);
    fitted += broken_line(text.substr(begin, end + 1 - begin), columns, lines);
    begin = end + 1;
  }
  return fitted;
}

bool wants_color() {
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  return isatty(STDOUT_FILENO) == 1 && !dumb && !environment_has("NO_COLOR");
}
