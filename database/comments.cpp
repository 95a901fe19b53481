#include "database/comments.h"

#include "database/audit_chain.h"
#include "database/connection.h"
#include "database/text_limits.h"
#include "database/utc.h"

namespace database {
namespace {

constexpr std::size_t kLongest = 2000;  // bytes

std::string hash_of_comment(const std::string& id, const std::string& text) {
  return hash_of({id, text});
}

}  // namespace

base::Result<Comment> add_comment(Store& store, const std::string& trial_id,
                                  const std::string& author_id, const std::string& text,
                                  std::optional<double> time_s) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    return base::Error{base::ErrorCode::invalid_input, "Write something before you send it."};
  }
  if (base::Status status = check_text("comment", text, kLongest); !status) return status.error();
  return writing(store, [&](soci::session& sql) -> base::Result<Comment> {
    int known = 0;
    sql << "SELECT count(*) FROM trial WHERE id = :id", soci::use(trial_id), soci::into(known);
    if (known == 0) return base::Error{base::ErrorCode::not_found, "There is no such trial."};
    Comment comment{new_id(), trial_id, author_id, "", utc_now(), text, time_s};
    sql << "SELECT display_name FROM identity WHERE person_id = :id", soci::use(author_id),
        soci::into(comment.author_name);
    double t = time_s.value_or(0.0);
    soci::indicator there = time_s ? soci::i_ok : soci::i_null;
    soci::statement insert(sql);
    insert.exchange(soci::use(comment.id));
    insert.exchange(soci::use(trial_id));
    insert.exchange(soci::use(author_id));
    insert.exchange(soci::use(comment.written_utc));
    insert.exchange(soci::use(t, there));
    insert.exchange(soci::use(text));
    insert.alloc();
    insert.prepare(
        "INSERT INTO trial_comment (id, trial_id, author_id, written_utc, t_s, text) "
        "VALUES (:id, :trial, :author, :utc, :t, :text)");
    insert.define_and_bind();
    insert.execute(true);
    add_audit(sql, {author_id, "trial.comment", "trial:" + trial_id, "",
                    hash_of_comment(comment.id, text)});
    return comment;
  });
}

base::Status withdraw_comment(Store& store, const std::string& trial_id,
                              const std::string& comment_id, const std::string& author_id) {
  return writing(store, [&](soci::session& sql) -> base::Status {
    std::string author, text;
    sql << "SELECT author_id, text FROM trial_comment "
           "WHERE id = :id AND trial_id = :trial AND withdrawn_utc IS NULL",
        soci::use(comment_id), soci::use(trial_id), soci::into(author), soci::into(text);
    if (!sql.got_data()) {
      return base::Error{base::ErrorCode::not_found,
                         "This comment is not there any more; load the page again."};
    }
    if (author != author_id) {
      return base::Error{base::ErrorCode::denied,
                         "Only who wrote a comment can take it back: ask its author."};
    }
    execute(sql, "UPDATE trial_comment SET text = '', withdrawn_utc = :utc WHERE id = :id",
            utc_now(), comment_id);
    add_audit(sql, {author_id, "trial.comment-withdrawn", "trial:" + trial_id,
                    hash_of_comment(comment_id, text), ""});
    return base::Done{};
  });
}

base::Result<std::vector<Comment>> trial_comments(Store& store, const std::string& trial_id) {
  return reading(store, [&](soci::session& sql) -> base::Result<std::vector<Comment>> {
    std::vector<Comment> comments;
    const soci::rowset<soci::row> rows =
        (sql.prepare << "SELECT c.id, c.author_id, coalesce(i.display_name, ''), c.written_utc, "
                        "c.t_s, c.text FROM trial_comment c "
                        "LEFT JOIN identity i ON i.person_id = c.author_id "
                        "WHERE c.trial_id = :id AND c.withdrawn_utc IS NULL "
                        "ORDER BY c.t_s IS NOT NULL, c.t_s, c.written_utc, c.id",
         soci::use(trial_id));
    for (const soci::row& row : rows) {
      Comment comment{row.get<std::string>(0),
                      trial_id,
                      row.get<std::string>(1),
                      row.get<std::string>(2),
                      row.get<std::string>(3),
                      row.get<std::string>(5),
                      std::nullopt};
      if (row.get_indicator(4) == soci::i_ok) comment.time_s = row.get<double>(4);
      comments.push_back(std::move(comment));
    }
    return comments;
  });
}

}  // namespace database
