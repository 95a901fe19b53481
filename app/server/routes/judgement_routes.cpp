// What instructors say of a trial: comments, and voiding it with a reason.
#include <nlohmann/json.hpp>

#include "app/server/json_body.h"
#include "app/server/json_fields.h"
#include "app/server/routes/handlers.h"
#include "app/server/views/comment_view.h"
#include "database/comments.h"
#include "database/trials.h"

namespace app {
namespace {

using nlohmann::json;

constexpr double kLongestTrial = 86400.0;                          // s
constexpr std::size_t kShortestReason = 10, kLongestReason = 500;  // bytes

}  // namespace

base::Result<Response> post_comment(Call& call) {
  const auto body = read_json_object(call.request);
  if (!body) return body.error();
  JsonFields fields(*body);
  const std::string text = fields.text("text");
  const std::optional<double> time_s = fields.number_or_null("time_s", 0.0, kLongestTrial);
  if (const auto read = fields.done(); !read) return read.error();
  const auto comment =
      database::add_comment(call.store, call.parameter("id"), call.me().person.id, text, time_s);
  if (!comment) return comment.error();
  return json_response(comment_json(*comment, call.me().person.id), 201);
}

base::Result<Response> delete_comment(Call& call) {
  const auto withdrawn = database::withdraw_comment(call.store, call.parameter("id"),
                                                    call.parameter("comment"), call.me().person.id);
  if (!withdrawn) return withdrawn.error();
  return Response{204, "application/json", "", {}};
}

base::Result<Response> post_void(Call& call) {
  const auto body = read_text_fields(call.request, {"reason"});
  if (!body) return body.error();
  const std::string reason = (*body)["reason"];
  if (reason.size() < kShortestReason || reason.size() > kLongestReason) {
    return base::Error{base::ErrorCode::invalid_input,
                       "Say in 10 to 500 characters why the trial should not count."};
  }
  const auto trial = database::trial(call.store, call.parameter("id"));
  if (!trial) return trial.error();
  if (trial->head.person_id == call.me().person.id) {
    return base::Error{base::ErrorCode::conflict,
                       "Nobody voids an own trial: ask another instructor or an administrator."};
  }
  const auto voided =
      database::void_trial(call.store, call.parameter("id"), reason, call.me().person.id);
  if (!voided) return voided.error();
  return get_trial(call);
}

}  // namespace app
