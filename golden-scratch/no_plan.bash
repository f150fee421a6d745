waybreaker plan yard.map --start 1,5 --goal 22,5 --select hits --expansion-limit 3
