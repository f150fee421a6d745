# Toolchain: clang 16 and Debian's libc and C++ library for WebAssembly (packages.txt, [wasm]). No threads, no files.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-16)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR llvm-ar-16)
set(CMAKE_RANLIB llvm-ranlib-16)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

# Debian's libraries are compiled without exceptions: src/wasm/ has the little that throwing needs.
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -DWAYBREAKER_NO_THREADS")

# fmt and nlohmann/json, headers only: Debian's own are compiled for another machine.
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR}/wasm)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY NEVER)
