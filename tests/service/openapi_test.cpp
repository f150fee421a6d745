// openapi.json passes Redocly's recommended rules, and all numbers state their units.
#include <functional>

#include "io/mission_json.hpp"
#include "live_server.hpp"
#include "schema_check.hpp"
#include "service/problem_kind.hpp"

namespace waybreaker::service {
namespace {

const Json& api() {
    static const Json description = Json::parse(openapi_json());
    return description;
}

void for_each_operation(const std::function<void(const std::string&, const Json&, const Json&)>& visit) {
    for (const auto& [path, item] : api()["paths"].items()) {
        for (const auto& [method, operation] : item.items()) {
            if (method != "parameters") visit(path + ' ' + method, item, operation);
        }
    }
}

// Every schema in a part of the description.
void for_each_schema(const Json& part, const std::string& place,
                     const std::function<void(const std::string&, const Json&)>& visit) {
    if (!part.is_structured()) return;
    if (part.is_object() && (part.contains("type") || part.contains("enum"))) visit(place, part);
    for (const auto& [name, inner] : part.items()) for_each_schema(inner, place + "." + name, visit);
}

bool is_number(const Json& type) {
    if (type.is_array()) return is_number(type.front());
    return type == "number" || type == "integer";
}

TEST(OpenApi, SaysWhoseItIsAndWhereItIsServed) {
    EXPECT_FALSE(api()["servers"].empty());
    EXPECT_TRUE(api()["info"]["license"].contains("identifier"));
    for (const Json& choice : api()["security"]) {
        for (const auto& [scheme, scopes] : choice.items()) {
            EXPECT_TRUE(api()["components"]["securitySchemes"].contains(scheme)) << scheme;
        }
    }
}

TEST(OpenApi, NamesAndSumsUpEveryOperation) {
    std::set<std::string> ids;
    for_each_operation([&](const std::string& name, const Json& item, const Json& operation) {
        EXPECT_TRUE(ids.insert(operation.value("operationId", "")).second) << name;
        EXPECT_NE(operation.value("summary", ""), "") << name;
        bool refuses = false;
        for (const auto& [status, answer] : operation["responses"].items()) {
            EXPECT_NE(resolved(api(), answer).value("description", ""), "") << name << ' ' << status;
            refuses = refuses || status.front() == '4';
        }
        EXPECT_TRUE(refuses) << name;
        if (name.find("{id}") == std::string::npos) return;
        EXPECT_EQ(resolved(api(), item["parameters"][0]).value("in", ""), "path") << name;
    });
    EXPECT_FALSE(ids.contains(""));
}

TEST(OpenApi, SaysTheUnitOfEveryNumber) {
    for_each_schema(api()["components"]["schemas"], "schemas", [](const std::string& place, const Json& schema) {
        const Json& properties = schema.value("properties", Json::object());
        for (const Json& name : schema.value("required", Json::array())) {
            EXPECT_TRUE(properties.contains(name.get<std::string>())) << place << ' ' << name;
        }
        for (const auto& [name, property] : properties.items()) {
            const Json type = property.value("type", Json());
            const bool numbers = is_number(type) || (property.contains("items") && property["items"].contains("type") &&
                                                     is_number(property["items"]["type"]));
            EXPECT_TRUE(!numbers || property.contains("description")) << place << '.' << name;
        }
    });
    for (const char* name : {"Options", "Request"}) {
        for_each_schema(api()["components"]["schemas"][name], name, [](const std::string& place, const Json& schema) {
            if (schema.contains("type") && (schema["type"] == "number" || schema["type"] == "integer") &&
                !place.ends_with("items")) {
                EXPECT_TRUE(schema.contains("minimum") || schema.contains("exclusiveMinimum")) << place;
            }
        });
    }
}

class ProblemTest : public LiveServer {};

TEST_F(ProblemTest, TypesAreAddressesThatTheServerAnswers) {
    begin();
    std::set<std::string> types;
    for (const ProblemKind& kind : problem_kinds()) {
        types.insert(kind.type());
        EXPECT_EQ(get(kind.type()).status, 200) << kind.name;
        EXPECT_NE(get(kind.type()).body.find(kind.title), std::string::npos);
    }
    const Json& described = api()["components"]["schemas"]["Problem"]["properties"]["type"]["enum"];
    EXPECT_EQ(types, described.get<std::set<std::string>>());
    EXPECT_EQ(types.size(), problem_kinds().size());
    get_json("/problems/none-of-these", 404);
}

TEST_F(ProblemTest, KindsDistinguishProblemsOfOneStatus) {
    put("maps/broken.map", "type octile\nheight 2\nwidth 2\nmap\n.\n");
    begin();
    const auto type = [](const Json& problem) { return problem["type"].get<std::string>(); };
    EXPECT_EQ(type(get_json(maps + "/nowhere.map", 404)), "/problems/map-not-found");
    EXPECT_EQ(type(get_json("/api/v2", 404)), "/problems/path-not-found");
    EXPECT_EQ(type(get_json(maps + "/broken.map", 422)), "/problems/map-unreadable");
    const std::string house = maps + "/house.map";
    EXPECT_EQ(type(post_json(house + "/plan", Json::object(), 422)), "/problems/mission-unfit");
    EXPECT_EQ(type(post_json(house + "/plan", Json::array(), 400)), "/problems/invalid-request");
    Json plan = post_json(house + "/plan", house_mission);
    plan["after"]["makespan"] = 1;
    EXPECT_EQ(type(post_json(house + "/export?format=csv", plan, 422)), "/problems/plan-invalid");
    EXPECT_EQ(Json::parse(remove(house).body)["type"], "/problems/map-not-removable");
}

TEST_F(ProblemTest, NamesHowAPlanReadItsMap) {
    begin();
    const std::string house = maps + "/house.map";
    const Json plan = post_json(house + "/plan", house_mission);
    const auto told = [&](const Json& reading, int connectivity) {
        Json other = plan;
        other["map"].update(reading);
        other["options"]["connectivity"] = connectivity;
        return post_json(house + "/check", other, 422)["detail"].get<std::string>();
    };
    const std::string message = "the plan was made with another reading of the map than the server's: ";
    EXPECT_EQ(told({{"nav2", "humble"}}, 4), message + "--nav2 humble");
    EXPECT_EQ(told({{"threshold", 0.65}, {"unknown", "free"}}, 8),
              message + "--connectivity 8, --threshold 0.65, --unknown-free");
}

TEST_F(ProblemTest, SaysLineAndColumnOfTheBody) {
    begin();
    const std::string house = "/api/v1/maps/house.map";
    const auto detail = [&](const std::string& route, const std::string& body) {
        return Json::parse(post(house + route, body).body)["detail"].get<std::string>();
    };
    EXPECT_EQ(detail("/plan", "{\n  \"mission\": {\"start\": [1]}}"),
              "request:2:24: mission.start is not a cell, [x, y]");
    EXPECT_EQ(detail("/edits", "{\"free\":\n[7]}"), "edits:2:2: free[0] is not an array");
    EXPECT_EQ(detail("/check", "{\"format\":\n\n 7}"), "the plan:3:2: format is not waybreaker-plan/1");
    EXPECT_EQ(detail("/export?format=csv", "{"), "the plan:1:2: this is not JSON: it ends too early");
}

TEST_F(ProblemTest, DescribesTheMissionFile) {
    begin();
    const Json schema = get_json("/api/v1/mission.schema.json");
    io::MissionDocument document{ground_and_air({0, 0}, {3, 2})};
    document.mission.rules.budget = 2.5;
    document.mission.rules.protect = {{2}};
    document.mission.rules.minimise_demolition = 0.01;
    document.protect_tags = {{"amenity", {"school"}}};
    document.in_seconds = true;
    document.mission.rules.separation = 0.5;
    document.mission.rules.at_goal = AtGoal::leave;
    document.mission.rules.collisions = false;
    document.mission.rules.unreached = 600;
    document.mission.rules.rubble = 20;
    document.mission.agents[0].weight = 40;
    document.mission.agents[0].ready_at = 3;
    document.mission.agents[0].approach = {{0, 1, 2}, {0, 0, 3}};
    document.mission.agents[1].from = Point(0.25, 0.5);
    document.mission.agents[1].range = 900;
    document.mission.agents[1].endurance = 60;
    document.mission.agents[1].reserve = 0.2;
    document.mission.agents[1].flown = 10;
    document.mission.agents[1].recharge = 30;
    document.mission.agents[1].bases = {{0, 2}};
    document.mission.agents[1].breach_time = 2;
    document.mission.agents[1].breach_time_per_cell = 0.5;
    document.mission.agents[0].can_breach = CanBreach{.most_cells = 20, .only = std::vector<ObstacleId>{{2}}};
    document.can_breach_tags[0] = {{"barrier"}};
    document.mission.agents[0].reach = 2;
    document.mission.rules.opened = {{{3}, 4.5}};
    document.mission.rules.failed = {{4}};
    document.mission.rules.retries = 2;
    document.mission.rules.zones = {{.polygon = {{{9, 9}, {12, 9}, {12, 12}}}, .name = "field", .agents = {"air"}}};
    document.method.heuristic = Heuristic::octile;
    document.limits.expansions = 100;
    document.limits.gap = 0.01;
    Json written = Json::parse(io::mission_text(document));
    EXPECT_EQ(schema_faults(schema, schema, written), std::vector<std::string>());
    // It names all members that can be written, and no others.
    for (const char* part : {"rules", "method", "limits"}) {
        for (const auto& [member, value] : schema["properties"][part]["properties"].items()) {
            const bool forced = std::string(part) == "rules" && member == "force";
            if (member == "budget_m2") continue;  // in place of budget
            EXPECT_TRUE(forced || written[part].contains(member)) << part << '.' << member;
        }
    }
    document.area_budget = true;
    written = Json::parse(io::mission_text(document));
    EXPECT_EQ(written["rules"]["budget_m2"], 2.5);
    EXPECT_EQ(schema_faults(schema, schema, written), std::vector<std::string>());
    written["agents"][0]["kind"] = "submarine";
    EXPECT_FALSE(schema_faults(schema, schema, written).empty());
}

}  // namespace
}  // namespace waybreaker::service
