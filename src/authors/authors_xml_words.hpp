// The words of the authors' XML for search options.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "waybreaker/search_options.hpp"

namespace waybreaker::authors {

template <class Value, std::size_t n>
using XmlWords = std::array<std::pair<std::string_view, Value>, n>;

inline constexpr XmlWords<Algorithm, 5> xml_planners{{{"theta", Algorithm::theta},
                                                      {"astar", Algorithm::astar},
                                                      {"jp_search", Algorithm::jps},
                                                      {"dijkstra", Algorithm::dijkstra},
                                                      {"bfs", Algorithm::bfs}}};
inline constexpr XmlWords<std::optional<Heuristic>, 4> xml_heuristics{{{"diagonal", Heuristic::octile},
                                                                       {"manhattan", Heuristic::manhattan},
                                                                       {"euclid", Heuristic::euclidean},
                                                                       {"chebyshev", Heuristic::chebyshev}}};
inline constexpr XmlWords<TieBreak, 2> xml_ties{{{"g-max", TieBreak::g_max}, {"g-min", TieBreak::g_min}}};

}  // namespace waybreaker::authors
