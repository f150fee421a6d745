// Database: a results file, which is an SQLite database. Its tables are created in schema.cpp.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>

#include <string>

namespace waybreaker::experiment {

enum class Access { read, write, create };

// Opens a results file. `create` begins a new one where there is none (or an empty file, as an interrupted beginning
// leaves it); it must not exist otherwise. With `write` and `create` no other process can open it until it is closed.
// Throws InputError, with the remedy, for what is no results file of this format, damaged, or in use; and changes
// nothing then.
class Database {
  public:
    Database(const std::string& path, Access access);

    SQLite::Database& sql() { return sql_; }
    const std::string& path() const { return path_; }
    bool is_new() const { return is_new_; }

    // Runs `act`; what SQLite throws becomes an InputError.
    template <class Act>
    auto guarded(Act act) {
        try {
            return act();
        } catch (const SQLite::Exception& error) {
            complain(path_, error);
        }
    }

  private:
    [[noreturn]] static void complain(const std::string& path, const SQLite::Exception& error);
    static SQLite::Database open(const std::string& path, Access access);
    void require_ours(Access access);

    std::string path_;
    SQLite::Database sql_;
    bool is_new_ = false;
};

// In the header of every results file: "WBrk", and the version of the tables.
inline constexpr int application_id = 0x5742726b;
inline constexpr int results_format = 2;

// Makes the tables and says whose they are, in the transaction that is open.
void make_tables(SQLite::Database& sql);

}  // namespace waybreaker::experiment
