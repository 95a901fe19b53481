# Usage: cmake -DOUTPUT=<file.cpp> -DSOURCE=<page.html> -P embed_templates.cmake
#
# Writes a template into a source file, so that the program carries it with it.
file(READ ${SOURCE} html)
file(WRITE ${OUTPUT} "// Generated from reports/templates by embed_templates.cmake.
#include \"reports/templates.h\"

namespace reports {

const char* comparison_template() {
  return R\"--html--(${html})--html--\";
}

}  // namespace reports
")
