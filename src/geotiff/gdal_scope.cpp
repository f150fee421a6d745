#include "geotiff/gdal_scope.hpp"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include "core/one_line.hpp"

namespace waybreaker::geotiff {
namespace {

void CPL_STDCALL on_error(CPLErr severity, CPLErrorNum, const char* message) {
    auto* scope = static_cast<GdalScope*>(CPLGetErrorHandlerUserData());
    if (severity >= CE_Failure) scope->remember(message);
}

}  // namespace

GdalScope::GdalScope() {
    CPLPushErrorHandlerEx(on_error, this);
    set_option("GDAL_PAM_ENABLED", "NO");
    set_option("CPL_VSIL_GZIP_WRITE_PROPERTIES", "NO");
}

GdalScope::~GdalScope() {
    for (const auto& [name, former] : former_options_) {
        CPLSetThreadLocalConfigOption(name, former ? former->c_str() : nullptr);
    }
    CPLPopErrorHandler();
}

void GdalScope::set_option(const char* name, const char* value) {
    const char* former = CPLGetThreadLocalConfigOption(name, nullptr);
    former_options_.emplace_back(name, former ? std::optional<std::string>(former) : std::nullopt);
    CPLSetThreadLocalConfigOption(name, value);
}

void GdalScope::remember(const char* message) {
    if (failed()) return;
    failure_ = one_line(message);
    if (failure_.empty()) failure_ = "unknown cause";
}

std::string GdalScope::failure() const {
    return failed() ? failure_ : "unknown cause";
}

// The object's address makes the name unique.
MemoryFile::MemoryFile() : path_(fmt::format("/vsimem/waybreaker/{}.tif", fmt::ptr(this))) {}

MemoryFile::MemoryFile(std::string_view bytes) : MemoryFile() {
    auto* data = reinterpret_cast<GByte*>(const_cast<char*>(bytes.data()));
    VSIFCloseL(VSIFileFromMemBuffer(path_.c_str(), data, bytes.size(), FALSE));
}

MemoryFile::~MemoryFile() {
    VSIUnlink(path_.c_str());
}

std::string MemoryFile::bytes() const {
    vsi_l_offset size = 0;
    const GByte* data = VSIGetMemFileBuffer(path_.c_str(), &size, FALSE);
    return data ? std::string(reinterpret_cast<const char*>(data), size) : std::string();
}

std::string MemoryFile::nameless(std::string message) const {
    for (const std::string& name : {"`" + path_ + "'", path_}) {
        for (std::size_t at; (at = message.find(name)) != std::string::npos;) message.replace(at, name.size(), "it");
    }
    return message;
}

}  // namespace waybreaker::geotiff
