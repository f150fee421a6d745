waybreaker plan yard.map --start 1,5 --goal 22,5 --no-timing --svg - | tail -n 1
