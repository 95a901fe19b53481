#include "app/server/audit_verdict.h"

#include "database/audit.h"

namespace app {
namespace {

constexpr double kKept = 60.0;  // s

}  // namespace

base::Result<AuditVerdict::Verdict> AuditVerdict::look(database::Store& store, double now) {
  const std::lock_guard lock(mutex_);
  const auto head = database::audit_head(store);
  if (!head) return head.error();
  if (*head == head_ && now - looked_s_ < kKept) return verdict_;
  const base::Status whole = database::verify_audit(store);
  if (!whole && whole.error().code != base::ErrorCode::corrupt_data) return whole.error();
  const std::string rows = head->substr(0, head->find(' '));
  verdict_ =
      whole
          ? Verdict{true, "The chain is whole: " + rows + " rows, none changed, removed or moved."}
          : Verdict{false, whole.error().message};
  head_ = *head;
  looked_s_ = now;
  return verdict_;
}

}  // namespace app
