// Novices against experts: what can be compared, the comparison, and its report to keep.
#include <memory>

#include <nlohmann/json.hpp>

#include "app/server/json_body.h"
#include "app/server/routes/handlers.h"
#include "app/server/seen_comparison.h"
#include "app/server/site.h"
#include "app/server/views/comparison_view.h"
#include "app/session/published_data.h"

namespace app {
namespace {

using nlohmann::json;

// What was asked for, and what of it the viewer may see.
struct Asked {
  std::shared_ptr<const curricula::Curriculum> curriculum;  // shared: with the site
  const curricula::Exercise* exercise = nullptr;            // of it
  ComparisonData data;
};

base::Result<std::shared_ptr<const curricula::Curriculum>> curriculum_of(Call& call) {
  return call.site.curricula.standard(call.store, call.site.scenes.library().catalogue());
}

base::Result<Asked> asked(Call& call) {
  auto curriculum = curriculum_of(call);
  if (!curriculum) return curriculum.error();
  Asked found;
  found.curriculum = *std::move(curriculum);
  found.exercise = found.curriculum->find(call.parameter("id"));
  if (found.exercise == nullptr) {
    return base::Error{base::ErrorCode::not_found, "There is no such exercise to compare."};
  }
  const std::string& dataset = call.request.parameter("dataset");
  auto data = seen_data(call.store, *found.exercise, dataset.empty() ? kPaperDataset : dataset,
                        call.me().person);
  if (!data) return data.error();
  found.data = *std::move(data);
  return found;
}

Response download(std::string body, const char* type, const reports::ComparisonSubject& subject,
                  const char* ending) {
  Response response;
  response.type = type;
  response.body = std::move(body);
  response.headers.emplace_back("Content-Disposition", "attachment; filename=\"compare-" +
                                                           subject.exercise_id + "-" +
                                                           subject.dataset + ending + "\"");
  return response;
}

}  // namespace

base::Result<Response> get_compare_options(Call& call) {
  const auto curriculum = curriculum_of(call);
  if (!curriculum) return curriculum.error();
  const auto choices = comparison_choices(call.store, **curriculum, call.me().person);
  if (!choices) return choices.error();
  json list = json::array();
  for (const ComparisonChoice& choice : *choices) {
    list.push_back({{"exercise_id", choice.exercise_id},
                    {"exercise_title", choice.exercise_title},
                    {"dataset", choice.dataset},
                    {"dataset_title", choice.dataset_title},
                    {"people", choice.people},
                    {"trials", choice.trials}});
  }
  return json_response({{"choices", list}});
}

base::Result<Response> get_comparison(Call& call) {
  const auto what = asked(call);
  if (!what) return what.error();
  const auto comparison = seen_comparison(what->data, *what->exercise, call.me().person);
  const reports::ComparisonSubject& subject = what->data.subject;
  if (comparison) return json_response(comparison_json(*comparison, subject));
  if (comparison.error().code != base::ErrorCode::not_enough_data) return comparison.error();
  return json_response(no_comparison_json(subject, comparison.error().message));
}

base::Result<Response> get_comparison_csv(Call& call) {
  const auto what = asked(call);
  if (!what) return what.error();
  const auto comparison = seen_comparison(what->data, *what->exercise, call.me().person);
  if (!comparison) return comparison.error();
  const reports::ComparisonSubject& subject = what->data.subject;
  return download(reports::comparison_csv(*comparison, subject), "text/csv; charset=utf-8", subject,
                  ".csv");
}

base::Result<Response> get_comparison_html(Call& call) {
  const auto what = asked(call);
  if (!what) return what.error();
  const auto comparison = seen_comparison(what->data, *what->exercise, call.me().person);
  if (!comparison) return comparison.error();
  const reports::ComparisonSubject& subject = what->data.subject;
  Response response = download(reports::comparison_html(*comparison, subject),
                               "text/html; charset=utf-8", subject, ".html");
  // a page of its own that carries its styles and may do nothing
  response.headers.emplace_back("Content-Security-Policy",
                                "default-src 'none'; style-src 'unsafe-inline'; sandbox");
  return response;
}

}  // namespace app
