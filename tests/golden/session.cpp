#include "session.hpp"

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

namespace waybreaker::golden {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    return bytes.str();
}

std::string marked(const std::string& mark, const std::string& bytes) {
    std::string out;
    std::istringstream lines(bytes);
    for (std::string line; std::getline(lines, line);) {
        out += mark;
        if (!line.empty()) out += " ";
        out += line;
        out += lines.eof() ? "<no newline>\n" : "\n";
    }
    return out;
}

}  // namespace

Session read_session(const std::filesystem::path& file) {
    Session session;
    std::string prose;
    std::istringstream lines(bytes_of(file));
    for (std::string line; std::getline(lines, line);) {
        const char mark = line.empty() ? ' ' : line.front();
        const bool running = !session.steps.empty() && prose.empty();
        if (mark == '$') session.steps.push_back({.prose = std::exchange(prose, ""), .command = "", .result = ""});
        if (mark == '$' || (mark == '>' && running)) {
            session.steps.back().command += (line.size() > 2 ? line.substr(2) : "") + "\n";
        } else if ((mark == '|' || mark == '!' || mark == '=') && running) {
            session.steps.back().result += line + "\n";
        } else {
            prose += line + "\n";
        }
    }
    session.epilogue = prose;
    return session;
}

void write_session(const std::filesystem::path& file, const Session& session) {
    std::ofstream out(file, std::ios::binary);
    for (const Step& step : session.steps) {
        std::string command = marked(">", step.command);
        command.front() = '$';
        out << step.prose << command << step.result;
    }
    out << session.epilogue;
}

std::string run(const Step& step, const std::filesystem::path& folder, const std::filesystem::path& command_folder) {
    const std::filesystem::path script = folder.string() + ".bash";
    const std::filesystem::path output = folder.string() + ".stdout";
    const std::filesystem::path error = folder.string() + ".stderr";
    std::ofstream(script, std::ios::binary) << step.command;
    const std::string line = "cd '" + folder.string() + "' && PATH='" + command_folder.string() +
                             "':\"$PATH\" LC_ALL=C.UTF-8 bash '" + script.string() + "' </dev/null >'" +
                             output.string() + "' 2>'" + error.string() + "'";
    const int status = std::system(line.c_str());
    std::string result = marked("|", bytes_of(output)) + marked("!", bytes_of(error));
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    if (code != 0) result += "= " + std::to_string(code) + "\n";
    return result;
}

}  // namespace waybreaker::golden
