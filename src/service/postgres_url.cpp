#include "service/postgres_url.hpp"

#include <libpq-fe.h>

#include <algorithm>
#include <map>
#include <memory>

#include "waybreaker/error.hpp"

namespace waybreaker::service {
namespace {

// What is said of a connection unless the URL says otherwise: a server that does not answer is given up within half a
// minute.
const std::map<std::string, std::string> defaults{{"application_name", "waybreaker"}, {"client_encoding", "UTF8"},
                                                  {"connect_timeout", "10"},          {"keepalives_count", "3"},
                                                  {"keepalives_idle", "10"},          {"keepalives_interval", "5"},
                                                  {"tcp_user_timeout", "25000"}};

// libpq finds where host and password end by the first @, / or ?, and its messages quote what it takes for the host.
bool may_hide_a_password(const std::string& url) {
    const std::size_t begin = url.find("://") + 3;
    const std::size_t end = std::min(url.find_first_of("/?", begin), url.size());
    const auto at = [&](std::size_t from, std::size_t to) {
        return std::count(url.begin() + std::ptrdiff_t(from), url.begin() + std::ptrdiff_t(to), '@');
    };
    return at(begin, end) > 1 || at(end, url.size()) > 0;
}

// What a URL says, by libpq's names.
std::map<std::string, std::string> parameters_of(const std::string& url) {
    if (may_hide_a_password(url)) {
        throw InputError(
            "--store: the URL has an @ behind that of user and password: write %40, %2F and %3F for the @, / and ? of "
            "a "
            "name or password");
    }
    char* message = nullptr;
    const std::unique_ptr<PQconninfoOption, decltype(&PQconninfoFree)> options(PQconninfoParse(url.c_str(), &message),
                                                                               &PQconninfoFree);
    PQfreemem(message);  // it may quote the password
    if (!options) {
        throw InputError(
            "--store: this is no URL of a PostgreSQL database: write postgresql://USER:PASSWORD@HOST:PORT/DATABASE, of "
            "which all but the // can be left out, with % and two digits for what is neither letter nor digit");
    }
    std::map<std::string, std::string> parameters;
    for (const PQconninfoOption* option = options.get(); option->keyword != nullptr; ++option) {
        if (option->val != nullptr) parameters[option->keyword] = option->val;
    }
    return parameters;
}

std::string quoted(const std::string& value) {
    std::string text = "'";
    for (const char c : value) {
        if (c == '\'' || c == '\\') text += '\\';
        text += c;
    }
    return text + "'";
}

}  // namespace

PostgresUrl parse_postgres_url(const std::string& url) {
    std::map<std::string, std::string> parameters = parameters_of(url);
    PostgresUrl parsed;
    parsed.name = "postgresql://" + parameters["host"] + (parameters["port"].empty() ? "" : ":" + parameters["port"]) +
                  "/" + parameters["dbname"];
    std::erase_if(parameters, [](const auto& entry) { return entry.second.empty(); });
    parameters.insert(defaults.begin(), defaults.end());
    for (const auto& [name, value] : parameters) parsed.parameters += name + "=" + quoted(value) + " ";
    return parsed;
}

}  // namespace waybreaker::service
