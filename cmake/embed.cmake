# What waybreaker_embed runs: OUTPUT, NAMESPACE, SYMBOLS and FILES as there.
set(source "// Made by the build.\n#include <string_view>\n\nnamespace ${NAMESPACE} {\n")
foreach(symbol file IN ZIP_LISTS SYMBOLS FILES)
  file(READ ${file} bytes HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  string(APPEND source "std::string_view ${symbol}();\nstd::string_view ${symbol}() {\n    static constexpr char bytes[] = {${bytes}'\\0'};\n    return {bytes, sizeof bytes - 1};\n}\n")
endforeach()
file(WRITE ${OUTPUT} "${source}}  // namespace ${NAMESPACE}\n")
