#include "reports/axis.h"

#include <algorithm>
#include <cmath>

#include "reports/number.h"

namespace reports {

std::vector<double> round_ticks(double low, double high, int count) {
  if (!(high > low)) high = low + 1.0;
  const double rough = (high - low) / std::max(count, 1);
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double factor : {1.0, 2.0, 2.5, 5.0}) {
    if (factor * power >= rough * 0.999) {
      step = factor * power;
      break;
    }
  }
  std::vector<double> ticks;
  const auto first = static_cast<long long>(std::floor(low / step + 1e-9));
  const auto last = static_cast<long long>(std::ceil(high / step - 1e-9));
  for (long long k = first; k <= last; ++k) ticks.push_back(static_cast<double>(k) * step);
  return ticks;
}

std::vector<std::string> tick_texts(const std::vector<double>& ticks) {
  const int decimals = common_decimals(ticks);
  std::vector<std::string> words;
  for (const double tick : ticks) words.push_back(fixed(tick, decimals));
  return words;
}

Scale draw_value_axis(Svg& svg, const Frame& frame, double low, double high,
                      const std::string& unit) {
  const std::vector<double> ticks = round_ticks(low, high, 5);
  const Scale scale{ticks.front(), ticks.back(), svg.height() - frame.bottom, frame.top};
  const std::vector<std::string> words = tick_texts(ticks);
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double y = scale(ticks[i]);
    svg.line({frame.left, y}, {svg.width() - frame.right, y}, {colour::kGrid, 1.0, "", "grid"});
    svg.text({frame.left - 8.0, y + 4.0}, words[i], Anchor::end, colour::kText3, "ax");
  }
  svg.text({frame.left - 8.0, frame.top - 12.0}, unit, Anchor::end, colour::kText3, "ax");
  return scale;
}

}  // namespace reports
