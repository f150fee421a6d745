waybreaker map info free.map
