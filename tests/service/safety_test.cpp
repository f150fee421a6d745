// Strangers, hostile pages and hostile files get a problem document and nothing else.
#include <filesystem>

#include "http/guard.hpp"
#include "input_error.hpp"
#include "live_server.hpp"
#include "mapfile/grey_image.hpp"
#include "service/built_in_maps.hpp"
#include "service/map_store.hpp"

namespace waybreaker::service {
namespace {

class SafetyTest : public LiveServer {};

TEST_F(SafetyTest, OtherMachinesNeedATokenOrAStatedRisk) {
    options_.host = "0.0.0.0";
    EXPECT_NE(input_error([this] { Service service(options_); }).find("--token"), std::string::npos);
    options_.insecure = true;
    EXPECT_EQ(input_error([this] { Service service(options_); }), "");
    options_.insecure = false;
    options_.token = "secret";
    EXPECT_EQ(input_error([this] { Service service(options_); }), "");
}

TEST_F(SafetyTest, TokensThatNobodyCanSendAreRefused) {
    for (const char* token : {" ", "\t", " secret", "secret ", "sec\nret", "\x7f"}) {
        options_.token = token;
        EXPECT_NE(input_error([this] { Service service(options_); }).find("no client can send it"), std::string::npos);
    }
    for (const char* token : {"x", "a secret", "schl\xc3\xbcssel", "~!@#$%^&*()"}) {
        options_.token = token;
        EXPECT_EQ(input_error([this] { Service service(options_); }), "");
        EXPECT_TRUE(http::brings_token("Bearer " + options_.token, options_.token));
    }
}

TEST_F(SafetyTest, TheLogSaysAnAddressThatCanBeOpened) {
    options_.host = "::1";
    try {
        const Service service(options_);
        EXPECT_EQ(service.url(), "http://[::1]:" + std::to_string(service.port()));
    } catch (const InputError&) {
        GTEST_SKIP() << "this machine has no IPv6";
    }
}

TEST_F(SafetyTest, WithATokenOnlyHealthAndDescriptionAreOpen) {
    options_.token = "secret";
    begin();
    EXPECT_EQ(get("/healthz").status, 200);
    EXPECT_EQ(get("/api/v1/openapi.json").status, 200);
    for (const std::string path : {"/metrics", "/api/v1/maps", "/api/v1/maps/house.map"}) {
        EXPECT_EQ(get(path).status, 401) << path;
        EXPECT_EQ(get(path, {{"Authorization", "Bearer wrong!"}}).status, 401);
        EXPECT_EQ(get(path, {{"Authorization", "Bearer secret"}}).status, 200);
    }
    EXPECT_EQ(post(maps, "x", octets).status, 401);
}

TEST_F(SafetyTest, PagesOfOtherSitesGetNothing) {
    begin();
    EXPECT_EQ(get(maps, {{"Host", "evil.example"}}).status, 421);
    EXPECT_EQ(get(maps, {{"Origin", "http://evil.example"}}).status, 403);
    const std::string here = "127.0.0.1:" + std::to_string(port());
    EXPECT_EQ(get(maps, {{"Host", here}, {"Origin", "http://" + here}}).status, 200);
}

TEST_F(SafetyTest, AnswersToItsNamesAlone) {
    options_.names = {"http://robots.example"};
    EXPECT_NE(input_error([this] { Service service(options_); }).find("--name"), std::string::npos);
    options_.names = {"robots.example", "base"};
    begin();
    for (const char* host : {"robots.example", "BASE:99", "localhost", "127.0.0.1"}) {
        EXPECT_EQ(get(maps, {{"Host", host}}).status, 200) << host;
    }
    for (const char* host : {"evil.example", "192.0.2.7"}) EXPECT_EQ(get(maps, {{"Host", host}}).status, 421) << host;
    end();
    options_.host = "0.0.0.0";
    options_.insecure = true;
    begin();
    // A page's name can be made to lead here; an address cannot be such a name.
    for (const char* host : {"robots.example", "192.0.2.7:80", "[2001:db8::7]"}) {
        EXPECT_EQ(get(maps, {{"Host", host}}).status, 200) << host;
    }
    EXPECT_EQ(get(maps, {{"Host", "evil.example"}}).status, 421);
    end();
    options_.names.clear();
    begin();
    EXPECT_EQ(get(maps, {{"Host", "any.example"}}).status, 200);
}

TEST_F(SafetyTest, NoNameLeadsOutOfTheMapsFolder) {
    const std::string secret = put("secret.map", "type octile\nheight 1\nwidth 1\nmap\n.\n");
    std::filesystem::create_symlink(secret, path("maps/link.map"));
    put("secret.pgm", "P2 1 1 255 255\n");
    put("maps/leads-out.yaml",
        "image: ../secret.pgm\nresolution: 1\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: "
        "0.196\n");
    put("maps/two words.map", "type octile\nheight 1\nwidth 1\nmap\n.\n");
    put("maps/.hidden.map", "type octile\nheight 1\nwidth 1\nmap\n.\n");
    put("maps/notes.txt", "not a map");
    begin();
    const Json list = get_json(maps)["maps"];
    ASSERT_EQ(list.size(), 5U);
    for (const Json& entry : list)
        EXPECT_TRUE(entry["id"] == "berlin-adlershof.tif" || entry["id"] == "berlin-mitte.tif" ||
                    entry["id"] == "house.map" || entry["id"] == "wall.map" || entry["id"] == "leads-out.yaml")
            << entry;
    for (const std::string name :
         {"..%2fsecret.map", "%2e%2e%2fsecret.map", "../secret.map", "..", "link.map", ".hidden.map", "two%20words.map",
          "notes.txt", "house.map%00", "house.map%0a", "/etc/passwd", "%2fetc%2fpasswd", "....//secret.map"}) {
        EXPECT_EQ(get(maps + "/" + name).status, 404) << name;
    }
    EXPECT_EQ(get(maps + "/" + std::string(3000, 'a')).status, 404);
    EXPECT_EQ(get(maps + "/leads-out.yaml").status, 422);
}

TEST_F(SafetyTest, HostileMapsAreRefused) {
    options_.limits.map_cells = 100;
    begin();
    const std::string nul(1, '\0');
    for (const std::string& map : {std::string(), std::string("nonsense"), "\xff\xfe" + nul,
                                   std::string("type octile\nheight 1000000\nwidth 1000000\nmap\n"),
                                   std::string("<root><map><width>9</width></map></root>"),
                                   std::string("image: /etc/passwd\nresolution: 1\norigin: [0, 0, 0]\n"),
                                   "II*" + nul + std::string(100, '\x7f')}) {
        EXPECT_EQ(post(maps, map, octets).status, 422) << map.substr(0, 20);
    }
    // What has more cells than allowed, before they are read: there are none.
    EXPECT_EQ(post(maps, "P1 11 11\n", octets).status, 413);
    EXPECT_EQ(post(maps, mapfile::png_bytes(11, 11, std::vector<std::uint8_t>(121)), octets).status, 413);
    EXPECT_EQ(post(maps, std::string(berlin_mitte_tif()), octets).status, 413);
    EXPECT_EQ(post(maps, thicket(11), octets).status, 413);
    EXPECT_EQ(post(maps, thicket(10), octets).status, 201);
}

TEST_F(SafetyTest, LongBodiesAreCutShort) {
    options_.limits.upload_bytes = 1000;
    begin();
    EXPECT_EQ(post(maps, std::string(1001, 'x'), octets).status, 413);
    EXPECT_EQ(post(maps + "/house.map/plan", std::string(2000, ' ') + "{}").status, 413);
    EXPECT_NE(post(maps, std::string(1001, 'x'), octets).body.find("more than 1000 bytes"), std::string::npos);
    // In chunks, without a length.
    std::size_t sent = 0;
    const auto chunks = [&sent](std::size_t, httplib::DataSink& sink) {
        const std::string piece(500, 'x');
        if (sent > 5000) {
            sink.done();
            return true;
        }
        sent += piece.size();
        return sink.write(piece.data(), piece.size());
    };
    const auto answer = client().Post(maps, chunks, octets.c_str());
    EXPECT_TRUE(!answer || answer->status == 413);
    EXPECT_EQ(get("/healthz").status, 200);
}

TEST_F(SafetyTest, DeepOrStrangeJsonIsRefused) {
    begin();
    const std::string plan = maps + "/house.map/plan";
    for (const std::string& body :
         {std::string(), std::string(100000, '['), std::string("{\"mission\":"), std::string("\xff"),
          std::string(R"({"mission": {"start": [1e400, 0]}})"), std::string(R"({"options": {"removals": -1}})"),
          std::string(R"({"options": {"time_limit": 0}})"), std::string(R"({"options": {"weights": [[0, 1]]}})")}) {
        EXPECT_EQ(post(plan, body).status, 400) << body.substr(0, 40);
    }
    EXPECT_EQ(post(plan, R"({"mission": {"start": [1, 3], "goal": [9, 3]}, "options": {"weights": [[7, 1]]}})").status,
              422);
    EXPECT_EQ(post(plan, R"({"mission": {"start": [1, 3], "goal": [9, 3]}, "options": {"protect": [99]}})").status,
              422);
}

TEST_F(SafetyTest, PartsOfAnswersAreNotGiven) {
    begin();
    const auto answer = client().Get("/healthz", {{"Range", "bytes=0-1,0-1,0-1,0-1"}});
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->body, "{\"status\": \"ok\"}\n");
}

}  // namespace
}  // namespace waybreaker::service
