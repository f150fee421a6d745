[ $(wc -c < berlin.svg) -lt 200000 ] && [ $(wc -c < berlin.png) -lt 400000 ] && grep -o 'OpenStreetMap contributors' berlin.svg
