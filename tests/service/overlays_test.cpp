// Floods and closures that clients lay over maps.
#include "city/city_import.hpp"
#include "geotiff/label_tiff.hpp"
#include "live_server.hpp"
#include "osm_yard.hpp"
#include "service/import_worker.hpp"

namespace waybreaker::service {
namespace {

class OverlaysTest : public LiveServer {
  protected:
    // A map of the yard, 100 m around 9, 50.
    std::string yard() const {
        const std::string source =
            Json::parse(post(sources + "?name=yard.osm", osm_yard(), octets).body)["id"].get<std::string>();
        const Json request{{"source", source}, {"center", {9, 50}}, {"size", 100}, {"cell", 2}};
        return Json::parse(post(imports, request.dump()).body)["id"].get<std::string>();
    }
    httplib::Response lay(const std::string& map, const std::string& query, const std::string& data = flood) const {
        return post(maps + "/" + map + "/overlays?" + query, data, octets);
    }

    // The whole window.
    inline static const std::string flood =
        R"({"type":"Feature","properties":{"name":"Flood"},"geometry":{"type":"Polygon","coordinates":)"
        R"([[[8.99,49.99],[9.01,49.99],[9.01,50.01],[8.99,50.01],[8.99,49.99]]]}})";
};

TEST_F(OverlaysTest, MakeTheMapThatTheCommandMakes) {
    begin();
    const std::string map = yard();
    const httplib::Response answer = lay(map, "as=closed&name=rain.geojson");
    EXPECT_EQ(answer.status, 201);
    const Json made = Json::parse(answer.body);
    EXPECT_EQ(answer.get_header_value("Location"), maps + "/" + made["id"].get<std::string>());
    EXPECT_EQ(made["blocked"], 50 * 50);
    EXPECT_EQ(made["title"], "yard, 100 m around 9.0000, 50.0000, rain as closed");
    EXPECT_EQ(lay(map, "as=closed&name=rain.geojson").status, 200);
    const std::string source = put("rain.geojson", flood);
    const std::string file = get(maps + "/" + map + "/file").body;
    geotiff::LabelTiff tiff = geotiff::read_label_tiff(file, "yard.tif");
    site::DescribedMap described{tiff.map, tiff.annotations};
    city::lay_over({.file = source, .use = site::OverlayUse::closed}, *tiff.georeference, {}, described);
    tiff.map = described.map;
    tiff.annotations = described.annotations;
    EXPECT_EQ(get(maps + "/" + made["id"].get<std::string>() + "/file").body, geotiff::label_tiff_bytes(tiff));
}

TEST_F(OverlaysTest, SayWhatWasLeftOutAndWhatIsNotKnown) {
    begin();
    const std::string map = yard();
    const std::string point = R"({"type":"Point","coordinates":[9,50]})";
    const Json refusal = Json::parse(lay(map, "as=debris", point).body);
    EXPECT_EQ(refusal["status"], 422);
    EXPECT_EQ(refusal["detail"],
              "overlay: 1 point is left out; a width makes a disc of it; nothing of it lies on the map");
    EXPECT_GT(Json::parse(lay(map, "as=debris&width=4", point).body)["obstacles"]["tags"]["barrier=debris"], 0);
    const Json doubt = Json::parse(lay(map, "as=water").body)["notes"];
    ASSERT_EQ(doubt.size(), 1U);
    EXPECT_NE(doubt[0].get<std::string>().find("knows no bridges"), std::string::npos);
}

TEST_F(OverlaysTest, AreRefusedWithTheReason) {
    begin();
    const std::string map = yard();
    const auto refused = [&](const httplib::Response& answer, int status, const std::string& kind) {
        EXPECT_EQ(answer.status, status) << answer.body;
        const std::string type = Json::parse(answer.body)["type"].get<std::string>();
        EXPECT_NE(type.find(kind), std::string::npos) << type;
    };
    refused(lay("nowhere", "as=water"), 404, "map-not-found");
    refused(lay(map, ""), 400, "invalid-request");
    refused(lay(map, "as=lava"), 400, "invalid-request");
    for (const char* width : {"", "0", "-1", "nan", "2m", "1e9"}) {
        refused(lay(map, std::string("as=wall&width=") + width), 400, "invalid-request");
    }
    refused(lay(map, "as=water&name=..%2Fx"), 400, "invalid-request");
    refused(lay(map, "as=water", "hello"), 422, "source-unreadable");
    refused(lay(map, "as=water", R"({"type":"Point","coordinates":[392000,5820000]})"), 422, "source-unreadable");
    const std::string plain = Json::parse(post(maps, "type octile\nheight 1\nwidth 2\nmap\n..\n", octets).body)["id"];
    refused(lay(plain, "as=water"), 422, "unfit-request");
}

// Data that names files of the server reads none of them.
TEST_F(OverlaysTest, OpenNothingElse) {
    begin();
    const std::string map = yard();
    const std::string secret = put("secret.geojson", flood);
    const std::string vrt = "<OGRVRTDataSource><OGRVRTLayer name='secret'><SrcDataSource>" + secret +
                            "</SrcDataSource></OGRVRTLayer></OGRVRTDataSource>";
    EXPECT_EQ(lay(map, "as=water", vrt).status, 422);
}

}  // namespace
}  // namespace waybreaker::service
