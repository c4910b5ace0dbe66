3.1
Out of reach without bounds
PTP F4 1E308 -1E308 0
END
