// The page: served without a token, cached while unchanged, and allowed to connect to this server only.
#include "live_server.hpp"
#include "studio/studio_files.hpp"

namespace waybreaker::service {
namespace {

class PageTest : public LiveServer {
  protected:
    httplib::Response page(const std::string& path, const httplib::Headers& headers = {}) const {
        httplib::Client asking = client();
        asking.set_decompress(false);
        const auto answer = asking.Get(path, headers);
        EXPECT_TRUE(answer) << path;
        return answer ? *answer : httplib::Response();
    }
};

std::string unpacked(const std::string& packed) {
    std::string bytes;
    httplib::detail::gzip_decompressor unpack;
    EXPECT_TRUE(unpack.decompress(packed.data(), packed.size(), [&bytes](const char* piece, std::size_t size) {
        bytes.append(piece, size);
        return true;
    }));
    return bytes;
}

TEST_F(PageTest, IsServedAsItWasBuilt) {
    options_.token = "secret";
    begin();
    for (const studio::File& file : studio::files()) {
        const std::string path(file.path);
        const httplib::Response plain = page(path);
        EXPECT_EQ(plain.status, 200) << path;
        EXPECT_EQ(plain.body, file.bytes) << path;
        EXPECT_EQ(plain.get_header_value("Content-Type"), file.type);
        EXPECT_FALSE(plain.has_header("Content-Encoding"));
        const httplib::Response packed = page(path, {{"Accept-Encoding", "gzip, br"}});
        EXPECT_EQ(packed.get_header_value("Content-Encoding"), "gzip");
        EXPECT_EQ(unpacked(packed.body), file.bytes) << path;
        for (const httplib::Response& answer : {plain, packed}) {
            EXPECT_EQ(answer.get_header_value("Vary"), "Accept-Encoding");
            EXPECT_EQ(answer.get_header_value("Cache-Control"), "no-cache");
            EXPECT_EQ(answer.get_header_value("X-Content-Type-Options"), "nosniff");
        }
        const auto head = client().Head(path);
        ASSERT_TRUE(head);
        EXPECT_EQ(head->status, 200);
        EXPECT_EQ(head->get_header_value("Content-Length"), std::to_string(file.bytes.size()));
    }
}

TEST_F(PageTest, MayAskThisServerAlone) {
    begin();
    const httplib::Response answer = page("/");
    EXPECT_EQ(answer.get_header_value_count("Content-Security-Policy"), 1U);
    const std::string policy = answer.get_header_value("Content-Security-Policy");
    for (const char* part :
         {"default-src 'none'", "script-src 'self';", "connect-src 'self';", "frame-ancestors 'none'"}) {
        EXPECT_NE(policy.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(policy.find("unsafe"), std::string::npos);
    EXPECT_EQ(page("/", {{"Host", "evil.example"}}).status, 421);
    EXPECT_EQ(page("/..%2fetc/passwd").status, 404);
    EXPECT_EQ(client().Post("/", "x", "text/plain")->status, 405);
}

TEST_F(PageTest, IsSentAnewOnlyIfItHasChanged) {
    begin();
    const std::string tag = page("/").get_header_value("ETag");
    for (const std::string& known : {tag, "\"other\", " + tag, tag.substr(2), std::string("*")}) {
        const httplib::Response answer = page("/", {{"If-None-Match", known}});
        EXPECT_EQ(answer.status, 304) << known;
        EXPECT_EQ(answer.get_header_value("ETag"), tag);
        EXPECT_TRUE(answer.body.empty());
        EXPECT_FALSE(answer.has_header("Content-Length"));
    }
    EXPECT_EQ(page("/", {{"If-None-Match", "\"other\""}}).status, 200);
}

}  // namespace
}  // namespace waybreaker::service
