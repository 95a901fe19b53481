#include "app/server/views/live_message.h"

#include <cmath>
#include <initializer_list>
#include <string_view>

#include <nlohmann/json.hpp>

#include "sim/base/units.h"

namespace app {
namespace {

using nlohmann::json;
using namespace base::units;

base::Error refuse(const std::string& sentence) {
  return base::Error{base::ErrorCode::invalid_input, sentence};
}

base::Status only_fields(const json& message, std::initializer_list<std::string_view> names) {
  for (const auto& [name, value] : message.items()) {
    bool known = false;
    for (const std::string_view allowed : names) known = known || name == allowed;
    if (!known) return refuse("The message has a field its type does not have.");
  }
  return base::Done{};
}

// A finite number within +-limit.
base::Result<double> number(const json& message, const char* name, double limit, bool required) {
  const auto found = message.find(name);
  if (found == message.end()) {
    if (required) return refuse(std::string("The field ") + name + " is missing.");
    return 0.0;
  }
  if (!found->is_number()) return refuse(std::string("The field ") + name + " must be a number.");
  const double value = found->get<double>();
  if (!std::isfinite(value) || std::abs(value) > limit) {
    return refuse(std::string("The field ") + name + " is out of range.");
  }
  return value;
}

base::Result<ClientMessage> read_handle(const json& message) {
  const auto fields =
      only_fields(message, {"type", "feed_mm_s", "turn_deg_s", "move_mm", "rotate_deg"});
  if (!fields) return fields.error();
  const auto feed = number(message, "feed_mm_s", 200.0, true);
  if (!feed) return feed.error();
  const auto turn = number(message, "turn_deg_s", 1080.0, true);
  if (!turn) return turn.error();
  const auto move = number(message, "move_mm", 50.0, false);
  if (!move) return move.error();
  const auto rotate = number(message, "rotate_deg", 360.0, false);
  if (!rotate) return rotate.error();
  return ClientMessage{LiveCommand{*feed, *turn * 1.0_deg, *move, *rotate * 1.0_deg}};
}

base::Result<ClientMessage> read_ping(const json& message) {
  const auto fields = only_fields(message, {"type", "sent_ms"});
  if (!fields) return fields.error();
  const auto sent = number(message, "sent_ms", 1e15, true);
  if (!sent) return sent.error();
  return ClientMessage{LivePing{*sent}};
}

base::Result<ClientMessage> read_control(const json& message, LiveControl control) {
  const auto fields = only_fields(message, {"type"});
  if (!fields) return fields.error();
  return ClientMessage{control};
}

}  // namespace

base::Result<ClientMessage> read_client_message(const std::string& text) {
  const json message = json::parse(text, nullptr, false);
  if (!message.is_object()) return refuse("A message must be one JSON object.");
  const auto found = message.find("type");
  if (found == message.end() || !found->is_string()) return refuse("The message has no type.");
  const std::string type = found->get<std::string>();
  if (type == "handle") return read_handle(message);
  if (type == "ping") return read_ping(message);
  if (type == "pause") return read_control(message, LiveControl::pause);
  if (type == "resume") return read_control(message, LiveControl::resume);
  if (type == "end") return read_control(message, LiveControl::end);
  return refuse("The message has an unknown type.");
}

std::string error_notice(const std::string& message) {
  return json{{"type", "error"}, {"message", message}}.dump(-1, ' ', false,
                                                            json::error_handler_t::replace);
}

std::string second_tab_notice() {
  return json{{"type", "second_tab"},
              {"message", "This trial is being steered in another tab; this one only watches."}}
      .dump();
}

std::string pong_notice(double sent_ms) {
  return json{{"type", "pong"}, {"sent_ms", sent_ms}}.dump();
}

std::string finished_notice(const std::string& trial_id, bool practice) {
  return json{{"type", practice ? "practice_ended" : "filed"}, {"trial_id", trial_id}}.dump();
}

}  // namespace app
