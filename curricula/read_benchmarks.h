// Reads `benchmarks:`, the pass marks that exercises refer to by name.
#pragma once

#include <string>
#include <vector>

#include "curricula/fields.h"

namespace curricula {

std::vector<Benchmark> read_benchmarks(const YamlNode& node, Problems& problems);

// Notes a problem unless `id` names a metric that this version measures.
bool check_metric(const std::string& id, const YamlNode& at, Problems& problems);

}  // namespace curricula
