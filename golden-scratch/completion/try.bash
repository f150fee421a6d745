source ./waybreaker.bash
COMP_WORDS=("$@")
COMP_CWORD=$(($# - 1))
_waybreaker
echo "${COMPREPLY[@]}"
