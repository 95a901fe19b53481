// The text messages of the live channel: what a browser may send, and what it is told.
#pragma once

#include <string>
#include <variant>

#include "app/session/live_trial.h"
#include "sim/base/result.h"

namespace app {

enum class LiveControl { pause, resume, end };
struct LivePing {
  double sent_ms = 0.0;
};
using ClientMessage = std::variant<LiveCommand, LiveControl, LivePing>;

// Strict: one JSON object of a known type, with its fields and no others, each in its range.
base::Result<ClientMessage> read_client_message(const std::string& text);

std::string error_notice(const std::string& message);
std::string second_tab_notice();
std::string pong_notice(double sent_ms);
std::string finished_notice(const std::string& trial_id, bool practice);

}  // namespace app
