waybreaker plan missing.map 2>&-
