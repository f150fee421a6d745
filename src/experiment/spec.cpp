#include "experiment/spec.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

#include "core/in_quotes.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::experiment {
namespace {

constexpr int most_removals = 100;
constexpr double largest_weight = 1000;
constexpr double longest_time = 86400;
constexpr std::size_t most_configurations = 10'000;

// What the file says, with the line for errors.
class Reader {
  public:
    explicit Reader(const std::string& name) : name_(name) {}

    InputError error(const toml::node& node, const std::string& message) const {
        return {name_, node.source().begin.line, message};
    }

    void allow_only(const toml::table& table, std::initializer_list<std::string_view> keys) const {
        for (const auto& [key, node] : table) {
            if (std::ranges::find(keys, key.str()) != keys.end()) continue;
            throw error(node, fmt::format("unknown key '{}': use {}", printable(key.str()), fmt::join(keys, ", ")));
        }
    }

    // The items of a list, or a value that stands alone; empty if the key is absent.
    std::vector<const toml::node*> items(const toml::table& table, std::string_view key) const {
        const toml::node* node = table.get(key);
        if (node == nullptr) return {};
        if (!node->is_array()) return {node};
        std::vector<const toml::node*> items;
        for (const toml::node& item : *node->as_array()) items.push_back(&item);
        if (items.empty()) throw error(*node, fmt::format("'{}' is an empty list", key));
        return items;
    }

    std::string text(const toml::node& node, std::string_view what) const {
        if (const auto* value = node.as_string(); value != nullptr && !value->get().empty()) return value->get();
        throw error(node, fmt::format("{} must be a text, such as \"...\"", what));
    }

    double number(const toml::node& node, std::string_view what, double least, double most) const {
        const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
        if (value && *value >= least && *value <= most) return *value;
        throw error(node, fmt::format("{} must be a number from {} to {}", what, least, most));
    }

    int whole_number(const toml::node& node, std::string_view what, int least, int most) const {
        const std::optional<std::int64_t> value = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
        if (value && *value >= least && *value <= most) return int(*value);
        throw error(node, fmt::format("{} must be a whole number from {} to {}", what, least, most));
    }

    template <class Enum>
    Enum word(const toml::node& node) const {
        const auto* given = node.as_string();
        const auto value = given == nullptr ? std::nullopt : from_string<Enum>(given->get());
        if (value) return *value;
        throw error(node, fmt::format("this must be one of \"{}\"", fmt::join(words_of<Enum>, "\", \"")));
    }

  private:
    static std::string printable(std::string_view text) {
        std::string out(text.substr(0, 40));
        for (char& c : out) c = c >= ' ' && c <= '~' ? c : '?';
        return out;
    }

    const std::string& name_;
};

// Nothing that the method cannot do, or that would silently make no difference.
void validate(const Reader& reader, const toml::table& run, const Configuration& one) {
    const bool paper = one.method == Method::paper;
    if (paper && one.planner == Algorithm::optimal) {
        throw reader.error(run, "the paper's method counts hits, which the optimal planner cannot: use theta");
    }
    if (one.method == Method::greedy && one.planner != Algorithm::optimal) {
        throw reader.error(run, "the greedy method drives by the optimal planner only");
    }
    const bool weightless =
        one.planner == Algorithm::optimal || one.planner == Algorithm::dijkstra || one.planner == Algorithm::bfs;
    if (weightless && one.weight != 1) {
        throw reader.error(
            run, fmt::format("the planner {} has no heuristic that a weight could change", to_string(one.planner)));
    }
}

Algorithm usual_planner(Method method) {
    return method == Method::paper || method == Method::none ? Algorithm::theta : Algorithm::optimal;
}

// The product of a [[run]]'s lists.
std::vector<Configuration> configurations(const Reader& reader, const toml::table& run) {
    reader.allow_only(run, {"methods", "planners", "weights", "removals"});
    const auto planners = reader.items(run, "planners");
    std::vector<double> weights;
    for (const toml::node* node : reader.items(run, "weights")) {
        weights.push_back(reader.number(*node, "a weight", 1, largest_weight));
    }
    if (weights.empty()) weights.push_back(1);
    std::vector<int> removals;
    for (const toml::node* node : reader.items(run, "removals")) {
        removals.push_back(reader.whole_number(*node, "a number of removals", 0, most_removals));
    }

    std::vector<Configuration> product;
    const auto methods = reader.items(run, "methods");
    if (methods.empty()) throw reader.error(run, R"(a [[run]] needs 'methods', such as ["paper", "exact"])");
    for (const toml::node* method_node : methods) {
        const Method method = reader.word<Method>(*method_node);
        if (method != Method::none && removals.empty()) {
            throw reader.error(run, "this [[run]] needs 'removals', such as [1, 2, 3]");
        }
        std::vector<Algorithm> drivers;
        for (const toml::node* node : planners) drivers.push_back(reader.word<Algorithm>(*node));
        if (drivers.empty()) drivers.push_back(usual_planner(method));
        for (const Algorithm planner : drivers) {
            for (const double weight : weights) {
                for (const int n : method == Method::none ? std::vector<int>{0} : removals) {
                    product.push_back({method, planner, weight, n});
                    validate(reader, run, product.back());
                }
            }
        }
    }
    return product;
}

toml::table parse(std::string_view text, const std::string& name) {
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw InputError(name, error.source().begin.line, fmt::format("not TOML: {}", error.description()));
    }
}

}  // namespace

Spec parse_spec(std::string_view text, const std::string& name) {
    const toml::table file = parse(text, name);
    const Reader reader(name);
    reader.allow_only(file, {"name", "missions", "time_limit", "places", "run"});
    Spec spec;
    if (const toml::node* node = file.get("name")) spec.name = reader.text(*node, "'name'");
    for (const toml::node* node : reader.items(file, "missions")) {
        const std::string file_of_missions = reader.text(*node, "the name of a file of missions");
        if (std::ranges::find(spec.missions, file_of_missions) != spec.missions.end())
            throw reader.error(*node, fmt::format("{} stands here twice", in_quotes(file_of_missions)));
        spec.missions.push_back(file_of_missions);
    }
    if (spec.missions.empty())
        throw InputError(name, 0, "'missions' is missing: a list of scenario files or files of mission documents");
    if (const toml::node* node = file.get("time_limit")) {
        spec.time_limit = reader.number(*node, "'time_limit'", 0.001, longest_time);
    }
    for (const toml::node* node : reader.items(file, "places")) {
        spec.places.push_back(reader.text(*node, "a place, a pattern of the names of its maps,"));
    }
    const auto runs = reader.items(file, "run");
    if (runs.empty()) throw InputError(name, 0, "it has no [[run]]: say which methods with how many removals");
    for (const toml::node* node : runs) {
        if (!node->is_table()) throw reader.error(*node, "'run' must be tables, each under its [[run]]");
        for (const Configuration& one : configurations(reader, *node->as_table())) {
            if (std::ranges::find(spec.configurations, one) != spec.configurations.end()) {
                throw reader.error(
                    *node, fmt::format("{} with {}, weight {} and {} removals stands here twice", to_string(one.method),
                                       to_string(one.planner), one.weight, one.removals));
            }
            if (spec.configurations.size() == most_configurations) {
                throw reader.error(*node, fmt::format("more than {} configurations are too many", most_configurations));
            }
            spec.configurations.push_back(one);
        }
    }
    return spec;
}

}  // namespace waybreaker::experiment
