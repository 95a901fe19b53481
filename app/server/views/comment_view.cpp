#include "app/server/views/comment_view.h"

#include "app/server/views/json_views.h"

namespace app {

nlohmann::json comment_json(const database::Comment& comment, const std::string& viewer_id) {
  return {{"id", comment.id},
          {"author", comment.author_name},
          {"own", comment.author_id == viewer_id},
          {"written_utc", comment.written_utc},
          {"time_s", number_or_null(comment.time_s)},
          {"text", comment.text}};
}

}  // namespace app
