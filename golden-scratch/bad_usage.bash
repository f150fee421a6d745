waybreaker plan yard.map --start 1,5 --goal 22,5 --planner jps --moves 4
