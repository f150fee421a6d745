#include "mapfile/digest.hpp"

#include <openssl/evp.h>

#include <array>
#include <cassert>

namespace waybreaker::mapfile {

std::string sha256_digest(std::string_view bytes) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
    unsigned size = 0;
    [[maybe_unused]] const int done =
        EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr);
    assert(done == 1);
    std::string text = "sha256:";
    for (unsigned i = 0; i < size; ++i) {
        text += "0123456789abcdef"[digest[i] / 16];
        text += "0123456789abcdef"[digest[i] % 16];
    }
    return text;
}

}  // namespace waybreaker::mapfile
