waybreaker completion fish | grep -c -- '-l tie-break'
