// Turns a report's page into a PDF with WeasyPrint (Debian package weasyprint), in a process of its
// own: no shell, no network, no file but fonts, a limit on time and memory. The same page and the
// same date give the same bytes on the same machine.
//
//     page --(socket)--> python3 -I -c (script below) --(pipe)--> PDF
//
// WeasyPrint's own command would fetch what a page names; the script hands it a fetcher that
// refuses everything, and asks for a tagged PDF (PDF/UA-1).
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <set>
#include <string>

#include <sys/types.h>

#include "sim/base/result.h"

namespace app {

struct PdfLimits {
  std::chrono::milliseconds time{30'000};
  std::size_t memory = std::size_t{2} << 30;  // bytes of address space
  std::size_t at_once = 2;
  std::size_t waiting = 6;                                    // callers; more are told to come back
  std::filesystem::path program = "/usr/bin/weasyprint";      // says which Python it runs on
};

class PdfPrinter {
 public:
  explicit PdfPrinter(PdfLimits limits = {});
  ~PdfPrinter();  // stops
  PdfPrinter(const PdfPrinter&) = delete;
  PdfPrinter& operator=(const PdfPrinter&) = delete;

  // `date`: what the PDF says it was made at, seconds since 1970. Fails with unavailable, saying
  // what to do: WeasyPrint is not there, too many wait, the time or the memory was not enough.
  // May be called from several threads, each of which waits for its own.
  base::Result<std::string> print(const std::string& html, std::int64_t date);

  // Kills what runs; what waits and what comes later is refused.
  void stop();

 private:
  base::Status wait_for_place();
  void give_place_back();
  base::Result<std::string> run(const std::string& interpreter, const std::string& html,
                                std::int64_t date);

  const PdfLimits limits_;
  std::mutex mutex_;
  std::condition_variable place_free_;
  std::size_t waiting_ = 0, places_taken_ = 0;
  bool stopped_ = false;
  std::set<pid_t> running_;  // killed by stop() only while they are in here, not yet reaped
};

}  // namespace app
