waybreaker plan yard.map --start 1,5 --goal 22,5 --air-start 7,3 --no-timing | grep 'air agent'
