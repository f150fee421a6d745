// `waybreaker site`: the page as a folder of files that plans without a server.
#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "commands.hpp"
#include "help.hpp"
#include "io/output_file.hpp"
#include "option.hpp"
#include "page_planner.hpp"
#include "progress.hpp"
#include "service/static_site.hpp"
#include "waybreaker/error.hpp"

namespace waybreaker::apps {
namespace {

namespace fs = std::filesystem;

struct SiteOptions {
    std::string folder;
    std::string maps;
    std::string wasm;
};

// A folder that may be replaced: none, an empty one, or an earlier site.
void require_replaceable(const fs::path& folder) {
    std::error_code error;
    const fs::file_status status = fs::status(folder, error);
    if (!fs::exists(status)) return;
    if (!fs::is_directory(status)) throw InputError(folder.string() + ": is no folder");
    if (fs::is_empty(folder, error) || (fs::exists(folder / "maps.json") && fs::exists(folder / "studio.wasm"))) return;
    throw InputError(folder.string() + ": holds other files than a site; give a new folder");
}

// Beside the folder, so that what it holds can be renamed; goes away at the end.
class Workshop {
  public:
    explicit Workshop(const fs::path& folder) {
        const fs::path beside = fs::absolute(folder).parent_path();
        fs::create_directories(beside);
        path_ = (beside / ".site-XXXXXX").string();
        if (mkdtemp(path_.data()) == nullptr) {
            throw fs::filesystem_error("cannot make", path_, std::error_code(errno, std::generic_category()));
        }
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;
    ~Workshop() {
        std::error_code error;
        fs::remove_all(path_, error);
    }
    fs::path path(const std::string& name) const { return fs::path(path_) / name; }

  private:
    std::string path_;
};

void write(const std::vector<service::SiteFile>& files, const fs::path& folder) try {
    const Workshop workshop(folder);
    const fs::path made = workshop.path("new");
    const fs::path old = workshop.path("old");
    fs::create_directories(made / "maps");
    for (const service::SiteFile& file : files) io::write_whole((made / file.path).string(), file.bytes);
    const bool was_there = fs::exists(folder);
    if (was_there) fs::rename(folder, old);
    std::error_code error;
    fs::rename(made, folder, error);
    if (!error) return;
    if (was_there) fs::rename(old, folder);
    throw fs::filesystem_error("cannot rename", made, folder, error);
} catch (const fs::filesystem_error& error) {
    throw InputError(fmt::format("cannot write {}: {}", folder.string(), error.code().message()));
}

void run(const SiteOptions& options) {
    fs::path folder = fs::path(options.folder).lexically_normal();
    if (!folder.has_filename()) folder = folder.parent_path();  // "site/"
    require_replaceable(folder);
    const std::string wasm = page_planner(options.wasm);
    std::vector<service::SiteFile> files;
    {
        const Progress progress("reading maps");
        files = service::static_site(options.maps, wasm);
    }
    write(files, folder);
}

}  // namespace

void setup_site(CLI::App& root, Run& run_chosen) {
    auto options = std::make_shared<SiteOptions>();
    CLI::App* command = root.add_subcommand(
        "site",
        "Write the page as a folder that plans without a server\n\n"
        "Any host of files serves it, from any address. The page plans in the browser, and works without a network "
        "once it was open. What it cannot do is said there: import map data, and lay data over maps. The folder is "
        "written whole or not at all; an earlier site there is replaced. The same maps give the same bytes.");
    command->add_option("DIR", options->folder, "The folder to write")->required()->type_name("DIR");
    add_file(*command, "--maps", options->maps, "A folder of maps to show, beside those that are built in", "FOLDER");
    add_file(*command, "--wasm", options->wasm,
             "The planner: studio.wasm of the preset wasm (default: the one that is built in)");
    set_examples(*command,
                 {"waybreaker site public --maps data", "waybreaker site public && python3 -m http.server -d public"});
    command->callback([options, &run_chosen] { run_chosen = [options] { run(*options); }; });
}

}  // namespace waybreaker::apps
