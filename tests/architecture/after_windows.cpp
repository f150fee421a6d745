// The public headers, after the macros that windows.h makes unless it is asked not to. The standard headers come first:
// those of the compilers for Windows know these macros, those of the others do not.
#include <array>
#include <atomic>
#include <cassert>
#include <chrono>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <istream>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define near
#define far
#define small char
#define interface struct
#define IN
#define OUT
#define OPTIONAL
#define ERROR 0
#define DELETE (0x00010000L)
#define TRUE 1
#define FALSE 0
#define VOID void
#define CALLBACK
#define PASCAL
#define STRICT 1
#define hyper
#define uuid

#include "waybreaker/advanced.hpp"
#include "waybreaker/waybreaker.hpp"
