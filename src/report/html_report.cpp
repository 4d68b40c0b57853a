#include "report/html_report.h"

namespace truelux {
std::string HtmlReport(const Comparison& c) {
  return c.scene;
}
}  // namespace truelux
