#include "database/trial_summaries.h"

#include "database/connection.h"

namespace database {

base::Result<std::map<std::string, int>> critical_errors(Store& store,
                                                         const std::string& person_id) {
  using Counts = std::map<std::string, int>;
  return reading(store, [&](soci::session& sql) -> base::Result<Counts> {
    Counts counts;
    std::string trial_id;
    int count = 0;
    soci::statement select =
        (sql.prepare << "SELECT e.trial_id, count(*) FROM trial t "
                        "JOIN event e ON e.trial_id = t.id AND e.severity = 'critical' "
                        "WHERE t.person_id = :person GROUP BY e.trial_id",
         soci::use(person_id, "person"), soci::into(trial_id), soci::into(count));
    select.execute();
    while (select.fetch()) counts[trial_id] = count;
    return counts;
  });
}

base::Result<std::vector<ExpertMean>> expert_means(Store& store) {
  return reading(store, [](soci::session& sql) -> base::Result<std::vector<ExpertMean>> {
    std::vector<ExpertMean> means;
    ExpertMean row;
    // CROSS JOIN: the few experts first, then their trials by person, then the metrics
    soci::statement select =
        (sql.prepare << "SELECT t.exercise_id, m.metric, m.version, avg(m.value) "
                        "FROM (SELECT DISTINCT person_id FROM experience WHERE level = 'expert') x "
                        "CROSS JOIN person p ON p.id = x.person_id AND p.kind = 'live' "
                        "CROSS JOIN trial t ON t.person_id = x.person_id "
                        "CROSS JOIN metric_value m ON m.trial_id = t.id "
                        "WHERE t.source = 'live' AND t.end_reason = 'completed' "
                        "AND t.voided_utc IS NULL AND t.interrupted = 0 "
                        "AND (SELECT e.level FROM experience e WHERE e.person_id = t.person_id "
                        "AND e.declared_utc <= t.started_utc "
                        "ORDER BY e.declared_utc DESC, e.ordinal DESC LIMIT 1) = 'expert' "
                        "GROUP BY t.exercise_id, m.metric, m.version, t.person_id "
                        "ORDER BY t.exercise_id, m.metric, m.version, t.person_id",
         soci::into(row.exercise_id), soci::into(row.metric), soci::into(row.version),
         soci::into(row.mean));
    select.execute();
    while (select.fetch()) means.push_back(row);
    return means;
  });
}

}  // namespace database
