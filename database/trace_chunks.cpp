#include <memory>

#include "database/connection.h"
#include "database/trial_rows.h"

namespace database {
namespace {

using sqlite_api::sqlite3_stmt;

struct Finalize {
  void operator()(sqlite3_stmt* statement) const { sqlite_api::sqlite3_finalize(statement); }
};
using Statement = std::unique_ptr<sqlite3_stmt, Finalize>;

Statement prepare(Store::Connection& connection, const char* text) {
  sqlite3_stmt* statement = nullptr;
  check_sqlite(connection,
               sqlite_api::sqlite3_prepare_v2(connection.native(), text, -1, &statement, nullptr));
  return Statement(statement);
}

// The text must live until the statement has run: nothing is copied (SQLITE_STATIC).
void bind_text(Store::Connection& connection, const Statement& statement, int index,
               const std::string& text) {
  check_sqlite(connection, sqlite_api::sqlite3_bind_text64(statement.get(), index, text.data(),
                                                           text.size(), nullptr, SQLITE_UTF8));
}

void bind_bytes(Store::Connection& connection, const Statement& statement, int index,
                std::span<const std::byte> bytes) {
  // a null pointer would be stored as NULL, not as no bytes
  const void* data = bytes.empty() ? static_cast<const void*>("") : bytes.data();
  check_sqlite(connection, sqlite_api::sqlite3_bind_blob64(statement.get(), index, data,
                                                           bytes.size(), nullptr));
}

std::string text_column(const Statement& statement, int index) {
  const unsigned char* text = sqlite_api::sqlite3_column_text(statement.get(), index);
  const int size = sqlite_api::sqlite3_column_bytes(statement.get(), index);
  return std::string(reinterpret_cast<const char*>(text), static_cast<std::size_t>(size));
}

std::vector<std::byte> bytes_column(const Statement& statement, int index) {
  const auto* bytes =
      static_cast<const std::byte*>(sqlite_api::sqlite3_column_blob(statement.get(), index));
  const int size = sqlite_api::sqlite3_column_bytes(statement.get(), index);
  return std::vector<std::byte>(bytes, bytes + size);
}

}  // namespace

void insert_chunks(Store::Connection& connection, const std::string& trial_id,
                   std::span<const Chunk> chunks) {
  if (chunks.empty()) return;
  const std::string now = utc_now();
  const Statement insert =
      prepare(connection,
              "INSERT INTO trace_chunk (trial_id, kind, seq, codec, bytes, written_utc) "
              "VALUES (?1, ?2, ?3, ?4, ?5, ?6)");
  for (const Chunk& chunk : chunks) {
    bind_text(connection, insert, 1, trial_id);
    bind_text(connection, insert, 2, chunk.kind);
    check_sqlite(connection, sqlite_api::sqlite3_bind_int(insert.get(), 3, chunk.seq));
    bind_text(connection, insert, 4, chunk.codec);
    bind_bytes(connection, insert, 5, chunk.bytes);
    bind_text(connection, insert, 6, now);
    check_sqlite(connection, sqlite_api::sqlite3_step(insert.get()));
    check_sqlite(connection, sqlite_api::sqlite3_reset(insert.get()));
  }
}

std::vector<Chunk> load_chunks(Store::Connection& connection, const std::string& trial_id,
                               const std::string& kind) {
  const Statement select = prepare(
      connection,
      "SELECT seq, codec, bytes FROM trace_chunk WHERE trial_id = ?1 AND kind = ?2 ORDER BY seq");
  bind_text(connection, select, 1, trial_id);
  bind_text(connection, select, 2, kind);
  std::vector<Chunk> chunks;
  int code = SQLITE_ROW;
  while ((code = sqlite_api::sqlite3_step(select.get())) == SQLITE_ROW) {
    Chunk chunk;
    chunk.seq = sqlite_api::sqlite3_column_int(select.get(), 0);
    chunk.kind = kind;
    chunk.codec = text_column(select, 1);
    chunk.bytes = bytes_column(select, 2);
    chunks.push_back(std::move(chunk));
  }
  check_sqlite(connection, code);
  return chunks;
}

}  // namespace database
