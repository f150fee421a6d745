mandoc -T ascii man/waybreaker-map-info.1 | sed 's/.\x08//g' | head -n -2
