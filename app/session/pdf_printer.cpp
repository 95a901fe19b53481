#include "app/session/pdf_printer.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLargestPdf = std::size_t{64} << 20;  // bytes
constexpr std::size_t kKeptComplaint = 4000;                // bytes of what it says on its way
constexpr int kNotInstalled = 3;                            // exit codes of the script
constexpr int kOutOfMemory = 4;

// Arguments: bytes of memory, seconds of processor time.
constexpr const char* kScript = R"py(
import ctypes, resource, sys
ctypes.CDLL(None).prctl(1, 9)  # PR_SET_PDEATHSIG: killed with the program that asked
for kind, limit in ((resource.RLIMIT_AS, int(sys.argv[1])), (resource.RLIMIT_CPU, int(sys.argv[2])),
                    (resource.RLIMIT_CORE, 0), (resource.RLIMIT_FSIZE, 0)):
    resource.setrlimit(kind, (limit, limit))
try:
    import weasyprint
except ImportError:
    sys.exit(3)
def refuse(url, *rest, **named):
    raise ValueError('a report loads nothing: ' + url[:80])
try:
    page = sys.stdin.buffer.read().decode('utf-8', 'replace')
    pdf = weasyprint.HTML(string=page, base_url='about:blank', url_fetcher=refuse).write_pdf(
        variant='pdf/ua-1')
except MemoryError:
    sys.exit(4)
sys.stdout.buffer.write(pdf)
)py";

base::Error unavailable(const std::string& sentence) {
  return {base::ErrorCode::unavailable, sentence};
}

base::Error not_installed() {
  return unavailable(
      "PDF needs WeasyPrint, which is not installed; install the Debian package weasyprint, or take "
      "the report as HTML.");
}

// A descriptor that is closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }
  void set(int number) {
    close();
    number_ = number;
  }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

// Two ends of a channel, neither of which other children inherit. A socket, because writing to one
// whose reader is gone can be told not to raise SIGPIPE.
bool open_channel(Descriptor& ours, Descriptor& theirs) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return false;
  ours.set(ends[0]);
  theirs.set(ends[1]);
  return fcntl(ends[0], F_SETFL, O_NONBLOCK) == 0;
}

// "#!/usr/bin/python3" of the installed program; empty when it is not there.
std::string interpreter_of(const std::filesystem::path& program) {
  std::string line;
  std::ifstream file(program);
  if (!std::getline(file, line) || !line.starts_with("#!/")) return {};
  return line.substr(2, line.find(' ') - 2);
}

struct Channels {
  Descriptor page, page_end, pdf, pdf_end, complaints, complaints_end;  // *_end: the child's
};

// The process, or 0 when it could not be started.
pid_t start(const std::string& interpreter, const Channels& channels,
            const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
  std::vector<char*> argv, envp;
  for (const std::string& text : arguments) argv.push_back(const_cast<char*>(text.c_str()));
  for (const std::string& text : environment) envp.push_back(const_cast<char*>(text.c_str()));
  argv.push_back(nullptr);
  envp.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, channels.page_end.get(), 0);
  posix_spawn_file_actions_adddup2(&actions, channels.pdf_end.get(), 1);
  posix_spawn_file_actions_adddup2(&actions, channels.complaints_end.get(), 2);
  posix_spawn_file_actions_addclosefrom_np(&actions, 3);  // no socket and no database of ours
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, usual;
  sigemptyset(&none);
  sigemptyset(&usual);
  sigaddset(&usual, SIGPIPE);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &usual);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  pid_t child = 0;
  const int failed =
      posix_spawn(&child, interpreter.c_str(), &actions, &attributes, argv.data(), envp.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return failed == 0 ? child : 0;
}

// Reads what is there; closes the channel at its end.
void drain(Descriptor& from, std::string& into, std::size_t limit) {
  std::array<char, 65536> bytes;
  const ssize_t count = ::read(from.get(), bytes.data(), bytes.size());
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (count <= 0) return from.close();
  if (into.size() < limit) into.append(bytes.data(), static_cast<std::size_t>(count));
}

struct Heard {
  std::string pdf, complaints;
  bool in_time = true;
};

// Gives the page and takes the PDF until the child has closed its ends or the time is over.
Heard converse(Channels& channels, const std::string& html, Clock::time_point deadline) {
  Heard heard;
  std::size_t given = 0;
  while (channels.pdf.get() >= 0 || channels.complaints.get() >= 0) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    heard.in_time = left.count() > 0 && heard.pdf.size() <= kLargestPdf;
    if (!heard.in_time) break;
    std::array<pollfd, 3> waits{{{channels.page.get(), POLLOUT, 0},
                                 {channels.pdf.get(), POLLIN, 0},
                                 {channels.complaints.get(), POLLIN, 0}}};
    poll(waits.data(), waits.size(), static_cast<int>(left.count()));  // skips closed ones (-1)
    if (waits[0].revents != 0) {
      const ssize_t count =
          send(channels.page.get(), html.data() + given, html.size() - given, MSG_NOSIGNAL);
      if (count > 0) given += static_cast<std::size_t>(count);
      const bool broken = count < 0 && errno != EAGAIN && errno != EINTR;
      if (broken || given == html.size()) channels.page.close();
    }
    if (waits[1].revents != 0) drain(channels.pdf, heard.pdf, kLargestPdf + 1);
    if (waits[2].revents != 0) drain(channels.complaints, heard.complaints, kKeptComplaint);
  }
  return heard;
}

}  // namespace

PdfPrinter::PdfPrinter(PdfLimits limits) : limits_(std::move(limits)) {}

PdfPrinter::~PdfPrinter() { stop(); }

base::Result<std::string> PdfPrinter::print(const std::string& html, std::int64_t date) {
  const std::string interpreter = interpreter_of(limits_.program);
  if (interpreter.empty()) return not_installed();
  if (const auto place = wait_for_place(); !place) return place.error();
  auto pdf = run(interpreter, html, date);
  give_place_back();
  return pdf;
}

void PdfPrinter::stop() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  for (const pid_t child : running_) kill(child, SIGKILL);
  place_free_.notify_all();
}

base::Status PdfPrinter::wait_for_place() {
  std::unique_lock lock(mutex_);
  if (places_taken_ >= limits_.at_once && waiting_ >= limits_.waiting) {
    return unavailable("Many reports are being made just now; try again in a minute.");
  }
  ++waiting_;
  place_free_.wait(lock, [this] { return stopped_ || places_taken_ < limits_.at_once; });
  --waiting_;
  if (stopped_) return unavailable("The server is being stopped; try again when it is back.");
  ++places_taken_;
  return base::Done{};
}

void PdfPrinter::give_place_back() {
  const std::lock_guard lock(mutex_);
  --places_taken_;
  place_free_.notify_one();
}

base::Result<std::string> PdfPrinter::run(const std::string& interpreter, const std::string& html,
                                          std::int64_t date) {
  const auto deadline = Clock::now() + limits_.time;
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(limits_.time).count() + 1;
  Channels channels;
  if (!open_channel(channels.page, channels.page_end) ||
      !open_channel(channels.pdf, channels.pdf_end) ||
      !open_channel(channels.complaints, channels.complaints_end)) {
    return unavailable("The server has too many files open to make a PDF; try again in a minute.");
  }
  pid_t child = 0;
  {
    const std::lock_guard lock(mutex_);
    if (!stopped_) {
      // nothing of our own environment: the same bytes whoever runs the program
      child = start(interpreter, channels,
                    {interpreter, "-I", "-c", kScript, std::to_string(limits_.memory),
                     std::to_string(seconds)},
                    {"PATH=/usr/bin:/bin", "LANG=C.UTF-8", "HOME=/nonexistent", "PYTHONHASHSEED=0",
                     "SOURCE_DATE_EPOCH=" + std::to_string(date)});
    }
    if (child == 0) return not_installed();
    running_.insert(child);
  }
  channels.page_end.close();
  channels.pdf_end.close();
  channels.complaints_end.close();
  const Heard heard = converse(channels, html, deadline);

  int status = 0;
  {
    const std::lock_guard lock(mutex_);  // so that stop() never kills a number used again
    kill(child, SIGKILL);                // it has closed its output, or has had its time
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    running_.erase(child);
    if (stopped_) return unavailable("The server is being stopped; try again when it is back.");
  }
  if (!heard.in_time) {
    return unavailable("This report took longer than " + std::to_string(seconds - 1) +
                       " s to print; take it as HTML and print that from the browser.");
  }
  if (heard.pdf.starts_with("%PDF-")) return heard.pdf;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (code == kNotInstalled) return not_installed();
  if (code == kOutOfMemory) {
    return unavailable(
        "This report needs more memory than a PDF may take; take it as HTML and print that from "
        "the browser.");
  }
  const std::size_t last = heard.complaints.find_last_not_of('\n');
  const std::size_t begin = heard.complaints.find_last_of('\n', last);
  return unavailable("WeasyPrint could not make this PDF (" +
                     heard.complaints.substr(begin == std::string::npos ? 0 : begin + 1,
                                             last - begin) +
                     "); take the report as HTML.");
}

}  // namespace app
