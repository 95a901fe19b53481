# Usage: cmake -DOUTPUT=<file.cpp> -DSOURCES=<a.sql,b.sql> -P embed_migrations.cmake
#
# Writes the numbered SQL files into one source file, so that the program carries its migrations
# with it. The number of a migration is the number its file name begins with.
string(REPLACE "," ";" sources "${SOURCES}")
set(rows "")
foreach(source IN LISTS sources)
  get_filename_component(name ${source} NAME_WE)
  string(REGEX MATCH "^0*([0-9]+)_" unused ${name})
  set(version ${CMAKE_MATCH_1})
  file(READ ${source} sql)
  string(APPEND rows "    {${version}, \"${name}\", R\"--sql--(${sql})--sql--\"},\n")
endforeach()
file(WRITE ${OUTPUT} "// Generated from database/migrations by embed_migrations.cmake.
#include \"database/migrations.h\"

namespace database {
namespace {

constexpr Migration kMigrations[] = {
${rows}};

}  // namespace

std::span<const Migration> migrations() { return kMigrations; }

}  // namespace database
")
