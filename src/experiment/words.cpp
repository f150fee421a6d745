#include "experiment/words.hpp"

namespace waybreaker::experiment {
namespace {

template <class Value, std::size_t count>
std::string_view word_of(const std::array<Word<Value>, count>& words, Value value) {
    return std::ranges::find(words, value, &Word<Value>::value)->word;
}

}  // namespace

std::string_view word_for(Method method) {
    return word_of(method_words, method);
}

std::string_view word_for(Planner planner) {
    return word_of(planner_words, planner);
}

std::string_view word_for(ResultStatus status) {
    return word_of(status_words, status);
}

}  // namespace waybreaker::experiment
