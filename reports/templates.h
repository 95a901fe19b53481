// The pages' templates (Mustache), as they lie in reports/templates.
#pragma once

namespace reports {

const char* comparison_template();

}  // namespace reports
