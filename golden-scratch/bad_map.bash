waybreaker map info $'no\nsuch.map'
