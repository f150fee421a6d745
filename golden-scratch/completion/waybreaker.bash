# bash completion for waybreaker; made by `waybreaker completion bash`
_waybreaker_offer() {
    mapfile -t COMPREPLY < <(compgen -W "$1" -- "$2")
}
_waybreaker() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} path=waybreaker
    local word options words
    COMPREPLY=()
    # --option=value comes as three words
    if [[ $current == "=" ]]; then
        current=
    elif [[ $previous == "=" ]]; then
        previous=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
        case "$path $word" in
        "waybreaker plan" | "waybreaker check" | "waybreaker import" | "waybreaker map" | "waybreaker completion" | "waybreaker manual" | "waybreaker map info") path+=" $word" ;;
        esac
    done
    case "$path $previous" in
    "waybreaker plan --start") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --goal") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --air-start") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --air-goal") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --ground-speed") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --air-speed") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --breach-time") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --breach-time-per-cell") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --protect") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --connectivity") _waybreaker_offer "4 8" "$current"; return ;;
    "waybreaker plan --cell-size") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan -n") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --removals") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --select") _waybreaker_offer "exact hits" "$current"; return ;;
    "waybreaker plan --budget") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --time-limit") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --flight") _waybreaker_offer "optimal nearest" "$current"; return ;;
    "waybreaker plan --timing") _waybreaker_offer "enforce ignore" "$current"; return ;;
    "waybreaker plan --objective") _waybreaker_offer "makespan flowtime" "$current"; return ;;
    "waybreaker plan --planner") _waybreaker_offer "theta lazy-theta astar jps dijkstra bfs optimal" "$current"; return ;;
    "waybreaker plan --heuristic") _waybreaker_offer "euclidean octile chebyshev manhattan zero" "$current"; return ;;
    "waybreaker plan --weight") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --tie-break") _waybreaker_offer "g-max g-min" "$current"; return ;;
    "waybreaker plan --corners") _waybreaker_offer "none cut squeeze" "$current"; return ;;
    "waybreaker plan --radius") _waybreaker_offer "" "$current"; return ;;
    "waybreaker plan --moves") _waybreaker_offer "8 4" "$current"; return ;;
    "waybreaker plan --expansion-limit") _waybreaker_offer "" "$current"; return ;;
    "waybreaker check --tolerance") _waybreaker_offer "" "$current"; return ;;
    "waybreaker import --center") _waybreaker_offer "" "$current"; return ;;
    "waybreaker import --size") _waybreaker_offer "" "$current"; return ;;
    "waybreaker import --cell") _waybreaker_offer "" "$current"; return ;;
    "waybreaker map info --connectivity") _waybreaker_offer "4 8" "$current"; return ;;
    esac
    case "$path" in
    "waybreaker") options="--version -h --help" words="plan check import map completion manual" ;;
    "waybreaker plan") options="-h --help --start --goal --air-start --air-goal --ground-speed --air-speed --breach-time --breach-time-per-cell --protect --connectivity --cell-size --paper -n --removals --select --budget --weights --time-limit --bound --explain --flight --timing --objective --planner --heuristic --weight --tie-break --corners --radius --moves --expansion-limit --json --svg --png --trace --no-timing" words="" ;;
    "waybreaker check") options="-h --help --json --ignore-digest --tolerance" words="" ;;
    "waybreaker import") options="-h --help --center --size --cell --merge-touching -o --output" words="" ;;
    "waybreaker map") options="-h --help" words="info" ;;
    "waybreaker completion") options="-h --help" words="bash zsh fish" ;;
    "waybreaker manual") options="-h --help" words="" ;;
    "waybreaker map info") options="-h --help --connectivity --json" words="" ;;
    esac
    if [[ $current == -* ]]; then words=$options; fi
    _waybreaker_offer "$words" "$current"
}
complete -o default -F _waybreaker waybreaker
