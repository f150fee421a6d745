waybreaker check yard.map
